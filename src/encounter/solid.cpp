#include "stoss/encounter/solid.hpp"

namespace stoss {
namespace {

struct Make {
  BodyMaker operator()(const Disk& value) const { return disk(value); }
  BodyMaker operator()(const Sphere& value) const { return sphere(value); }
  BodyMaker operator()(const HollowSphere& value) const { return hollow_sphere(value); }
  BodyMaker operator()(const Rod& value) const { return rod(value); }
  BodyMaker operator()(const HalfSpace& value) const { return half_space(value); }
  BodyMaker operator()(const HalfPlane& value) const { return half_plane(value); }
  BodyMaker operator()(const Plate& value) const { return plate(value); }
  BodyMaker operator()(const ModalBody& value) const { return modal_body(value); }
  BodyMaker operator()(const Strip& value) const { return strip(value); }
};

}  // namespace

BodyMaker maker(const Solid& solid) { return std::visit(Make{}, solid); }

BodyMaker maker(const Solid& solid, const Relaxation& relaxation) {
  BodyMaker elastic = maker(solid);
  if (relaxation.terms.empty()) return elastic;
  validate(relaxation);
  return [elastic, relaxation](double cutoff, const Poll& poll) {
    const Body body = elastic(cutoff, poll);
    return relaxing(body, in_time(relaxation, body.scale.speed / body.scale.length));
  };
}

}  // namespace stoss
