#pragma once

#include "stoss/impact/impact.hpp"

namespace stoss {

/// Steps and contact grid of an impact.
struct Resolution {
  double half_width;  ///< of the contact grid, R
  double step;        ///< R/c
  int nodes;
};

/// The resolution that the options ask for, with the recommended values for what they leave open.
/// @throws InvalidInput for options out of range
[[nodiscard]] Resolution choose_resolution(const Contact& contact, double speed, const ImpactOptions& options);

/// Resolution of an impact at a hard wall for `restitution`: finer in time and in space with the
/// cutoff.
/// @param half_width greatest one of the contact in a coarser run, or 0 if there was none
[[nodiscard]] ImpactOptions refined_resolution(const Contact& contact, double speed, double half_width);

/// A wider grid of the same node spacing, at most as wide as the edge that can touch.
[[nodiscard]] Resolution widened(const Contact& contact, const Resolution& resolution);

}  // namespace stoss
