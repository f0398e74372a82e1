// Normal numbers √(−2 ln u₁) cos 2πu₂ (Box and Muller 1958).
#include <cmath>
#include <numbers>

#include "check.hpp"
#include "numeric/random.hpp"
#include "stoss/vibration/rod_chain.hpp"
#include "vibration/rod_vibrations.hpp"

namespace stoss {

std::vector<double> thermal_velocities(std::span<const Rod> rods, double temperature, std::uint64_t seed) {
  require("temperature", temperature, {0.0, 1e100, true, true, "0 to 1e100"}, "twice the mean kinetic energy of a rod");
  std::vector<double> velocities;
  double mass = 0.0, momentum = 0.0;
  for (const Rod& rod : rods) {
    static_cast<void>(scales(rod));  // refuses what is out of range
    const RodMeasures measures(rod);
    const auto [first, second] = numeric::uniform(seed, {static_cast<std::uint32_t>(velocities.size())});
    const double normal = std::sqrt(-2.0 * std::log(first)) * std::cos(2.0 * std::numbers::pi * second);
    velocities.push_back(std::sqrt(temperature / measures.mass) * normal);
    mass += measures.mass;
    momentum += measures.mass * velocities.back();
  }
  for (double& each : velocities) each -= momentum / mass;
  return velocities;
}

}  // namespace stoss
