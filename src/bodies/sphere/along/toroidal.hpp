#pragma once

#include <vector>

#include "stoss/poll.hpp"

namespace stoss::bodies::sphere {

/// One toroidal vibration of a free sphere, with a wave number m ≥ 1 around the axis: the surface moves by W along
/// (−∂/∂θ, (1/sin θ) ∂/∂φ) of a spherical harmonic, r × ∇. Only forces along the surface drive it.
///
/// With κ′ = ω/c_s it is free where (n−1) j_n(κ′) = κ′ j_{n+1}(κ′), and of the norm L ∫ r² u² dr = (2n+1)/3,
/// L = n(n+1), where all is in closed form,
///
///   W² = (2n+1)/(3L) · 2κ′²/(κ′² − (n−1)(n+2)).
struct ToroidalMode {
  int order = 0;           ///< n ≥ 1
  int index = 0;           ///< l
  double omega = 0.0;      ///< c/R
  double amplitude = 0.0;  ///< W
};

/// All of them with 0 < ω ≤ cutoff by degree, each in order of frequency, none missed: κ′ j_{n+1}/j_n rises from 0, and
/// from −∞ after each zero of j_n, to +∞, so that there is one root before each zero of j_n; the first one of n = 1 is
/// the rotation of the rigid sphere.
[[nodiscard]] std::vector<ToroidalMode> toroidal_modes(double poisson, double cutoff, const Poll& poll);

/// Σ W²/ω² over all toroidal modes of a degree: the flexibility against σ_rT = t, 2(1+ν)(2n+1)/(3L(n−1)); of n = 1,
/// without the rotation, (1+ν)/7.
[[nodiscard]] inline double toroidal_flexibility(double poisson, double n) {
  if (n == 1.0) return (1.0 + poisson) / 7.0;
  return 2.0 * (1.0 + poisson) * (2.0 * n + 1.0) / (3.0 * n * (n + 1.0) * (n - 1.0));
}

/// Σ W²/ω⁴ in the same way.
[[nodiscard]] inline double toroidal_second_moment(double poisson, double n) {
  if (n == 1.0) return 2.0 * (1.0 + poisson) * (1.0 + poisson) / 441.0;
  const double each = 2.0 * (1.0 + poisson) / (n - 1.0);
  return (2.0 * n + 1.0) / (3.0 * n * (n + 1.0) * (2.0 * n + 3.0)) * each * each;
}

}  // namespace stoss::bodies::sphere
