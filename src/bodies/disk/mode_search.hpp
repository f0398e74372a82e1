#pragma once

#include <vector>

#include "numeric/bessel.hpp"
#include "stoss/bodies/disk/modes.hpp"

namespace stoss::bodies::disk {

/// The free edge of a disk for one angular order n ≥ 1 at one frequency ω.
///
/// With α = κ J_n'(κ), β = J_n(κ), the same primed at κ′, and q = κ′²/2 − n², the displacement and the traction
/// (over 2μ) of the potentials A J_n(κr), B J_n(κ′r) at r = 1 are (paper eqs. (19), (21), (22))
///
///   u_r = A α + n B β′            σ_rr  = −A (α + q β) + n B (α′ − β′)
///   u_φ = −(n A β + B α′)         σ_rφ  = −n A (α − β) + B (α′ + q β′)
///
/// and the eigenvalue equation is their determinant (paper eq. (24) up to a factor),
///
///   D_n = n² (α − β)(α′ − β′) − (α + q β)(α′ + q β′) = 0.
///
/// For n ≫ κ, κ′ (Rayleigh waves at small ν) these terms cancel almost wholly. The code therefore uses
/// α = nβ − γ with γ = κ J_{n+1}(κ), in which the large parts drop out by algebra.
struct EdgeProblem {
  using Mode = bodies::Mode;
  static constexpr auto bessel = numeric::BesselKind::cylindrical;

  int order;                     ///< n
  double kappa;                  ///< κ = ω √(1−ν²)
  double kappa_shear;            ///< κ′ = ω √(2(1+ν))
  numeric::BesselPair pressure;  ///< (β, γ), any positive scale
  numeric::BesselPair shear;     ///< (β′, γ′), any positive scale

  /// D_n, times a positive factor.
  [[nodiscard]] double determinant() const;

  /// J_n'(κ′), at whose zeros the clamped disk has a pole.
  [[nodiscard]] double shear_pole() const { return slope(order, shear); }

  /// Number of eigenfrequencies in (0, ω), exact by the theorem of Wittrick and Williams (Q. J. Mech. Appl.
  /// Math. 24, 263, 1971): those of the clamped disk plus the negative eigenvalues of the dynamic stiffness.
  /// @param poles zeros of J_n in (0, κ) plus zeros of J_n' in (0, κ′)
  [[nodiscard]] int roots_below(int poles) const;

  /// The free vibration at a root of D_n, scaled so that ∫ r (u_r² + u_φ²) dr = 1 and u_r(1) ≥ 0.
  struct Vibration {
    double pressure;    ///< A, in units of the scale of `pressure`
    double shear;       ///< B, in units of the scale of `shear`
    double radial;      ///< C = u_r(1)
    double tangential;  ///< S = u_φ(1)
  };
  [[nodiscard]] Vibration vibration() const;

  /// The mode at a root of D_n.
  [[nodiscard]] Mode mode(int index, double omega) const {
    const Vibration at = vibration();
    return {order, index, omega, at.radial, at.tangential};
  }
};

/// All modes with 0 < ω ≤ cutoff, sorted by order and frequency; arguments already checked. Every root is
/// bracketed by exact root counts at both ends, so none can be missed or found twice.
[[nodiscard]] std::vector<Mode> find_modes(double poisson, double cutoff, const Poll& poll);

/// The same, checked against the static sum rules. @throws NotConverged if the list fails its check
[[nodiscard]] std::vector<Mode> checked_modes(double poisson, double cutoff, const Poll& poll);

}  // namespace stoss::bodies::disk
