#include "stoss/quasistatic/inelastic_impact.hpp"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>

#include "check.hpp"
#include "stoss/errors.hpp"
#include "stoss/quasistatic/adhesion.hpp"

namespace stoss::quasistatic {
namespace {

namespace odeint = boost::numeric::odeint;

/// δ, u, energy that adhesion has taken, energy that waves have taken.
using MotionState = std::array<double, 4>;

constexpr double accuracy = 1e-11;
constexpr int most_steps = 1000000;

/// A law of force with its tangent, from where the bodies last touched without force.
struct Force {
  double value, stiffness;
};

/// One half of the motion: the contact grows, or shrinks from a deepest compression.
struct Phase {
  const InelasticContact& contact;
  bool grows = true;
  Unloading back{};         ///< of the yield law, where it shrinks
  double deepest = 0.0;     ///< δ at the turn
  double radius_ratio = 1;  ///< of the surface that the contact leaves, over R

  [[nodiscard]] bool yields() const { return std::isfinite(contact.yield_depth); }
  [[nodiscard]] double residual() const { return grows || !yields() ? 0.0 : back.residual * contact.yield_depth; }

  /// P and P′ at a compression.
  [[nodiscard]] Force pressed(double delta) const {
    if (!yields() || (grows && delta <= contact.yield_depth)) {
      const double root = std::sqrt(std::max(delta, 0.0));
      return {root * root * root, 1.5 * root};
    }
    const double depth = contact.yield_depth, force = depth * std::sqrt(depth);
    if (grows) {
      return {force * loading_force(contact.yield_law, delta / depth),
              force / depth * loading_stiffness(contact.yield_law, delta / depth)};
    }
    const double recovers = deepest - residual();
    const double share = std::max(delta - residual(), 0.0) / recovers;
    const double most = force * loading_force(contact.yield_law, deepest / depth);
    const double power = std::pow(share, back.exponent - 1.0);
    return {most * power * share, most * back.exponent / recovers * power};
  }

  /// Compression at which the surfaces part.
  [[nodiscard]] double parting() const {
    return residual() + parting_approach * contact.adhesion * std::cbrt(radius_ratio);
  }

  /// A: of a surface of radius R_p δ₀ grows like R_p^{1/3}, F₀ like R_p.
  [[nodiscard]] double adhesive(double delta) const {
    if (contact.adhesion == 0.0) return 0.0;
    const double unit = contact.adhesion * std::cbrt(radius_ratio);
    const double force = 0.75 * std::pow(contact.adhesion, 1.5) * radius_ratio;
    return force * adhesive_addition(std::max((delta - residual()) / unit, parting_approach));
  }

  /// F of a state, with what it consists of.
  struct Acting {
    double force, rate, adhesive, late;
  };

  [[nodiscard]] Acting acting(const MotionState& state) const {
    const double delta = state[0], u = state[1];
    const Force at = pressed(delta);
    const double extra = adhesive(delta);
    const double lag = contact.radiation * at.stiffness;
    double force = 0.0;
    if (grows) {
      force = (at.value + extra + at.stiffness * lag * u) / (1.0 + contact.mobility * at.stiffness * lag);
    } else {
      force = shrinking(delta, u, lag, extra);
    }
    const double rate = u - contact.mobility * force;
    return {force, rate, extra, force - extra - at.value};
  }

  /// F = P(δ + τ(u − αF)) + A: one root, as the right side falls with F.
  [[nodiscard]] double shrinking(double delta, double u, double lag, double extra) const {
    double force = pressed(delta + lag * u).value + extra;
    if (lag * contact.mobility == 0.0) return force;
    for (int i = 0; i < 100; ++i) {
      const Force at = pressed(delta + lag * (u - contact.mobility * force));
      const double change = (at.value + extra - force) / (1.0 + at.stiffness * lag * contact.mobility);
      force += change;
      if (std::abs(change) <= 1e-14 * (std::abs(force) + std::abs(extra))) break;
    }
    return force;
  }

  void operator()(const MotionState& state, MotionState& slope, double) const {
    const Acting its = acting(state);
    slope = {its.rate, -its.force, its.adhesive * its.rate,
             its.late * its.rate + contact.mobility * its.force * its.force};
  }

  /// Positive until the phase ends.
  [[nodiscard]] double left(const MotionState& state) const {
    const Acting its = acting(state);
    if (grows) return its.rate;
    if (contact.adhesion > 0.0) return state[0] - parting();
    const double lag = contact.radiation * pressed(state[0]).stiffness;
    return state[0] + lag * its.rate - residual();
  }

  /// Whether it turns again without having parted.
  [[nodiscard]] bool returns(const MotionState& state) const { return !grows && acting(state).rate >= 0.0; }
};

struct End {
  MotionState state;
  double time, max_force;
  bool returned;
};

/// To the end of a phase.
End run(const Phase& phase, const MotionState& from, double start, double max_force) {
  auto stepper = odeint::make_dense_output(accuracy, accuracy, odeint::runge_kutta_dopri5<MotionState>());
  stepper.initialize(from, start, 1e-4);
  for (int i = 0; i < most_steps; ++i) {
    stepper.do_step(phase);
    const MotionState& now = stepper.current_state();
    max_force = std::max(max_force, phase.acting(now).force);
    const bool ended = !(phase.left(now) > 0.0);
    if (!ended && !phase.returns(now)) continue;
    double low = stepper.previous_time(), high = stepper.current_time();
    MotionState middle = now;
    for (double at = 0.5 * (low + high); low < at && at < high; at = 0.5 * (low + high)) {
      stepper.calc_state(at, middle);
      (phase.left(middle) > 0.0 && !phase.returns(middle) ? low : high) = at;
    }
    stepper.calc_state(high, middle);
    return {middle, high, max_force, !ended};
  }
  throw NotConverged("the motion of a contact that yields or adheres has no end");
}

void require_contact(const InelasticContact& contact) {
  constexpr double most = 1e100;
  const Range not_negative{0.0, most, true, true, "0 to 1e100"};
  if (!(contact.yield_depth > 0.0)) {
    throw InvalidInput::out_of_range("yield_depth", shown(contact.yield_depth), "above 0, infinite without yield");
  }
  require("radiation", contact.radiation, not_negative, "in units of the impact");
  require("mobility", contact.mobility, not_negative, "in units of the impact");
  require("adhesion", contact.adhesion, {0.0, 1e6, true, true, "0 to 1e6"}, "in units of the impact");
}

}  // namespace

InelasticImpact inelastic_impact(const InelasticContact& contact) {
  require_contact(contact);
  const End turn = run({.contact = contact}, {0.0, 1.0, 0.0, 0.0}, 0.0, 0.0);
  Phase back{.contact = contact, .grows = false, .deepest = turn.state[0]};
  double plastic = 0.0;
  if (back.yields() && back.deepest > contact.yield_depth) {
    const double depth = back.deepest / contact.yield_depth;
    back.back = unloading(contact.yield_law, depth);
    back.radius_ratio = back.back.radius_ratio;
    plastic = std::pow(contact.yield_depth, 2.5) *
              (loading_work(contact.yield_law, depth) - unloading_work(contact.yield_law, depth));
  }
  const End end = run(back, turn.state, turn.time, turn.max_force);
  const bool sticks = end.returned || end.state[1] >= 0.0;
  InelasticImpact made;
  made.restitution = sticks ? 0.0 : -end.state[1];
  made.yield = 2.0 * plastic;
  made.adhesion = 2.0 * end.state[2];
  made.waves = 2.0 * end.state[3];
  made.contact_time = sticks ? std::numeric_limits<double>::infinity() : end.time;
  made.max_force = end.max_force;
  made.max_compression = turn.state[0];
  made.sticks = sticks;
  return made;
}

}  // namespace stoss::quasistatic
