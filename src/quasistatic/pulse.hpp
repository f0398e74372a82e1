#pragma once

#include <memory>
#include <vector>

#include "quasistatic/laws.hpp"

namespace stoss::quasistatic {

/// The pulse of force of a slow impact: a body follows a static law without loss. Its half from the turning point on is
/// a function of a place u ≥ 0 in which, near the real axis, all is analytic, the time from the turning point odd and
/// the force even, and towards the end force and time left fall at least exponentially: the trapezium rule in u
/// converges exponentially.
class Pulse {
 public:
  virtual ~Pulse() = default;
  Pulse(const Pulse&) = delete;
  Pulse& operator=(const Pulse&) = delete;

  struct Course {
    double rate;       ///< dt/du, R/c
    double force;      ///< F/v
    double impulse;    ///< F dt/du / v
    double velocity;   ///< |δ̇|/v
    double stiffness;  ///< dF/dδ, mc²/R²
  };
  /// The motion at a place.
  [[nodiscard]] virtual Course at(double u) const = 0;

  struct Contact {
    double place;        ///< u, at most where time ends
    double force;        ///< mc²/R
    double compression;  ///< R
    double radius;       ///< of the contact of a sphere, R; 0 of a disk
  };
  /// The contact where the velocity is v cos(phase), 0 … π.
  [[nodiscard]] virtual Contact at_phase(double phase) const = 0;

  /// Time from the turning point to a place, R/c.
  [[nodiscard]] double time(double u) const;

  /// From first to last contact, R/c.
  [[nodiscard]] double contact_time() const { return 2.0 * time(end_of_time_); }

  /// Maximum |dF/dt| / v.
  [[nodiscard]] double max_force_rate() const;

  /// ∫F² dt / v² over the whole pulse, and ∫(dF/dt)² dt / v², both to 1e-13.
  [[nodiscard]] double squared_force() const;
  [[nodiscard]] double squared_force_rate() const;

  /// Instants of one half of the pulse, from the turning point: over the whole of it ∫F f(t) dt = v Σ weight f(time)
  /// for even f that turn no faster than the given frequency; for f = cos ωt up to the frequency to 1e-11, of a disk
  /// within 1 % of the limit of its law and for ω = 1000, and mostly to 1e-14.
  struct Nodes {
    std::vector<double> time, weight;
    std::vector<double> stiffness;  ///< ∫ dF/dδ dt from the turning point
  };
  [[nodiscard]] Nodes nodes(double omega) const;

 protected:
  /// @param end_of_time, end_of_impulse places beyond which nothing is left of either
  Pulse(double end_of_time, double end_of_impulse) : end_of_time_(end_of_time), end_of_impulse_(end_of_impulse) {}

  [[nodiscard]] double end_of_time() const { return end_of_time_; }

 private:
  double end_of_time_, end_of_impulse_;

  /// ∫f² dt over the whole pulse for an f of a Course.
  template <typename Function>
  [[nodiscard]] double squared(Function f) const;
};

/// That of a disk, apart from scales.
///
/// With the energy ∫F dδ = ½F²a, a = ½ + ln(F*/F), the velocity is v sin θ and F√a = v cos θ. Let A and D = A − ½ be a
/// and ln(F*/F) at the turning point, and y = ln(F_max/F). Then F/F_max = e^{−y}, cos²θ = e^{−2y}(1 + y/A), and the
/// time from the turning point is t = ∫ (D+y) dy / √(A (e^{2y} − 1 − y/A)). With y = (w sinh u)², w² = D/A, F falls
/// doubly exponentially. Only D matters. D → ∞ is the linear spring of frequency 1/√A.
class LinePulse : public Pulse {
 public:
  /// @param depth     D ≥ 0; below 1e-14, which the speed cannot tell from 0, it is taken for that
  /// @param max_force F_max, mc²/R
  explicit LinePulse(double depth, double max_force = 1.0);

  [[nodiscard]] double energy_factor() const { return 0.5 + depth_; }  ///< A = (v/F_max)²
  [[nodiscard]] Course at(double u) const override;
  [[nodiscard]] Contact at_phase(double phase) const override;

 private:
  double depth_, max_force_;
  double width_;  // w

  [[nodiscard]] double fall_at(double u) const;
};

/// That of a sphere. With the velocity v cos p and q the distance of the phase p from the last contact,
/// q = π/(1 + e^{2u}): at the end F dt = v sin p dp falls as e^{−4u}, t as e^{−8u/5}.
class PointPulse : public Pulse {
 public:
  /// @param speed at which the law does not end
  PointPulse(const RadiusLaw& law, double speed);

  [[nodiscard]] Course at(double u) const override;
  [[nodiscard]] Contact at_phase(double phase) const override;

 private:
  RadiusLaw law_;
  double speed_;
  double greatest_;  // radius

  /// Of the contact, at a phase of 0 … π/2.
  [[nodiscard]] double radius(double phase) const;
};

/// The y ≥ 0 with y − ½ ln(1 + y/A) = excess, for A ≥ ½ and excess ≥ 0. With A = ½ it is the D of the speed at which
/// ln(limit_speed/v) is the excess.
[[nodiscard]] double solve_fall(double energy_factor, double excess);

/// The pulse of force of a slow impact.
/// @throws InvalidInput as slow_impact
[[nodiscard]] std::unique_ptr<const Pulse> slow_pulse(StaticLaw law, double poisson, double speed);

}  // namespace stoss::quasistatic
