#pragma once

#include <vector>

#include "stoss/quasistatic/slow_impact.hpp"

namespace stoss::quasistatic {

/// The pulse of force of an impact with the static law δ = F [1 + ln(F*/F)] (F* its limit_force), apart from scales.
///
/// With the energy ∫F dδ = ½F²a, a = ½ + ln(F*/F), the velocity is v sin θ and F√a = v cos θ. Let A and D = A − ½ be a
/// and ln(F*/F) at the turning point, and y = ln(F_max/F). Then F/F_max = e^{−y}, cos²θ = e^{−2y}(1 + y/A), and the
/// time from the turning point is t = ∫ (D+y) dy / √(A (e^{2y} − 1 − y/A)). With y = (w sinh u)², w² = D/A, all are
/// analytic functions of u near the real axis, t is odd, F even, and F falls doubly exponentially: the trapezium rule
/// in u converges exponentially. Only D matters. D → ∞ is the linear spring of frequency 1/√A.
class ForcePulse {
 public:
  /// @param depth D ≥ 0; below 1e-14, which the speed cannot tell from 0, it is taken for that
  explicit ForcePulse(double depth);

  [[nodiscard]] double depth() const { return depth_; }                ///< D
  [[nodiscard]] double energy_factor() const { return 0.5 + depth_; }  ///< A = (v/F_max)²

  /// y where the velocity is v cos(phase); infinite at 0 and π.
  [[nodiscard]] double fall(double phase) const;

  /// Time from the turning point to F = F_max e^{−fall}, R/c.
  [[nodiscard]] double time(double fall) const;

  /// From first to last contact, R/c.
  [[nodiscard]] double contact_time() const;

  /// Maximum |dF/dt| / v.
  [[nodiscard]] double max_force_rate() const;

  /// ∫F² dt / v² over the whole pulse, to 1e-13.
  [[nodiscard]] double squared_force() const;

  /// Instants of one half of the pulse, from the turning point: over the whole of it ∫F f(t) dt = v Σ weight f(time)
  /// for even f; for f = cos ωt up to the given frequency to 1e-11, below D = 1e-2 and ω = 1000, and mostly to 1e-14.
  struct Nodes {
    std::vector<double> time, weight;
  };
  [[nodiscard]] Nodes nodes(double omega) const;

 private:
  double depth_;
  double width_;  // w

  [[nodiscard]] double fall_at(double u) const;
  [[nodiscard]] double place_of(double fall) const;
  [[nodiscard]] double slope_factor(double y) const;
  [[nodiscard]] double rate(double u) const;
};

/// The y ≥ 0 with y − ½ ln(1 + y/A) = excess, for A ≥ ½ and excess ≥ 0. With A = ½ it is the D of the speed at which
/// ln(limit_speed/v) is the excess.
[[nodiscard]] double solve_fall(double energy_factor, double excess);

/// The pulse of force of a slow impact.
/// @throws InvalidInput as slow_impact
[[nodiscard]] ForcePulse slow_pulse(CompressionLaw law, double poisson, double speed);

}  // namespace stoss::quasistatic
