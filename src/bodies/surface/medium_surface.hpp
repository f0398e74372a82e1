#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "numeric/bessel.hpp"
#include "stoss/bodies/round.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies {

/// The plane surface of a body without end, in its units of length, c = √(E/ρ) and ρ: what its response needs besides
/// the waves that are kept.
///
/// The load of a contact point on a wave number k, and its displacement by one, have the share shape(kr).
struct MediumSurface {
  Contour contour;        ///< ball: rings on a half-space or a plate; cylinder: pairs of lines
  double pressure_speed;  ///< c_p
  double shear_speed;     ///< c_s
  double softness;  ///< of wave numbers without end: (1 − ν)/(2μ), 1 − ν² on a half-space and 1 on a half-plane;
                    ///< along a half-space (1 + ν)(2 − ν)/2
  double leaving_speed;  ///< of the waves that carry a sudden load away: c_p, along the surface c_s

  /// Static compliance of all waves between k and k + dk, per dk.
  std::function<double(double wave_number)> compliance;

  /// Of the same waves Σ 1/ω⁴ in place of Σ 1/ω².
  std::function<double(double wave_number)> second_moment;

  /// Area of the ring, or length of the two lines, between two distances from the axis.
  [[nodiscard]] double measure(double inner, double outer) const {
    const double width = outer - inner;
    return contour == Contour::ball ? std::numbers::pi * width * (outer + inner) : 2.0 * width;
  }

  /// J₀(kr) or cos kr
  [[nodiscard]] double shape(double phase) const {
    return contour == Contour::ball ? numeric::bessel_j0(phase) : std::cos(phase);
  }

  /// J₁(kr) or sin kr: how a wave moves points away from the axis
  [[nodiscard]] double slope(double phase) const {
    return contour == Contour::ball ? numeric::bessel_j01(phase).first : std::sin(phase);
  }
};

/// The waves of one wave number along a surface, as part of a quadrature: of all with weight dk, those with ω ≤ cutoff
/// one by one, the others by what they add to slow responses.
struct SurfaceWaves {
  double wave_number;             ///< k
  double weight;                  ///< dk
  std::vector<double> omega;      ///< of the kept ones
  std::vector<double> strength;   ///< ω² times the share of each in the compliance
  double residual_compliance;     ///< Σ strength/ω² over those that are not kept
  double residual_second_moment;  ///< Σ strength/ω⁴ over those that are not kept
  std::vector<double> moduli{};   ///< as ModeGroup::moduli
};

/// The same with both directions of a plane through k: every wave moves the surface along its normal as cos ky and
/// along itself as sin ky, on rings as J₀(kr) and J₁(kr).
struct PlaneWaves {
  double wave_number;                  ///< k
  double weight;                       ///< dk
  std::vector<double> omega;           ///< of the kept ones
  std::vector<double> normal, along;   ///< amplitudes of both directions
  Flexibility residual_compliance;     ///< Σ (normal, along)(normal, along)ᵀ/ω² of those that are not kept
  Flexibility residual_second_moment;  ///< the same with ω⁴
  std::vector<double> moduli{};        ///< as ModeGroup::moduli
};

}  // namespace stoss::bodies
