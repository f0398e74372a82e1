#pragma once

#include "stoss/impact/impact.hpp"

namespace stoss {

/// Steps and contact grid of an impact.
struct FixedResolution {
  double half_width;  ///< of the contact grid, R
  double step;        ///< R/c
  int nodes;
};

/// The resolution that the options ask for, with the recommended values for what they leave open.
/// @throws InvalidInput for a speed, and options, out of range
[[nodiscard]] FixedResolution fix(const Contact& contact, double speed, const ImpactOptions& options);

/// A wider grid of the same node spacing, at most as wide as the edge that can touch.
[[nodiscard]] FixedResolution widened(const Contact& contact, const FixedResolution& resolution);

}  // namespace stoss
