#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "bodies/sphere/along/toroidal.hpp"
#include "stoss/bodies/sphere/modes.hpp"

namespace stoss::bodies::sphere {

/// Mass of a hollow sphere over that of the solid one, 1 − b³, and its moment of inertia, 1 − b⁵.
[[nodiscard]] inline double share_of_mass(double inner) { return 1.0 - inner * inner * inner; }
[[nodiscard]] inline double share_of_inertia(double inner) { return 1.0 - std::pow(inner, 5); }

/// The vibrations and the static response of a hollow sphere, degree by degree, b ≤ r ≤ 1, both faces free, E = ρ = 1.
///
/// Of u = (U P_n, V dP_n/dθ), N = n(n+1), energy and mass are (4π/(2n+1) times)
///
///   ½ ∫ {λ (U′ + (2U − NV)/r)² + 2μ [U′² + 2 ((U − NV/2)/r)² + ½N(N−2) (V/r)² + ½N (V′ + (U−V)/r)²]} r² dr,
///   ½ ∫ (U² + NV²) r² dr,
///
/// and of a toroidal displacement W, ½N ∫ μ [(W′ − W/r)² + (N−2) (W/r)²] r² dr and ½N ∫ W² r² dr. U, V and W are
/// polynomials of one high degree in r (integrated Legendre polynomials; all integrals are exact), so that each degree
/// is one pair of symmetric matrices. Their eigenvalues ω² lie above those of the shell, one by one, in order (Courant
/// and Fischer): below a cutoff there are no more of them than of the shell, and they are as close as rounding lets
/// them where the polynomials resolve its waves. All of them are computed, so that none is missed.
class RadialShell {
 public:
  /// @param highest_frequency  c/R, and `highest_degree`: up to which waves are resolved
  RadialShell(double poisson, double inner, double highest_frequency, double highest_degree);

  /// Modes of a degree with 0 < ω ≤ cutoff, rising, normalised as those of a solid sphere: to
  /// ∫ r² (U² + NV²) dr = (2n+1)/3.
  [[nodiscard]] std::vector<Mode> modes(int degree, double cutoff) const;

  /// Toroidal ones, to N ∫ r² W² dr = (2n+1)/3.
  [[nodiscard]] std::vector<ToroidalMode> toroidal_modes(int degree, double cutoff) const;

  /// Σ_l (U, V)(U, V)ᵀ/ω² and Σ_l (U, V)(U, V)ᵀ/ω⁴ over all modes of a degree, without the translation of n = 1.
  struct Response {
    Flexibility compliance, second_moment;
  };
  [[nodiscard]] Response response(int degree) const;

  /// Σ_l W²/ω² and Σ_l W²/ω⁴ of a degree n ≥ 1, without the rotation of n = 1.
  struct ToroidalResponse {
    double compliance, second_moment;
  };
  [[nodiscard]] ToroidalResponse toroidal_response(int degree) const;

 private:
  using Matrix = Eigen::MatrixXd;

  /// A pair of matrices without its motion as a rigid body.
  struct Pencil {
    Matrix stiffness, mass;
  };
  [[nodiscard]] Pencil spheroidal(int degree) const;
  [[nodiscard]] Pencil toroidal(int degree) const;

  [[nodiscard]] Eigen::Index resolving(double frequency, double degree) const;

  double inner_, lame_, shear_, slowness_;
  double frequency_;                            // up to which waves are resolved
  Matrix bending_, mixed_, hooping_, inertia_;  // ∫ φ_i′ φ_j′ r², φ_i′ φ_j r, φ_i φ_j and φ_i φ_j r²
};

}  // namespace stoss::bodies::sphere
