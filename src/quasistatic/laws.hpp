#pragma once

#include "stoss/quasistatic/compression.hpp"

/// Static laws as functions of a size x of the contact, 0 … limit(): of a disk x is the force F, of a sphere the radius
/// a of the contact. Forces are in mc²/R, energies in mc², lengths in R.
namespace stoss::quasistatic {

/// A law of a disk. δ(F) has its maximum at F* = s e^{−1−b}, where δ = F*; written with F*, both laws are one:
///
///   δ = F u,   U = F² (½u − ¼),   u = 1 + ln(F*/F) ≥ 1.
class LineLaw {
 public:
  /// @throws InvalidInput for a Poisson's ratio out of range
  LineLaw(CompressionLaw law, double poisson);

  [[nodiscard]] double limit() const { return limit_; }  ///< F*
  [[nodiscard]] static double force(double x) { return x; }
  [[nodiscard]] double compression(double x) const;
  [[nodiscard]] double energy(double x) const;

  [[nodiscard]] static double at_force(double force) { return force; }
  [[nodiscard]] double at_compression(double compression) const;

 private:
  double limit_;
};

/// A law of a sphere:
///
///   F = s a³,   δ = a² + k a³ (b − g ln a),   U = s [⅖a⁵ + k a⁶ (½b − g/12 − ½g ln a)],
///
/// s = 1/(πS) and k = (4/3π)(1 − ν²)/S with the softness S of the contact, 1 − ν² at a rigid wall: what the sphere adds
/// to Hertz depends on the pressure on it, and so on F and a alone.
class RadiusLaw {
 public:
  /// @throws InvalidInput for a Poisson's ratio out of range
  RadiusLaw(PointLaw law, double poisson);
  /// The same at a half-space. @param softness S = 1/E* of both
  RadiusLaw(PointLaw law, double poisson, double softness);

  [[nodiscard]] double limit() const { return limit_; }
  [[nodiscard]] double force(double a) const { return scale_ * a * a * a; }
  [[nodiscard]] double compression(double a) const;
  [[nodiscard]] double energy(double a) const;
  [[nodiscard]] double stiffness(double a) const;  ///< dF/dδ, mc²/R²

  [[nodiscard]] double at_force(double force) const;
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
