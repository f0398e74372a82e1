#pragma once

#include <algorithm>
#include <cmath>

namespace stoss::bodies {

/// r^{n−2} − r^n, r^{n−1}, r^n and r^{n+1}, with 0 for a negative power: what static fields of round bodies consist of.
struct RadialPowers {
  double below, low, here, high;
};

/// Number of orders whose static field is felt at a radius, of those up to Nyquist: r^n falls to 1e-20.
[[nodiscard]] inline int static_orders(double radius, int nyquist) {
  if (radius == 1.0) return nyquist + 1;
  const double last = 3.0 - 46.0 / std::log(std::max(radius, 1e-30));
  return 1 + (last < nyquist ? static_cast<int>(last) : nyquist);
}

}  // namespace stoss::bodies
