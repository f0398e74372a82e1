#pragma once

#include <functional>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/ladder.hpp"

namespace stoss {

/// Bodies of any ratio of radii and two materials, or one.
struct Mixture {
  std::function<RefinableContact(double ratio)> contact;  ///< ratio: radius of the second over that of the first
  bool alike = false;                                     ///< of one material: exchanging the two changes nothing
};

/// Disks of the materials of two; speeds in c of the first. Their radii do not count: of elastic disks ε depends on the
/// ratio of the radii alone. @throws InvalidInput as `disk`, and for a loss time, with which it depends on them
[[nodiscard]] Mixture mixture(const Disk& first, const Disk& second);
[[nodiscard]] Mixture mixture(const Disk& disk);

/// Spheres of the materials of two; speeds in c of the first. @throws InvalidInput as above
[[nodiscard]] Mixture mixture(const Sphere& first, const Sphere& second);
[[nodiscard]] Mixture mixture(const Sphere& sphere);

}  // namespace stoss
