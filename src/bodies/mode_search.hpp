#pragma once

// Roots of the eigenvalue equations of a free round body: one pass over a frequency grid that all orders share gives
// the Bessel functions of every order and, from them, exact root counts; roots are isolated by these counts and
// polished by a bracketing method.
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "bodies/residual.hpp"
#include "numeric/bessel.hpp"
#include "stoss/bodies/round.hpp"
#include "stoss/errors.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies {

struct WaveNumbers {
  double per_omega;        ///< κ/ω
  double shear_per_omega;  ///< κ′/ω
};

/// The free edge of a body for one order n ≥ 1 at one frequency, whose modes the search finds: `Edge` is an aggregate
/// of order, κ, κ′ and the Bessel pairs at κ and κ′.
template <typename Edge>
concept FreeEdge = requires(const Edge& edge, int number, double omega) {
  { Edge::bessel } -> std::convertible_to<numeric::BesselKind>;
  { edge.determinant() } -> std::same_as<double>;
  { edge.shear_pole() } -> std::same_as<double>;  // changes sign where the clamped edge has a pole in κ′
  { edge.roots_below(number) } -> std::same_as<int>;
  { edge.mode(number, omega) } -> std::same_as<typename Edge::Mode>;
};

inline bool opposite(double a, double b) { return std::signbit(a) != std::signbit(b); }

/// One order between two neighbouring grid frequencies.
template <FreeEdge Edge>
class Interval {
 public:
  using Mode = typename Edge::Mode;

  /// @param poles of the clamped edge below the left end: zeros of β in (0, κ) and of shear_pole in (0, κ′)
  Interval(const Edge& left, int poles, const WaveNumbers& wave, double omega, double width)
      : left_(left),
        poles_(poles),
        wave_(wave),
        omega_(omega),
        pressure_(left.order, wave.per_omega * omega, left.pressure, wave.per_omega * width, Edge::bessel),
        shear_(left.order, wave.shear_per_omega * omega, left.shear, wave.shear_per_omega * width, Edge::bessel) {}

  /// Isolates and polishes the roots in [low, high] (offsets from the left end), which hold the given root counts.
  void find(double low, int roots_low, double high, int roots_high, std::vector<Mode>& modes) const {
    if (roots_high <= roots_low) return;
    if (roots_high == roots_low + 1) {
      modes.push_back(polish(low, high, roots_low));
      return;
    }
    const double middle = 0.5 * (low + high);
    if (omega_ + middle <= omega_ + low || omega_ + middle >= omega_ + high) {
      // Several roots between neighbouring doubles: the same frequency to all digits.
      for (int root = roots_low; root < roots_high; ++root) modes.push_back(mode_at(low, root));
      return;
    }
    const int roots_middle = roots_below(middle);
    find(low, roots_low, middle, roots_middle, modes);
    find(middle, roots_middle, high, roots_high, modes);
  }

 private:
  [[nodiscard]] Edge at(double offset) const {
    return {left_.order, wave_.per_omega * (omega_ + offset), wave_.shear_per_omega * (omega_ + offset),
            pressure_(wave_.per_omega * offset), shear_(wave_.shear_per_omega * offset)};
  }

  [[nodiscard]] int roots_below(double offset) const {
    const Edge edge = at(offset);
    return edge.roots_below(poles_ + (opposite(edge.pressure.value, left_.pressure.value) ? 1 : 0) +
                            (opposite(edge.shear_pole(), left_.shear_pole()) ? 1 : 0));
  }

  [[nodiscard]] Mode polish(double low, double high, int index) const {
    const auto f = [this](double offset) { return at(offset).determinant(); };
    const double f_low = f(low);
    const double f_high = f(high);
    if (f_low == 0.0) return mode_at(low, index);
    if (f_high == 0.0) return mode_at(high, index);
    const double tolerance = 0.5 * std::numeric_limits<double>::epsilon() * omega_;
    const auto close = [tolerance](double a, double b) { return std::abs(a - b) <= tolerance; };
    std::uintmax_t evaluations = 100;
    const auto bracket = boost::math::tools::toms748_solve(f, low, high, f_low, f_high, close, evaluations);
    return mode_at(0.5 * (bracket.first + bracket.second), index);
  }

  [[nodiscard]] Mode mode_at(double offset, int index) const { return at(offset).mode(index, omega_ + offset); }

  Edge left_;
  int poles_;
  WaveNumbers wave_;
  double omega_;
  numeric::BesselTaylor pressure_;
  numeric::BesselTaylor shear_;
};

/// The roots κ of f that belong to frequencies up to the cutoff, for n = 0: f changes sign at each, and they lie more
/// than ½ apart and above 0.001.
template <typename Function>
std::vector<double> breathing_roots(const Function& f, double per_omega, double cutoff) {
  std::vector<double> roots;
  const double step = 0.5;
  double kappa = 1e-3;
  double here = f(kappa);
  while (kappa < per_omega * cutoff) {
    const double next_kappa = kappa + step;
    const double next = f(next_kappa);
    if (opposite(here, next)) {
      const auto close = [](double a, double b) { return std::abs(a - b) <= 2e-16 * std::abs(b); };
      std::uintmax_t evaluations = 100;
      const auto bracket = boost::math::tools::toms748_solve(f, kappa, next_kappa, here, next, close, evaluations);
      const double root = 0.5 * (bracket.first + bracket.second);
      if (root / per_omega > cutoff) break;
      roots.push_back(root);
    }
    kappa = next_kappa;
    here = next;
  }
  return roots;
}

/// All modes of the orders 1 … orders − 1 with 0 < ω ≤ cutoff, by order, each in order of frequency. Every root is
/// bracketed by exact root counts at both ends, so none can be missed or found twice. No root may lie below ω = 0.5,
/// and the zeros of β and of shear_pole more than ½ apart.
/// @throws NotConverged if the last order still has roots, or the counts contradict each other
template <FreeEdge Edge>
std::vector<std::vector<typename Edge::Mode>> modes_by_order(const WaveNumbers& wave, double cutoff, std::size_t orders,
                                                             const Poll& poll) {
  // At most one zero of each kind falls in a step, and none in the first.
  constexpr double max_shear_step = 0.5, max_step = 0.5;
  struct Known {
    Edge edge;
    int poles = 0;
    int roots = 0;
  };
  const double step_omega = std::min(max_step, max_shear_step / wave.shear_per_omega);
  const int steps = static_cast<int>(std::ceil(cutoff / step_omega));
  std::vector<Known> left(orders), right(orders);
  std::vector<std::vector<typename Edge::Mode>> found(orders);
  std::vector<numeric::BesselPair> pressure(orders), shear(orders);
  double left_omega = 0.0;
  for (int step = 1; step <= steps; ++step) {
    if (poll) poll();
    const double omega = cutoff * step / steps;
    numeric::bessel_pairs(wave.per_omega * omega, pressure, Edge::bessel);
    numeric::bessel_pairs(wave.shear_per_omega * omega, shear, Edge::bessel);
    for (std::size_t n = 1; n < orders; ++n) {
      const Known& before = left[n];
      Known& here = right[n];
      here.edge = {static_cast<int>(n), wave.per_omega * omega, wave.shear_per_omega * omega, pressure[n], shear[n]};
      here.poles = before.poles;
      if (step > 1) {
        here.poles += opposite(here.edge.pressure.value, before.edge.pressure.value) ? 1 : 0;
        here.poles += opposite(here.edge.shear_pole(), before.edge.shear_pole()) ? 1 : 0;
      }
      here.roots = here.edge.roots_below(here.poles);
      if (here.roots == before.roots) continue;
      const Interval<Edge> interval(before.edge, before.poles, wave, left_omega, omega - left_omega);
      interval.find(0.0, before.roots, omega - left_omega, here.roots, found[n]);
    }
    left.swap(right);
    left_omega = omega;
  }
  for (std::size_t n = 1; n < orders; ++n) {
    if (found[n].size() != static_cast<std::size_t>(left[n].roots)) {
      throw NotConverged("modes: order " + std::to_string(n) + " has " + std::to_string(left[n].roots) +
                         " roots, found " + std::to_string(found[n].size()));
    }
  }
  if (!found.back().empty()) throw NotConverged("modes: the highest order that was searched has roots");
  return found;
}

}  // namespace stoss::bodies

/// Checks of the modes of disks and spheres.
namespace stoss::bodies {

/// The static sum rule of one order (docs/theory/modes.md): what its modes leave of its flexibility must be positive
/// semidefinite and no larger than the modes above the cutoff can carry.
/// @param rounding of the sum of both diagonal elements, relative
/// @param tail     what these modes can carry
/// @throws NotConverged if it is violated
void check_sum_rule(int order, const Flexibility& all, const Flexibility& kept, double rounding, double tail,
                    double cutoff);

/// Throws InvalidInput for a cutoff below the lowest mode. @param some modes, the lowest among them
[[noreturn]] void refuse_low_cutoff(const std::vector<Mode>& some, double cutoff, double highest);

}  // namespace stoss::bodies
