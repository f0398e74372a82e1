#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "stoss/bodies/rod.hpp"
#include "stoss/vibration/rod_chain.hpp"

namespace stoss {

/// Velocities drawn from Maxwell's distribution, each normal with the mean square temperature/mass, less the velocity
/// of their centre of mass. The same for the same seed.
/// @param temperature twice the mean kinetic energy of a rod, 0 to 1e100
/// @throws InvalidInput for arguments out of range
[[nodiscard]] std::vector<double> thermal_velocities(std::span<const Rod> rods, double temperature, std::uint64_t seed);

/// What was seen of a chain: all collisions, and samples at the start, after each of the first fifty, then 2 % apart in
/// the number of collisions, and at the end.
struct RodChainRecord {
  std::vector<RodCollision> collisions;
  std::vector<RodChainSample> samples;
};

/// Runs a chain for a number of collisions or up to a time, whichever comes first, and appends what is seen.
/// @param collisions 0 to 1e9
/// @param time       not before the chain's own, may be infinite
/// @throws InvalidInput for arguments out of range; NotConverged as RodChain::collide. What is done is in the record.
void run(RodChain& chain, RodChainRecord& record, long collisions,
         double time = std::numeric_limits<double>::infinity());

}  // namespace stoss
