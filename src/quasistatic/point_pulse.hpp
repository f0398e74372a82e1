#pragma once

#include <vector>

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

/// The pulse of force of a slow impact of a sphere.
///
/// With the velocity v cos p and q the distance of the phase p from the last contact, q = π/(1 + e^{2u}): time t from
/// the turning point is odd in u and F even, both analytic near the real axis, so that the trapezium rule in u
/// converges exponentially. At the end F dt = v sin p dp falls as e^{−4u}, t as e^{−8u/5}.
class PointPulse {
 public:
  /// @throws InvalidInput as slow_impact
  PointPulse(PointLaw law, double poisson, double speed);
  /// @param speed at which the law does not end
  PointPulse(const RadiusLaw& law, double speed);

  [[nodiscard]] const RadiusLaw& law() const { return law_; }
  [[nodiscard]] double greatest_radius() const { return greatest_; }

  /// Radius of the contact at a phase of 0 … π/2.
  [[nodiscard]] double radius(double phase) const;

  /// Time from the turning point to the place u, R/c.
  [[nodiscard]] double time(double u) const;

  /// From first to last contact, R/c.
  [[nodiscard]] double contact_time() const;

  /// Maximum |dF/dt| / v.
  [[nodiscard]] double max_force_rate() const;

  /// ∫F² dt over the whole pulse, and ∫(dF/dt)² dt, both to 1e-13; F in mc²/R.
  [[nodiscard]] double squared_force() const;
  [[nodiscard]] double squared_force_rate() const;

  /// The u of a phase of 0 … π/2 before or after the turning point, at most where time and impulse end.
  [[nodiscard]] static double place_of(double phase);

  /// Instants of one half of the pulse, from the turning point: over the whole of it ∫F f(t) dt = v Σ weight f(time)
  /// for even f that turn no faster than the given frequency.
  struct Nodes {
    std::vector<double> time, weight;
    std::vector<double> stiffness;  ///< ∫ dF/dδ dt from the turning point
  };
  [[nodiscard]] Nodes nodes(double omega) const;

 private:
  RadiusLaw law_;
  double speed_;
  double greatest_ = 0.0;

  /// dt/du and the radius of the contact there.
  struct Rate {
    double time, radius;
  };
  [[nodiscard]] Rate rate(double u) const;

  /// ∫f dt over the whole pulse for an f(phase, radius) that is even about the turning point.
  template <typename Function>
  [[nodiscard]] double over_pulse(Function f) const;
};

}  // namespace stoss::quasistatic
