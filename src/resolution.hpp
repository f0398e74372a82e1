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

/// The same node spacing over a wider grid, at most that of the body.
[[nodiscard]] Resolution widened(const Body& body, const Resolution& resolution);

}  // namespace stoss
