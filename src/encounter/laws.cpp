#include "stoss/encounter/laws.hpp"

#include <string>
#include <variant>

#include "stoss/encounter/relaxing.hpp"
#include "stoss/errors.hpp"

namespace stoss {

Mixture mixture(const Encounter& encounter) {
  validate(encounter);
  refuse_relaxing(encounter, "a table of pairs");
  const Solid first = first_solid(encounter);
  const auto second = second_solid(encounter);
  const bool rigid = encounter.first.rigid || encounter.against.rigid;
  if (second && !rigid && std::holds_alternative<Disk>(first) && std::holds_alternative<Disk>(*second)) {
    return mixture(std::get<Disk>(first), std::get<Disk>(*second));
  }
  if (second && !rigid && std::holds_alternative<Sphere>(first) && std::holds_alternative<Sphere>(*second)) {
    return mixture(std::get<Sphere>(first), std::get<Sphere>(*second));
  }
  throw InvalidInput::out_of_range(
      "ratio", "a " + std::string(rigid ? "rigid " : "") + encounter.first.kind + " against " + encounter.against.kind,
      "elastic disks or spheres that meet each other");
}

SlowLaw slow_law(const Solid& first, const std::optional<Solid>& second, bool rigid, bool second_rigid) {
  if (second_rigid) {
    throw InvalidInput::out_of_range("beyond", "law", "error or clamp", "there is none with a rigid second body");
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
  throw InvalidInput::out_of_range("beyond", "law", "error or clamp",
                                   "there is no law of slow impacts of these bodies");
}

SlowLaw slow_law(const Encounter& encounter) {
  validate(encounter);
  refuse_relaxing(encounter, "the law of slow impacts");
  return slow_law(first_solid(encounter), second_solid(encounter), encounter.first.rigid, encounter.against.rigid);
}

}  // namespace stoss
