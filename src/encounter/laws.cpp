// What is known of an encounter in closed form, or computed for all ratios of the radii.
#include <string>

#include "encounter/participant.hpp"

namespace stoss {

Mixture mixture(const Encounter& encounter) {
  validate(encounter);
  const Solid first = first_solid(encounter);
  const auto second = second_solid(encounter);
  const bool rigid = encounter.first.rigid || encounter.against.rigid;
  if (second && !rigid && std::holds_alternative<Disk>(first) && std::holds_alternative<Disk>(*second)) {
    return mixture(std::get<Disk>(first), std::get<Disk>(*second));
  }
  if (second && !rigid && std::holds_alternative<Sphere>(first) && std::holds_alternative<Sphere>(*second)) {
    return mixture(std::get<Sphere>(first), std::get<Sphere>(*second));
  }
  throw InvalidInput("ratio: got a " + std::string(rigid ? "rigid " : "") + encounter.first.kind + " against " +
                     encounter.against.kind + ", allowed elastic disks or spheres that meet each other");
}

SlowLaw slow_law(const Encounter& encounter) {
  validate(encounter);
  const Solid first = first_solid(encounter);
  const auto second = second_solid(encounter);
  const bool rigid = encounter.first.rigid, elastic = !rigid && !encounter.against.rigid;
  if (const auto* ball = std::get_if<Sphere>(&first)) {
    if (!second && elastic) return slow_law(*ball);
    if (second && std::holds_alternative<HalfSpace>(*second))
      return slow_law(*ball, std::get<HalfSpace>(*second), rigid);
    if (second && elastic) return slow_law(*ball, std::get<Sphere>(*second));
  }
  if (const auto* disk = std::get_if<Disk>(&first); disk != nullptr && elastic) {
    if (!second) return slow_law(*disk);
    if (std::holds_alternative<Disk>(*second)) return slow_law(*disk, std::get<Disk>(*second));
  }
  throw InvalidInput("beyond: got 'law', allowed 'error' or 'clamp' (there is no law of slow impacts of these bodies)");
}

}  // namespace stoss
