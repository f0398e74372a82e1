// A body of a material that relaxes, with all that is made from it.
#include <utility>
#include <vector>

#include "stoss/body/body.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using Bodies = std::function<std::vector<Body>(double other)>;

/// Others of the same material in units of their own.
Bodies relaxing_others(const Bodies& others, const BodyScale& scale, const Relaxation& relaxation) {
  if (!others) return others;
  return [others, scale, relaxation](double curvature) {
    std::vector<Body> bodies;
    for (const Body& each : others(curvature)) {
      const double unit = (each.scale.length / each.scale.speed) / (scale.length / scale.speed);
      bodies.push_back(relaxing(each, in_time(relaxation, 1.0 / unit)));
    }
    return bodies;
  };
}

}  // namespace

Body relaxing(const Body& body, const Relaxation& relaxation) {
  validate(relaxation);
  if (relaxation.terms.empty()) return body;
  if (body.loss_time > 0.0) {
    throw InvalidInput::conflict("relaxation", "'" + body.name + "' has a loss_time too", "give one of both");
  }
  if (!body.layers.empty()) {
    throw InvalidInput::conflict("relaxation", "the layers of '" + body.name + "' have losses of their own",
                                 "give one of both");
  }
  if (body.softness == 0.0) {
    throw InvalidInput::conflict("relaxation", "'" + body.name + "' is rigid, and relaxes nothing", "leave it out");
  }
  Body result = body;
  result.relaxation = relaxation;
  const auto relaxed = [relaxation](const Body& each) { return relaxing(each, relaxation); };
  if (body.near_side) {
    result.near_side = [relaxed, side = body.near_side](double size, double cutoff, const Poll& poll) {
      return relaxed(side(size, cutoff, poll));
    };
  }
  if (body.along) {
    result.along = [relaxed, along = body.along](const Poll& poll) {
      std::vector<Body> bodies;
      for (const Body& each : along(poll)) bodies.push_back(relaxed(each));
      return bodies;
    };
  }
  if (body.outward) {
    result.outward = [relaxed, outward = body.outward](const Poll& poll) { return relaxed(outward(poll)); };
  }
  result.known.alternatives = relaxing_others(body.known.alternatives, body.scale, relaxation);
  result.known.alternatives_along = relaxing_others(body.known.alternatives_along, body.scale, relaxation);
  return result;
}

BodyMaker relaxing(const BodyMaker& maker, const Relaxation& relaxation) {
  validate(relaxation);
  if (relaxation.terms.empty()) return maker;
  return [maker, relaxation](double cutoff, const Poll& poll) { return relaxing(maker(cutoff, poll), relaxation); };
}

}  // namespace stoss
