#pragma once

#include "stoss/bodies/sphere/modes.hpp"

namespace stoss::bodies::sphere {

/// static_flexibility for n ≥ 2 as a function of a real degree.
[[nodiscard]] inline Flexibility flexibility_of_degree(double poisson, double n) {
  const double factor =
      (2.0 * n + 1.0) / 3.0 * (1.0 + poisson) / ((n - 1.0) * (n * n + n + 1.0 + (2.0 * n + 1.0) * poisson));
  return {factor * (2.0 * n * n - 1.0 - poisson * (2.0 * n * n - n - 2.0)),
          factor * (2.0 - n + poisson * (2.0 * n - 1.0)),
          factor * (2.0 * n * n - n + 1.0 - poisson * (2.0 * n * n - 3.0 * n - 1.0)) / (n * (n + 1.0))};
}

}  // namespace stoss::bodies::sphere
