#pragma once

#include <vector>

#include "numeric/bessel.hpp"
#include "stoss/bodies/sphere/modes.hpp"

namespace stoss::bodies::sphere {

/// The free surface of a sphere for one degree n ≥ 1 at one frequency ω.
///
/// With β = j_n(κ), γ = κ j_{n+1}(κ), α = κ j_n'(κ) = nβ − γ, the same primed at κ′, L = n(n+1) and Y = κ′²/2, the
/// displacement and the traction (over 2μ) of u = ∇(A j_n(κr)P_n) + curl curl(**r** B j_n(κ′r)P_n) at r = 1 are
///
///   u_r = A α + L B β′           σ_rr = A [(L−Y) β − 2α] + L B (α′−β′)
///   u_θ = A β + B (α′+β′)        σ_rθ = A (α−β) + B [(L−1−Y) β′ − α′]
///
/// with the factors P_n and dP_n/dθ left out, and the eigenvalue equation is the determinant of the traction,
///
///   D_n = [Y² − (2n+1)(n−1)Y] ββ′ + [(n+2)n(n−1) − Y] βγ′ + [(n+2)(n²−1) − 2Y] γβ′ − (n−1)(n+2) γγ′ = 0,
///
/// in which the terms of order n⁴ ββ′, which cancel for n ≫ κ, κ′, have dropped out by algebra
/// (docs/theory/spheres.md).
struct EdgeProblem {
  using Mode = bodies::Mode;
  static constexpr auto bessel = numeric::BesselKind::spherical;

  int order;                     ///< n
  double kappa;                  ///< κ = ω/c_p
  double kappa_shear;            ///< κ′ = ω/c_s
  numeric::BesselPair pressure;  ///< (β, γ), any positive scale
  numeric::BesselPair shear;     ///< (β′, γ′), any positive scale

  /// D_n, times a positive factor.
  [[nodiscard]] double determinant() const;

  /// (x j_n)'(κ′), at whose zeros the clamped sphere has a pole.
  [[nodiscard]] double shear_pole() const { return slope(order, shear) + shear.value; }

  /// Number of eigenfrequencies in (0, ω), exact by the theorem of Wittrick and Williams (Q. J. Mech. Appl.
  /// Math. 24, 263, 1971): those of the clamped sphere plus the negative eigenvalues of the dynamic stiffness.
  /// @param poles zeros of j_n in (0, κ) plus zeros of (x j_n)' in (0, κ′)
  [[nodiscard]] int roots_below(int poles) const;

  /// The free vibration at a root of D_n, scaled so that ∫ r² (u_r² + L u_θ²) dr = (2n+1)/3 and u_r(1) ≥ 0.
  struct Vibration {
    double pressure;    ///< A, in units of the scale of `pressure`
    double shear;       ///< B, in units of the scale of `shear`
    double radial;      ///< U = u_r(1)
    double tangential;  ///< V = u_θ(1)
  };
  [[nodiscard]] Vibration vibration() const;

  /// The mode at a root of D_n.
  [[nodiscard]] Mode mode(int index, double omega) const {
    const Vibration at = vibration();
    return {order, index, omega, at.radial, at.tangential};
  }
};

/// ∫ r² [(df/dr)² + L f²/r²] dr − nβ² over 0 … 1 for f = j_n(κr): ½(γ² + κ²β²) − (n + 3/2)βγ.
[[nodiscard]] double gradient_norm_rest(int order, double kappa, const numeric::BesselPair& pair);

/// ω/κ and ω/κ′: the speeds of pressure and of shear waves, c.
struct WaveSpeeds {
  double pressure, shear;
};
[[nodiscard]] WaveSpeeds wave_speeds(double poisson);

/// Throws InvalidInput unless `poisson` is one of which the modes are tested, −0.95 … 0.4999.
void require_poisson(double poisson);

/// Degrees of which the lowest modes may lie below a cutoff: from this one on they do not.
[[nodiscard]] int degrees_below(double poisson, double cutoff);

/// All modes with 0 < ω ≤ cutoff, sorted by degree and frequency; arguments already checked.
[[nodiscard]] std::vector<Mode> find_modes(double poisson, double cutoff, const Poll& poll);

/// The same, checked against the static sum rules. @throws NotConverged if the list fails its check
[[nodiscard]] std::vector<Mode> checked_modes(double poisson, double cutoff, const Poll& poll);

}  // namespace stoss::bodies::sphere
