#pragma once

#include <string>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/restitution/oblique.hpp"

namespace validate {

/// An oblique impact: two bodies, in units of the first, and how they meet.
struct ObliqueCase {
  std::string body;         ///< disk or sphere
  std::string against;      ///< wall, body, or half-space
  double poisson = 0.0;     ///< of the first body
  double loss_time = 0.0;   ///< of the first body
  stoss::Disk second{};     ///< what it meets, a sphere at a sphere; of a half-space the material
  double speed = 0.0;       ///< v_n
  stoss::Obliquity before;  ///< a spin only of the first

  /// s
  [[nodiscard]] double sliding() const { return before.tangential + before.spin; }
};

/// What meets.
stoss::RefinableContact contact_of(const ObliqueCase& its);

/// An oblique impact with reference values; their `error` is the uncertainty.
struct ObliquePoint {
  ObliqueCase its;
  stoss::Estimate restitution, sliding_after;
};

/// Those of validate/data/reference_oblique.csv. @throws std::runtime_error as read_points
std::vector<ObliquePoint> read_oblique();

}  // namespace validate
