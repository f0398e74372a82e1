// Roots of the eigenvalue equations of a free disk: one pass over a frequency grid that all orders share gives the
// Bessel functions of every order and, from them, exact root counts; roots are isolated by these counts and
// polished by a bracketing method.
#include "bodies/disk/mode_search.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include "bodies/disk/edge_problem.hpp"
#include "numeric/bessel.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::disk {
namespace {

/// Largest grid step in κ′. Zeros of J_n and of J_n' (n ≥ 1) lie more than 3 apart, so at most one falls in a step.
constexpr double max_shear_step = 0.5;

/// Largest grid step in ω, well below the lowest root (ω > 1 for every ν), so that no root lies in the first step.
constexpr double max_step = 0.5;

/// The slowest Rayleigh wave on any disk with −0.95 ≤ ν ≤ 0.995 runs at 0.478 c, and ω_{n,0} > n c_R / R.
constexpr double slowest_edge_wave = 0.47;

struct WaveNumbers {
  double per_omega;        ///< κ/ω
  double shear_per_omega;  ///< κ′/ω
};

bool opposite(double a, double b) { return std::signbit(a) != std::signbit(b); }

/// What is known of one order n ≥ 1 at one frequency.
struct OrderState {
  numeric::BesselPair pressure;
  numeric::BesselPair shear;
  int poles = 0;  ///< zeros of J_n in (0, κ) plus zeros of J_n' in (0, κ′)
  int roots = 0;  ///< eigenfrequencies in (0, ω)
};

/// One order between two neighbouring grid frequencies.
class Interval {
 public:
  Interval(int order, const WaveNumbers& wave, double omega, double width, const OrderState& left)
      : order_(order),
        wave_(wave),
        omega_(omega),
        left_(left),
        pressure_(order, wave.per_omega * omega, left.pressure, wave.per_omega * width),
        shear_(order, wave.shear_per_omega * omega, left.shear, wave.shear_per_omega * width) {}

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
  [[nodiscard]] EdgeProblem at(double offset) const {
    return {order_, wave_.per_omega * (omega_ + offset), wave_.shear_per_omega * (omega_ + offset),
            pressure_(wave_.per_omega * offset), shear_(wave_.shear_per_omega * offset)};
  }

  [[nodiscard]] int roots_below(double offset) const {
    const EdgeProblem edge = at(offset);
    const int poles = left_.poles + (opposite(edge.pressure.value, left_.pressure.value) ? 1 : 0) +
                      (opposite(slope(order_, edge.shear), slope(order_, left_.shear)) ? 1 : 0);
    return edge.roots_below(poles);
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

  [[nodiscard]] Mode mode_at(double offset, int index) const {
    const EdgeProblem edge = at(offset);
    const auto vibration = edge.vibration();
    return {order_, index, omega_ + offset, vibration.radial, vibration.tangential};
  }

  int order_;
  WaveNumbers wave_;
  double omega_;
  OrderState left_;
  numeric::BesselTaylor pressure_;
  numeric::BesselTaylor shear_;
};

/// n = 0 (paper eq. (20)): κ J_1' + ν J_1 = 0. κ J_1'/J_1 falls from 1 between its poles, so there is exactly
/// one root before each zero of J_1.
std::vector<Mode> radial_modes(double poisson, double cutoff) {
  const double per_omega = std::sqrt(1.0 - poisson * poisson);
  std::vector<Mode> modes;
  std::vector<numeric::BesselPair> pairs(2);
  const auto f = [&](double kappa) {
    numeric::bessel_pairs(kappa, pairs);
    return slope(1, pairs[1]) + poisson * pairs[1].value;
  };
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
      const double omega = root / per_omega;
      if (omega > cutoff) break;
      const double radial = 1.0 / std::sqrt(1.0 - (1.0 - poisson * poisson) / (root * root));
      modes.push_back({0, static_cast<int>(modes.size()), omega, radial, 0.0});
    }
    kappa = next_kappa;
    here = next;
  }
  return modes;
}

}  // namespace

std::vector<Mode> find_modes(double poisson, double cutoff, const Poll& poll) {
  const WaveNumbers wave{std::sqrt(1.0 - poisson * poisson), std::sqrt(2.0 * (1.0 + poisson))};
  const auto orders = static_cast<std::size_t>(std::ceil(cutoff / slowest_edge_wave)) + 2;
  const double step_omega = std::min(max_step, max_shear_step / wave.shear_per_omega);
  const int steps = static_cast<int>(std::ceil(cutoff / step_omega));

  std::vector<OrderState> left(orders);
  std::vector<OrderState> right(orders);
  std::vector<std::vector<Mode>> found(orders);
  std::vector<numeric::BesselPair> pressure(orders);
  std::vector<numeric::BesselPair> shear(orders);
  found[0] = radial_modes(poisson, cutoff);

  double left_omega = 0.0;
  for (int step = 1; step <= steps; ++step) {
    if (poll) poll();
    const double omega = cutoff * step / steps;
    numeric::bessel_pairs(wave.per_omega * omega, pressure);
    numeric::bessel_pairs(wave.shear_per_omega * omega, shear);
    for (std::size_t n = 1; n < orders; ++n) {
      OrderState& here = right[n];
      here.pressure = pressure[n];
      here.shear = shear[n];
      here.poles = left[n].poles;
      if (step > 1) {
        here.poles += opposite(here.pressure.value, left[n].pressure.value) ? 1 : 0;
        here.poles +=
            opposite(slope(static_cast<int>(n), here.shear), slope(static_cast<int>(n), left[n].shear)) ? 1 : 0;
      }
      const EdgeProblem edge{static_cast<int>(n), wave.per_omega * omega, wave.shear_per_omega * omega, here.pressure,
                             here.shear};
      here.roots = edge.roots_below(here.poles);
      if (here.roots == left[n].roots) continue;
      const Interval interval(edge.order, wave, left_omega, omega - left_omega, left[n]);
      interval.find(0.0, left[n].roots, omega - left_omega, here.roots, found[n]);
    }
    left.swap(right);
    left_omega = omega;
  }

  std::vector<Mode> modes;
  for (std::size_t n = 0; n < orders; ++n) {
    if (n > 0 && found[n].size() != static_cast<std::size_t>(left[n].roots)) {
      throw NotConverged("modes: order " + std::to_string(n) + " has " + std::to_string(left[n].roots) +
                         " roots, found " + std::to_string(found[n].size()));
    }
    modes.insert(modes.end(), found[n].begin(), found[n].end());
  }
  return modes;
}

}  // namespace stoss::bodies::disk
