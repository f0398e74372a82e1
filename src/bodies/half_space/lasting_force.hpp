#pragma once

#include <array>
#include <vector>

#include "bodies/half_space/point_force.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::half_space {

/// The integral over time of the answer to a force of 1 that lasts (PointForce), as polynomials between its arrivals.
///
/// Between two of them, A and B, τ = A + (B − A) sin²(πs/2): kinks like roots and poles like 1/√(τ − A) are smooth in
/// s. Panels of s are halved until what the last of twelve Legendre polynomials have is below 1e-8 of the answer.
class LastingForce {
 public:
  /// @param latest time up to which it is asked
  LastingForce(const PointForce& answer, double latest, const Poll& poll);

  /// ∫G dt over a step, and ∫(t − its middle) G dt.
  struct Step {
    Displaced whole, moment;
  };

  /// Those of all steps from t = 0 on: (i step, (i + 1) step).
  [[nodiscard]] std::vector<Step> over_steps(double step, std::size_t count) const;

 private:
  static constexpr int terms = 12;
  struct Panel {
    double begin, end;                             ///< in s
    Displaced before;                              ///< integral up to the panel
    std::array<double, terms + 1> normal, radial;  ///< Legendre coefficients of the integral over the panel
  };
  struct Interval {
    double begin, end;
    std::vector<Panel> panels;
  };

  void add(const PointForce& answer, Interval& interval, double begin, double end, int halvings, Displaced& sum,
           const Poll& poll);
  [[nodiscard]] Displaced until(double time) const;

  /// The integral of what `until` is above its value at the beginning.
  [[nodiscard]] Displaced twice(double begin, double end, const Displaced& before) const;

  std::vector<Interval> intervals_;
  double accuracy_ = 0.0;
};

}  // namespace stoss::bodies::half_space
