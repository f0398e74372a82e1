#pragma once

#include <utility>

#include "stoss/impact/replay.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// What is inside a disk or a sphere at one instant: the displacement as far as its material has crept, and of the
/// modes that are not kept the stress that bears the forces.
/// @param within a DiskField or a SphereField of the body
template <typename Inside>
auto field_of(const Inside& within, const BodyFrame& seen, const Poll& poll) {
  auto now = within.at(seen.coordinate, seen.node_force, poll);
  if (seen.crept_force == seen.node_force) return now;
  auto crept = within.at(seen.coordinate, seen.crept_force, poll);
  now.radial = std::move(crept.radial);
  now.tangential = std::move(crept.tangential);
  return now;
}

}  // namespace stoss
