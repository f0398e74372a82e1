#include "stoss/impact/impact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "check.hpp"
#include "contact/demands.hpp"
#include "contact/unit_ratios.hpp"
#include "impact/collision.hpp"
#include "impact/ending.hpp"
#include "impact/inputs.hpp"
#include "impact/recommended.hpp"
#include "impact/run.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

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
std::optional<Impact> run_once(const Contact& contact, double speed, const FixedResolution& resolution,
                               const ImpactOptions& options, const Observation& observation, Pressures* pressures) {
  if (options.poll) options.poll();
  if (pressures != nullptr) *pressures = {};
  const ContactGrid grid = contact_grid(contact, resolution.half_width, resolution.nodes);
  Collision collision(contact, resolution, grid, speed, options.start, options.poll, pressures);
  const WholeBodies whole(contact, collision.snapshot());
  const auto observe = [&] {
    Snapshot now = collision.snapshot();
    State state;
    std::vector<double> node_force;
    std::array<std::vector<double>, 2> crept_force;
    if (observation.modes) {
      state = collision.state();
      node_force = collision.node_force();
      now.coordinate = state.coordinate;
      now.momentum = state.momentum;
      now.node_force = node_force;
      crept_force = collision.crept_force();
      now.crept_force = {crept_force[0], crept_force[1]};
    }
    whole.convert(now);
    observation.observer(now);
  };
  if (observation.observer) observe();
  const auto is_seen = [&](long step) {
    if (!observation.observer || (step % observation.every != 0 && !collision.over())) return false;
    return !observation.wanted || observation.wanted(collision.time());
  };
  const auto rest = run(contact, speed, resolution, options.poll, collision, [&](long step) {
    if (is_seen(step)) observe();
  });
  if (!rest) return std::nullopt;
  Impact result = collision.result();
  rest->apply(result);
  whole.convert(result);
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
  const auto attempt = [&](const FixedResolution& each) {
    return run_once(contact, speed, each, options, {}, pressures);
  };
  Impact result = on_a_grid_that_suffices(contact, resolution, attempt);
  require_resolved(result.energy_error);
  // The observer must see one impact only, so it watches a repetition on the grid that is known to suffice.
  if (observation.observer) result = *run_once(contact, speed, resolution, options, observation, pressures);

  fill_inputs(contact, speed, resolution, options, result);
  return result;
}

Impact impact(const Body& body, const Wall& wall, double speed, const ImpactOptions& options,
              const Observation& observation) {
  return impact(contact(body, wall), speed, options, observation);
}

}  // namespace stoss
