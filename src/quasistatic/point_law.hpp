#pragma once

#include "stoss/quasistatic/point_compression.hpp"

namespace stoss::quasistatic {

/// A law of compression of a sphere as a function of the radius a of the contact:
///
///   F = s a³,   δ = a² + k a³ (b − g ln a),   U = s [⅖a⁵ + k a⁶ (½b − g/12 − ½g ln a)],
///
/// s = 1/(πS) and k = (4/3π)(1 − ν²)/S with the softness S of the contact, 1 − ν² at a rigid wall: what the sphere adds
/// to Hertz depends on the pressure on it, and so on F and a alone. Forces are in mc²/R, energies in mc².
class RadiusLaw {
 public:
  /// @throws InvalidInput for a Poisson's ratio out of range
  RadiusLaw(PointLaw law, double poisson);
  /// The same at a half-space. @param softness S = 1/E* of both
  RadiusLaw(PointLaw law, double poisson, double softness);

  [[nodiscard]] double limit() const { return limit_; }  ///< largest a for which the law has a meaning
  [[nodiscard]] double force(double a) const { return scale_ * a * a * a; }
  [[nodiscard]] double radius(double force) const;
  [[nodiscard]] double compression(double a) const;
  [[nodiscard]] double energy(double a) const;
  [[nodiscard]] double stiffness(double a) const;  ///< dF/dδ, mc²/R²

  /// The a of a compression, and of an energy.
  [[nodiscard]] double at_compression(double compression) const;
  [[nodiscard]] double at_energy(double energy) const;

 private:
  double scale_;
  double constant_ = 0.0;   // k b
  double logarithm_ = 0.0;  // k g
  double limit_ = 1.0;

  /// ½ dδ/da / a
  [[nodiscard]] double half_slope(double a) const;
};

}  // namespace stoss::quasistatic
