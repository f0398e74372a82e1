#pragma once

#include <vector>

namespace stoss::bodies::half_space {

/// The surface of an elastic half-space as undamped oscillators: one Rayleigh wave and a continuum (docs/theory/
/// half_space.md).
///
/// A pressure p of wave number k moves the surface by (1 − ν)/(μk) Γ p, at the frequency s = −iω by
///
///   Γ(ζ) = aζ² / {(1 − ν)[(2 + ζ²)² − 4ab]},   ζ = s/(c_s k),   a² = 1 + η̂ζ²,   b² = 1 + ζ²,   η̂ = (c_s/c_p)²
///        = a_R/(ζ² + x_R²) + ∫₁^∞ ρ(x)/(ζ² + x²) dx,   x = ω/(c_s k),
///
/// with Γ(0) = a_R/x_R² + ∫ρ/x² dx = 1, and a_R, ρ ≥ 0 (H. Lamb, Phil. Trans. R. Soc. A 203, 1, 1904). All numbers are
/// good to 1e-15.
struct LambKernel {
  double poisson = 0.0;          ///< ν
  double squared_ratio = 0.0;    ///< η̂ = (1 − 2ν)/(2(1 − ν))
  double rayleigh_root = 0.0;    ///< x_R: speed of the Rayleigh wave over c_s
  double rayleigh_weight = 0.0;  ///< a_R
  double second_moment = 0.0;    ///< m₂ = a_R/x_R⁴ + ∫ρ/x⁴ dx = (3 − 4η̂ + 3η̂²)/(4(1 − η̂))

  /// ρ(x) of the continuum. It starts as √(x − 1), falls to 0 and rises again as a root at the speed of pressure waves,
  /// x = 1/√η̂ (at ν = 0 alone it stays finite there), and tends to ρ(∞) = (2/π)√η̂/(1 − ν).
  /// @param x speed of the wave along the surface over c_s, 1 … ∞
  [[nodiscard]] double density(double x) const { return density_at(1.0 / (x * x)); }

  /// The same at t = 1/x².
  [[nodiscard]] double density_at(double t) const;
};

/// The kernel of a Poisson's ratio: in plane strain, as which a half-plane moves, −19 … 0.4999.
[[nodiscard]] LambKernel lamb_kernel(double poisson);

/// C(ν) of the energy that a force F on a small part of the surface radiates, C/(ρc_s³) ∫Ḟ² dt, to 1e-14:
///
///   C = ¼(1 − ν) [a_R/x_R³ + ∫ρ/x³ dx]
///
/// 0.137227 at ν = 0.3; the first term is the share of the Rayleigh wave, 65 % there. It holds where all waves are long
/// against the loaded part.
[[nodiscard]] double radiation_coefficient(const LambKernel& kernel);

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
