#pragma once

#include "stoss/quasistatic/point_lossy_impact.hpp"

namespace stoss::quasistatic {

/// An impact of lossy round bodies apart from scales: times in (m/k)^{2/5} v^{−1/5}, lengths in that times v.
struct LossyMotion {
  double restitution = 1.0;
  double contact_time = 0.0;
  double max_compression = 0.0;
};

/// The motion of a loss number x, 0 to 1e6, to 1e-13. @throws NotConverged should it not end
[[nodiscard]] LossyMotion lossy_motion(LossyLaw law, double loss_number);

/// 1 − ε² of a slow ball whose material has the same quality Q at all frequencies, whatever its speed.
///
/// 2.40947/Q at small loss, a fit of Hertz' contact with memory, t^{−α} with α = (2/π) atan(1/Q), that opens as Ting
/// has it: (1 − ε²)Q is a polynomial in α, to 6e-5 of itself from Q = 0.5 on (studies/loss/constant_quality.py). A
/// Kelvin–Voigt material with this Q at ω = π/T loses 3.5443/Q.
/// @param quality Q, 0.5 to 1e30. @throws InvalidInput outside
[[nodiscard]] double loss_of_quality(double quality);

/// x = (3/2) η (k/m)^{2/5} v^{1/5} of the Kelvin–Voigt material that loses as much in a slow impact
/// (point_lossy_impact.hpp).
/// @throws InvalidInput as above
[[nodiscard]] double loss_number_of_quality(double quality);

}  // namespace stoss::quasistatic
