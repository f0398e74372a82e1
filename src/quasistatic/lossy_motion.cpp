// With q = √h, h = δ where the contact grows or the point law holds and δ + ηδ̇ where it shrinks, u = δ̇ and dt = 2q ds
// the motion is a polynomial:
//
//   dq/ds = u − η q³,   du/ds = −2q² (q² + x u),   dt/ds = 2q,
//
// η = 0 in the first case; x = 0 and η = ⅔x in the second. Its Taylor series has as many terms as one likes.
#include "quasistatic/lossy_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "stoss/errors.hpp"

namespace stoss::quasistatic {
namespace {

constexpr int order = 24;
using Series = std::array<double, order + 1>;

struct State {
  double q = 0.0, u = 1.0, time = 0.0;
};

/// What dissipates: x or η.
struct Loss {
  double rate, lag;
};

/// Term n of the product.
double term(const Series& a, const Series& b, int n) {
  double sum = 0.0;
  for (int i = 0; i <= n; ++i) sum += a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(n - i)];
  return sum;
}

double value(const Series& a, double s) {
  double sum = 0.0;
  for (std::size_t i = a.size(); i-- > 0;) sum = sum * s + a[i];
  return sum;
}

/// The motion near a state.
struct Motion {
  Series q{}, u{}, time{};

  Motion(const State& from, const Loss& loss) {
    q[0] = from.q, u[0] = from.u, time[0] = from.time;
    Series square{};
    for (int n = 0; n < order; ++n) {
      const auto i = static_cast<std::size_t>(n);
      square[i] = term(q, q, n);
      q[i + 1] = (u[i] - loss.lag * term(square, q, n)) / (n + 1);
      u[i + 1] = -2.0 * (term(square, square, n) + loss.rate * term(square, u, n)) / (n + 1);
      time[i + 1] = 2.0 * q[i] / (n + 1);
    }
  }

  [[nodiscard]] State at(double s) const { return {value(q, s), value(u, s), value(time, s)}; }

  /// A step that leaves out less than rounding: e⁻² of the radius of convergence, as the last terms show it.
  [[nodiscard]] double step(const Loss& loss) const {
    const double unit = 1.0 / (1.0 + (loss.rate + loss.lag) * q[0] * q[0]);
    double radius = std::numeric_limits<double>::infinity();
    for (const Series* a : {&q, &u}) {
      const double scale = std::abs((*a)[0]) + unit * std::abs((*a)[1]);
      for (int n = order - 5; n <= order; ++n) {  // many terms vanish at q = 0, never six in a row
        const double last = std::abs((*a)[static_cast<std::size_t>(n)]);
        if (last > 0.0) radius = std::min(radius, std::pow(scale / last, 1.0 / n));
      }
    }
    return radius * std::exp(-2.0);
  }
};

/// On to where `left`, positive at first, vanishes.
template <typename Function>
State advance(State state, const Loss& loss, Function left) {
  constexpr int max_steps = 10000;
  for (int i = 0; i < max_steps; ++i) {
    const Motion motion(state, loss);
    double low = 0.0, high = motion.step(loss);
    state = motion.at(high);
    if (left(state) > 0.0) continue;
    for (double middle = 0.5 * high; low < middle && middle < high; middle = 0.5 * (low + high)) {
      (left(motion.at(middle)) > 0.0 ? low : high) = middle;
    }
    return motion.at(low);
  }
  throw NotConverged(
      "quasistatic: the bodies did not separate within the steps that are computed (is loss_time too large?)");
}

}  // namespace

LossyMotion lossy_motion(LossyLaw law, double loss_number) {
  const Loss growing{loss_number, 0.0}, shrinking{0.0, loss_number / 1.5};
  const State turn = advance({}, growing, [](const State& at) { return at.u; });
  const State end = law == LossyLaw::ting
                        ? advance(turn, shrinking, [](const State& at) { return at.q; })
                        : advance(turn, growing, [loss_number](const State& at) {
                            return at.q - std::sqrt(loss_number * std::max(-at.u, 0.0));  // F/√δ is q² + x u
                          });
  return {.restitution = -end.u, .contact_time = end.time, .max_compression = turn.q * turn.q};
}

}  // namespace stoss::quasistatic
