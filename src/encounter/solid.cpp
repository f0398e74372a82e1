#include "stoss/encounter/solid.hpp"

#include "stoss/errors.hpp"

namespace stoss {
namespace {

struct Make {
  BodyMaker operator()(const Disk& value) const { return disk(value); }
  BodyMaker operator()(const Sphere& value) const { return sphere(value); }
  BodyMaker operator()(const Rod& value) const { return rod(value); }
  BodyMaker operator()(const HalfSpace& value) const { return half_space(value); }
  BodyMaker operator()(const HalfPlane& value) const { return half_plane(value); }
};

}  // namespace

BodyMaker maker(const Solid& solid) { return std::visit(Make{}, solid); }

SlowLaw slow_law(const Solid& first, const std::optional<Solid>& second, bool rigid, bool second_rigid) {
  if (second_rigid) {
    throw InvalidInput("beyond: got law, allowed error or clamp (there is none with a rigid second body)");
  }
  const auto* ball = std::get_if<Sphere>(&first);
  const auto* disk = std::get_if<Disk>(&first);
  const auto* block = second ? std::get_if<HalfSpace>(&*second) : nullptr;
  const auto* other_ball = second ? std::get_if<Sphere>(&*second) : nullptr;
  const auto* other_disk = second ? std::get_if<Disk>(&*second) : nullptr;
  if (ball != nullptr && block != nullptr) return slow_law(*ball, *block, rigid);
  if (!rigid && ball != nullptr && !second) return slow_law(*ball);
  if (!rigid && disk != nullptr && !second) return slow_law(*disk);
  if (!rigid && ball != nullptr && other_ball != nullptr) return slow_law(*ball, *other_ball);
  if (!rigid && disk != nullptr && other_disk != nullptr) return slow_law(*disk, *other_disk);
  throw InvalidInput("beyond: got law, allowed error or clamp (there is no law of slow impacts of these bodies)");
}

}  // namespace stoss
