#pragma once

#include <cmath>

#include "stoss/quasistatic/elastic_plastic.hpp"

/// PROVISIONAL
namespace stoss::quasistatic::fits {
inline double force(double d) { return 1.0 + 1.5 * (d - 1.0) * 1.3; }
inline double stiffness(double) { return 1.95; }
inline double work(double d) { return 0.4 + (d - 1.0) + 0.975 * (d - 1.0) * (d - 1.0); }
inline Unloading unloading(double m) {
  const double r = m * std::sqrt(m) / force(m);
  return {m - std::cbrt(force(m) * force(m) / r), 1.5, r};
}
}  // namespace stoss::quasistatic::fits
