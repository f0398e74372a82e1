#pragma once

#include <cmath>

#include "stoss/quasistatic/compression.hpp"

namespace stoss::test {

/// δ(F) as the paper prints it for the shortening of the diameter (eq. (56)), F (ln(4/F) − 1 − ν).
inline double printed_compression(double poisson, double force) {
  return force * (std::log(4.0 / force) - 1.0 - poisson);
}

/// Its inverse. All laws δ = F (ln(s/F) − b) are one in units of their limit s e^{−1−b} of F and δ.
inline double printed_force(double poisson, double compression) {
  using quasistatic::CompressionLaw;
  const double unit = 4.0 * std::exp(-2.0 - poisson) / quasistatic::limit_force(CompressionLaw::center, poisson);
  return unit * quasistatic::compression_force(CompressionLaw::center, poisson, compression / unit);
}

}  // namespace stoss::test
