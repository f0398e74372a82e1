#pragma once

#include <cstddef>
#include <vector>

namespace stoss::numeric {

/// A cubic through points (x_k, y_k) that rises and falls only as they do: with t = (x − x_k)/h, h = x_{k+1} − x_k,
///
///   y = y_k (1 + 2t)(1 − t)² + y_{k+1} t²(3 − 2t) + h [d_k t(1 − t)² − d_{k+1} t²(1 − t)],
///
/// d the harmonic mean of the slopes on either side, weighted with the intervals, 0 at extremes (F. N. Fritsch and
/// J. Butland, SIAM J. Sci. Stat. Comput. 5, 300, 1984); at the ends that of the last interval.
struct MonotoneCubic {
  std::vector<double> x, y, slope;

  /// @param x rising, two or more. @param y as many
  MonotoneCubic(std::vector<double> x, std::vector<double> y);

  /// At a place of interval k, x_k … x_{k+1}.
  [[nodiscard]] double operator()(std::size_t k, double at) const {
    const double h = x[k + 1] - x[k], t = (at - x[k]) / h, u = 1.0 - t;
    return y[k] * (1.0 + 2.0 * t) * u * u + y[k + 1] * t * t * (1.0 + 2.0 * u) +
           h * t * u * (slope[k] * u - slope[k + 1] * t);
  }
};

}  // namespace stoss::numeric
