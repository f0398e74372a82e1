#pragma once

#include <vector>

#include "bodies/half_space/lamb_kernel.hpp"

namespace stoss::bodies::half_space {

/// Direction in which the surface of a half-space is pushed, and moves.
enum class Direction {
  normal,  ///< into it
  along    ///< along it: for rings, the mean over the ring of what moves along y
};

/// Undamped oscillators of one kind that move the surface: a Rayleigh wave at x_R of LambKernel, where there is one,
/// and a continuum from x = ω/(c_s k) = 1 on. All moments are over the static response of the kind itself, as of Γ.
///
/// A load along the surface of wave number k moves it, on average over the direction of k against the load, by
/// [(1 − ν) Γ_h + Γ_T]/(2μk): half by pressure and shear waves as a load on the normal does, with b in place of a,
///
///   Γ_h(ζ) = bζ²/{(1 − ν)[(2 + ζ²)² − 4ab]},
///
/// and half by shear waves across k, Γ_T(ζ) = 1/b (docs/theory/oblique.md).
struct Spectrum {
  double share = 1.0;            ///< of this kind in the static response of the direction
  double rayleigh_weight = 0.0;  ///< a_R; 0: there is no such wave
  double second_moment = 0.0;    ///< a_R/x_R⁴ + ∫ρ/x⁴ dx
  bool steep = false;            ///< the continuum starts as 1/√(x − 1), not as √(x − 1)
  double (*density_at)(const LambKernel& kernel, double t) = nullptr;  ///< ρ at t = 1/x²

  /// ρ(x)
  [[nodiscard]] double density(const LambKernel& kernel, double x) const { return density_at(kernel, 1.0 / (x * x)); }
};

/// All kinds of a direction.
[[nodiscard]] std::vector<Spectrum> spectra(const LambKernel& kernel, Direction direction);

}  // namespace stoss::bodies::half_space
