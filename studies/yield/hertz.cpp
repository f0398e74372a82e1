#include "hertz.hpp"

#include <algorithm>
#include <cmath>

namespace yield_study {

double onset_pressure(double poisson) {
  const auto difference = [&](double depth) {
    const double decay = 1.0 / (1.0 + depth * depth);
    const double radial = (1.0 + poisson) * (1.0 - depth * std::atan2(1.0, depth)) - 0.5 * decay;
    return decay - radial;
  };
  double low = 0.0, high = 2.0;  // one maximum between them: golden section
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  for (int k = 0; k < 100; ++k) {
    const double one = high - golden * (high - low), other = low + golden * (high - low);
    if (difference(one) > difference(other))
      high = other;
    else
      low = one;
  }
  return 1.0 / difference(0.5 * (low + high));
}

}  // namespace yield_study
