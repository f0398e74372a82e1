#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "numeric/bessel_j01.hpp"
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

}  // namespace stoss::bodies
