#include "stoss/encounter/laws.hpp"

#include <string>
#include <variant>

#include "encounter/participant.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "stoss/encounter/roughness.hpp"
#include "stoss/errors.hpp"

namespace stoss {

Mixture mixture(const Encounter& encounter) {
  validate(encounter);
  refuse_relaxing(encounter, "a table of pairs");
  refuse_rough(encounter, "a table of pairs");
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

SlowLaw slow_law(const Solid& first, const std::optional<Solid>& second, const SlowSides& sides) {
  const auto& [rigid, second_rigid, relaxation, second_relaxation] = sides;
  if (second_rigid) {
    throw InvalidInput::out_of_range("beyond", "law", "error or clamp", "there is none with a rigid second body");
  }
  const auto* ball = std::get_if<Sphere>(&first);
  const auto* disk = std::get_if<Disk>(&first);
  const auto* block = second ? std::get_if<HalfSpace>(&*second) : nullptr;
  const auto* other_ball = second ? std::get_if<Sphere>(&*second) : nullptr;
  const auto* other_disk = second ? std::get_if<Disk>(&*second) : nullptr;
  if (!relaxation.terms.empty() || !second_relaxation.terms.empty()) {
    if (!rigid && ball != nullptr && !second) return slow_law(*ball, relaxation);
    if (!rigid && ball != nullptr && other_ball != nullptr && relaxation == second_relaxation) {
      return slow_law(*ball, *other_ball, relaxation);
    }
    throw InvalidInput::conflict("relaxation",
                                 "the law of slow impacts knows materials that relax of a sphere at a wall or against "
                                 "its equal only",
                                 "give a loss_time; 0: no loss");
  }
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
  refuse_rough(encounter, "the law of slow impacts");
  const Participant& met = encounter.against.kind == "same" ? encounter.first : encounter.against;
  const Solid first = first_solid(encounter);
  const std::optional<Solid> second = second_solid(encounter);
  SlowSides sides{encounter.first.rigid, encounter.against.rigid};
  sides.relaxation = relaxation_of(encounter, encounter.first, first);
  if (second) sides.second_relaxation = relaxation_of(encounter, met, *second);
  return slow_law(first, second, sides);
}

}  // namespace stoss
