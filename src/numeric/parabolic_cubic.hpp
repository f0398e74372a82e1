#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace stoss::numeric {

/// Weights of y_k, y_{k+1} and of the slopes there in the cubic of an interval of width h at the share t of it.
[[nodiscard]] inline std::array<double, 4> cubic_weights(double h, double t) {
  const double u = 1.0 - t;
  return {(1.0 + 2.0 * t) * u * u, t * t * (1.0 + 2.0 * u), h * t * u * u, -h * t * t * u};
}

/// Slope at each place of the parabola through it and its two neighbours, at an end through the last three. Linear in
/// y, so it may be taken of values and of their derivatives in another direction alike.
/// @param x    rising, three or more
/// @param even whether y is mirrored at x = 0, which may be the first place: the slope there is 0
[[nodiscard]] std::vector<double> parabolic_slopes(const std::vector<double>& x, const std::vector<double>& y,
                                                   bool even);

}  // namespace stoss::numeric
