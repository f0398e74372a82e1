#pragma once

#include <complex>

#include "bodies/half_space/lamb_kernel.hpp"
#include "bodies/surface/depth_profile.hpp"

namespace stoss::bodies::half_space {

/// How the wave (k, x) moves the half-space below the surface, over its displacement of the surface into it,
///
///   g_z = Im{a [(1 + b²) e^{−akz} − 2e^{−bkz}]/R}/D,   g_r = Im{[(1 + b²) e^{−akz} − 2ab e^{−bkz}]/R}/D,
///
/// with a² = 1 − η̂x², b² = 1 − x², both roots above their branch points on the positive imaginary axis,
/// R = (1 + b²)² − 4ab and D = −Im{ax²/R}; for the Rayleigh wave, x = x_R, with 1 for 1/R and no Im. A wave of the
/// continuum is a standing one in the depth: what comes from there and what leaves.
class WaveProfile {
 public:
  /// @param x speed of the wave along the surface over c_s: x_R, or above 1
  WaveProfile(const LambKernel& kernel, double x);

  /// @param phase kz
  [[nodiscard]] DepthProfile at(double phase) const;

 private:
  using Complex = std::complex<double>;
  Complex pressure_decay_, shear_decay_;  // a, b
  Complex pressure_lateral_, shear_lateral_, pressure_normal_, shear_normal_;
};

/// The same under a static load: e^{−kz}(kz − 1 + 2ν)/(2 − 2ν) and e^{−kz}(1 + kz/(2 − 2ν)).
[[nodiscard]] DepthProfile static_profile(double poisson, double phase);

}  // namespace stoss::bodies::half_space
