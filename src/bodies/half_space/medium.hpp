#pragma once

#include <vector>

#include "bodies/half_space/lamb_kernel.hpp"
#include "bodies/half_space/spectrum.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies::half_space {

/// What a half-space and a half-plane have in common, in units of length, c = √(E/ρ) and ρ.
///
/// A load of wave number k that varies slowly displaces the surface by compliance(k) per load, one that varies like
/// e^{st} by Γ(s/(c_s k)) times as much; the load of a contact point, and its displacement, have the share shape(kr).
struct Medium {
  LambKernel kernel;      ///< of the 3-D Poisson's ratio
  Contour contour;        ///< ball: rings on a half-space; cylinder: pairs of lines on a half-plane
  double pressure_speed;  /// c_p
  double shear_speed;     ///< c_s
  double softness;        ///< (1 − ν)/(2μ): 1 − ν² of a half-space, 1 of a half-plane; along a half-space
                          ///< (1 + ν)(2 − ν)/2
  double leaving_speed;   ///< of the waves that carry a sudden load away: c_p, along the surface c_s
  std::vector<Spectrum> spectra;  ///< of what moves the surface

  /// Compliance of the waves between k and k + dk, per dk: softness/π of a half-space, 2/(πk) of a half-plane.
  [[nodiscard]] double compliance(double wave_number) const;

  /// Area of the ring, or length of the two lines, between two distances from the axis.
  [[nodiscard]] double measure(double inner, double outer) const;

  /// Σ 1/ω⁴ over Σ 1/ω² of all waves of one wave number, in units of 1/(c_s k)².
  [[nodiscard]] double second_moment() const;

  /// J₀(kr) or cos kr
  [[nodiscard]] double shape(double phase) const;

  /// J₁(kr) or sin kr: how a wave moves points away from the axis
  [[nodiscard]] double slope(double phase) const;
};

/// Throws InvalidInput unless such a body can have this Poisson's ratio: −0.95 … 0.4999, 2-D of a cylinder … 0.995.
void require_poisson(Contour contour, double poisson);

/// @param poisson 2-D for a cylinder
/// @param direction along the surface of a half-space only
/// @throws InvalidInput as require_poisson
[[nodiscard]] Medium medium(Contour contour, double poisson, Direction direction = Direction::normal);

}  // namespace stoss::bodies::half_space
