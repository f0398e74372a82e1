#include "stoss/impact/impact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "check.hpp"
#include "contact/demands.hpp"
#include "contact/unit_ratios.hpp"
#include "impact/collision.hpp"
#include "impact/ending.hpp"
#include "impact/inputs.hpp"
#include "impact/recommended.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Steps in which bodies that vibrate, and part so slowly that they have not yet cleared each other, will have done so.
double steps_to_leave(const Contact& contact, const Collision& collision, double step) {
  const Snapshot now = collision.snapshot();
  if (now.velocity >= 0.0 || now.vibration < now.translation) return 0.0;
  return std::max(0.0, (now.center + contact.extent + collision.clearance()) / (-now.velocity * step));
}

Slowing slowing(const Collision& collision) {
  const Snapshot now = collision.snapshot();
  return {now.time, now.velocity, collision.remaining(), collision.in_contact()};
}

/// Refuses a cutoff above which modes of a body that is known at a point are missing.
void require_known(const Contact& contact) {
  constexpr double rounding = 1.0 + 1e-9;
  for (const Body* body : {contact.first.get(), contact.second.get()}) {
    if (body == nullptr || body->cutoff <= rounding * body->known.complete_to) continue;
    throw InvalidInput::out_of_range("cutoff", rounded(body->cutoff) + " c/R of '" + body->name + "'",
                                     "up to " + shown_most(body->known.complete_to), "higher modes are not known");
  }
}

/// One run; empty if the contact outgrew the grid.
std::optional<Impact> run(const Contact& contact, double speed, const FixedResolution& resolution,
                          const ImpactOptions& options, const Observation& observation, Pressures* pressures) {
  if (options.poll) options.poll();
  if (pressures != nullptr) *pressures = {};
  const ContactGrid grid = contact_grid(contact, resolution.half_width, resolution.nodes);
  Collision collision(contact, resolution, grid, speed, options.start, options.poll, pressures);
  const WholeBodies whole(contact, collision.snapshot());
  const double flight = std::max(0.0, -(collision.snapshot().center + contact.extent)) + 4.0 * collision.clearance();
  double steps = (longest_duration(contact) + flight / speed) / resolution.step;
  if (steps > most_steps) {
    throw NotConverged("impact: would take more than " + std::to_string(static_cast<long>(most_steps)) + " steps",
                       "step", "use a larger step, or a hard wall instead of an exponential one");
  }
  const auto observe = [&] {
    Snapshot now = collision.snapshot();
    State state;
    std::vector<double> node_force;
    if (observation.modes) {
      state = collision.state();
      node_force = collision.node_force();
      now.coordinate = state.coordinate;
      now.momentum = state.momentum;
      now.node_force = node_force;
    }
    whole.show(now);
    observation.observer(now);
  };
  if (observation.observer) observe();
  Rest rest(contact, speed, steps);
  for (long step = 1; !collision.over(); ++step) {
    if (static_cast<double>(step) > steps) {
      if (rest.ends(slowing(collision))) break;
      if (contact.unbounded) throw Outlasted(static_cast<double>(step) * resolution.step, echo_time(contact));
      steps += steps_to_leave(contact, collision, resolution.step);
    }
    if (static_cast<double>(step) > std::min(steps, most_steps)) {
      throw NotConverged("impact: the contact has not ended after " + std::to_string(step) + " steps");
    }
    if (options.poll) options.poll();
    collision.advance();
    rest.watch(step, [&] { return slowing(collision); });
    if (collision.overflows()) {
      if (resolution.half_width < greatest_half_width(contact)) return std::nullopt;
      if (!collision.is_long_range()) {
        throw NotConverged("impact: the contact spreads over the whole body (speed too high for this model)");
      }
    }
    if (observation.observer && (step % observation.every == 0 || collision.over())) observe();
  }
  Impact result = collision.result();
  rest.show(result);
  whole.show(result);
  return result;
}

}  // namespace

Impact impact(const Contact& contact, double speed, const ImpactOptions& options, const Observation& observation) {
  return impact(contact, speed, options, observation, nullptr);
}

Impact impact(const Contact& contact, double speed, const ImpactOptions& options, const Observation& observation,
              Pressures* pressures) {
  require_known(contact);
  FixedResolution resolution = fixed_resolution(contact, speed, options.resolution);
  if (options.start) require_start(*options.start, speed);
  require_every(observation.every);
  std::optional<Impact> result = run(contact, speed, resolution, options, {}, pressures);
  while (!result) {
    resolution = widened(contact, resolution);
    result = run(contact, speed, resolution, options, {}, pressures);
  }
  require_resolved(result->energy_error);
  // The observer must see one impact only, so it watches a repetition on the grid that is known to suffice.
  if (observation.observer) result = run(contact, speed, resolution, options, observation, pressures);

  show_inputs(contact, speed, resolution, options, *result);
  return std::move(*result);
}

Impact impact(const Body& body, const Wall& wall, double speed, const ImpactOptions& options,
              const Observation& observation) {
  return impact(contact(body, wall), speed, options, observation);
}

}  // namespace stoss
