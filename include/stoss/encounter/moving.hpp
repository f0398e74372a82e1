#pragma once

#include <optional>

#include "stoss/encounter/encounter.hpp"
#include "stoss/table/collide.hpp"

namespace stoss {

/// Masses, moments of inertia and radii of those who meet, at rest, for collide: of homogeneous disks and spheres, in
/// units of the first; what does not move, as a wall, has 0.
struct MovingPair {
  MovingBody<3> first, second;

  /// The same bodies of other radii, in units of the first: mass goes with R^dimension.
  [[nodiscard]] MovingPair resized(double radius, double second_radius) const;

  int dimension = 3;  ///< 2 of disks
};

/// @throws InvalidInput as validate, and for rods
[[nodiscard]] MovingPair moving_pair(const Encounter& encounter);

}  // namespace stoss
