#pragma once

namespace stoss::numeric {

/// J_0 and J_1 at one argument.
struct BesselJ01 {
  double zeroth, first;
};

/// J_0(x) and J_1(x) for x ≥ 0; absolute error below 3e-15.
[[nodiscard]] BesselJ01 bessel_j01(double x);

/// J_0(x) alone.
[[nodiscard]] double bessel_j0(double x);

}  // namespace stoss::numeric
