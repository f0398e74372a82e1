#include "stoss/impact/impact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "check.hpp"
#include "contact/demands.hpp"
#include "contact/unit_ratios.hpp"
#include "impact/collision.hpp"
#include "impact/recommended.hpp"
#include "impact/whole_bodies.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr double most_steps = 5e7;
constexpr double max_energy_error = 1e-2;   // beyond, the motion is not resolved in time and means nothing
constexpr double small_strain_limit = 0.5;  // compression, R

/// Steps in which bodies that vibrate, and part so slowly that they have not yet cleared each other, will have done so.
double steps_to_leave(const Contact& contact, const Collision& collision, double step) {
  const Snapshot now = collision.snapshot();
  if (now.velocity >= 0.0 || now.vibration < now.translation) return 0.0;
  return std::max(0.0, (now.center + contact.extent + collision.clearance()) / (-now.velocity * step));
}

/// Maximum of the root mean square velocities with which the bodies vibrate, each in its own wave speed: with all
/// energy of its modes kinetic, √(2E/m).
double own_vibration_speed(const Contact& contact, const State& state) {
  const std::vector<double> energies = mode_energies(contact, state);
  const auto speed = [&](std::size_t begin, std::size_t end, std::size_t first_mode) {
    double twice = 0.0;
    for (std::size_t g = begin, k = first_mode; g < end; ++g) {
      for (std::size_t l = 0; l < contact.groups[g].omega.size(); ++l, ++k) {
        twice += 2.0 * energies[k] / modal_mass(contact, g);
      }
    }
    return std::sqrt(twice);
  };
  std::size_t of_first = 0;
  for (std::size_t g = 0; g < contact.first_groups; ++g) of_first += contact.groups[g].omega.size();
  const double first = speed(0, contact.first_groups, 0);
  if (lasting_groups(contact) == contact.first_groups) return first;
  const UnitRatios units = units_of(contact, 1);
  return std::max(first, speed(contact.first_groups, contact.groups.size(), of_first) * units.time / units.length);
}

void require_start(const State& start, double speed) {
  if (start.velocity != speed) {
    throw InvalidInput("start: got velocity " + std::to_string(start.velocity) + ", allowed the speed of the impact, " +
                       std::to_string(speed) + " (it is given twice)");
  }
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!finite(start.center) || !std::all_of(start.coordinate.begin(), start.coordinate.end(), finite) ||
      !std::all_of(start.momentum.begin(), start.momentum.end(), finite)) {
    throw InvalidInput(
        "start: got a center, coordinate or momentum that is no finite number, allowed finite ones (nan?)");
  }
}

/// A wider grid of the same node spacing, at most as wide as the edge that can touch.
FixedResolution widened(const Contact& contact, const FixedResolution& resolution) {
  constexpr double growth = 1.4;
  const double half_width = std::min(growth * resolution.half_width, greatest_half_width(contact));
  const double nodes = std::ceil(resolution.nodes * half_width / resolution.half_width);
  FixedResolution wider = resolution;
  wider.half_width = half_width;
  wider.nodes = static_cast<int>(std::min<double>(nodes, most_nodes));
  return wider;
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
    throw NotConverged("impact: would take more than " + std::to_string(static_cast<long>(most_steps)) +
                       " steps (use a larger step, or a hard wall instead of an exponential one)");
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
  for (long step = 1; !collision.over(); ++step) {
    if (static_cast<double>(step) > steps) {
      if (contact.unbounded) throw Outlasted(static_cast<double>(step) * resolution.step, echo_time(contact));
      steps += steps_to_leave(contact, collision, resolution.step);
    }
    if (static_cast<double>(step) > std::min(steps, most_steps)) {
      throw NotConverged("impact: the contact has not ended after " + std::to_string(step) + " steps");
    }
    if (options.poll) options.poll();
    collision.advance();
    if (collision.overflows()) {
      if (resolution.half_width < greatest_half_width(contact)) return std::nullopt;
      if (!collision.acts_from_afar()) {
        throw NotConverged("impact: the contact spreads over the whole body (speed too high for this model)");
      }
    }
    if (observation.observer && (step % observation.every == 0 || collision.over())) observe();
  }
  Impact result = collision.result();
  whole.show(result);
  return result;
}

}  // namespace

Impact impact(const Contact& contact, double speed, const ImpactOptions& options, const Observation& observation) {
  return impact(contact, speed, options, observation, nullptr);
}

Impact impact(const Contact& contact, double speed, const ImpactOptions& options, const Observation& observation,
              Pressures* pressures) {
  FixedResolution resolution = fixed_resolution(contact, speed, options.resolution);
  if (options.start) require_start(*options.start, speed);
  require("every", static_cast<long>(observation.every), 1, 1'000'000'000, "steps between two calls of the observer");
  std::optional<Impact> result = run(contact, speed, resolution, options, {}, pressures);
  while (!result) {
    resolution = widened(contact, resolution);
    result = run(contact, speed, resolution, options, {}, pressures);
  }
  if (!(std::abs(result->energy_error) <= max_energy_error)) {
    throw NotConverged("impact: " + std::to_string(result->energy_error) +
                       " of the energy is unaccounted for (use a smaller step)");
  }
  // The observer must see one impact only, so it watches a repetition on the grid that is known to suffice.
  if (observation.observer) result = run(contact, speed, resolution, options, observation, pressures);

  result->contact = name(contact);
  result->start = options.start;
  result->wall = contact.wall;
  result->cutoff = contact.cutoff;
  result->resolution = resolution;
  result->beyond_small_strain = own_speed(contact, speed) > small_strain_speed ||
                                own_compression(contact, result->max_compression) > small_strain_limit ||
                                (options.start && own_vibration_speed(contact, *options.start) > small_strain_speed);
  return std::move(*result);
}

Impact impact(const Body& body, const Wall& wall, double speed, const ImpactOptions& options,
              const Observation& observation) {
  return impact(contact(body, wall), speed, options, observation);
}

}  // namespace stoss
