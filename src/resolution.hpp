#pragma once

#include "stoss/impact.hpp"

namespace stoss {

/// In which steps and on which grid an impact is computed.
struct Resolution {
  double half_width;  ///< of the contact grid, R
  double step;        ///< R/c
  int nodes;
};

/// What the options say, and the recommended values for what they leave open.
/// @throws InvalidInput for options out of range
[[nodiscard]] Resolution choose_resolution(const Body& body, const Wall& wall, double speed,
                                           const ImpactOptions& options);

/// How `restitution` resolves an impact at a hard wall: finer in time and in space with the body's cutoff.
/// @param half_width greatest one of the contact in a coarser run, or 0 if there was none
[[nodiscard]] ImpactOptions refined_resolution(const Body& body, double speed, double half_width);

/// The same node spacing over a wider grid, at most that of the body.
[[nodiscard]] Resolution widened(const Body& body, const Resolution& resolution);

}  // namespace stoss
