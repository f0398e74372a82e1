#include "stoss/impact/replay.hpp"

#include <cstddef>
#include <string>
#include <utility>

#include "check.hpp"
#include "contact/unit_ratios.hpp"
#include "impact/inputs.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

void require_times(const std::vector<double>& times) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    require("time", times[i], {-1e4, 1e4, true, true, "-1e4 to 1e4"}, "R/c, from the start of the impact");
    if (i > 0 && times[i] < times[i - 1]) {
      throw InvalidInput::out_of_range("time", "times that do not ascend", "ascending ones", "sort them");
    }
  }
}

bool same_modes(const Contact& contact, const std::vector<ModeEnergy>& modes) {
  if (mode_count(contact) != modes.size()) return false;
  std::size_t k = 0;
  for (const ModeGroup& group : contact.groups) {
    for (const double omega : group.omega) {
      if (modes[k].order != group.order || modes[k].omega != omega) return false;
      ++k;
    }
  }
  return true;
}

/// Before or after the impact.
Frame apart(double time, State state, std::size_t nodes) {
  const std::vector<double> none(nodes);
  return {time, 0.0, 0.0, std::move(state), none, {none, none}};
}

}  // namespace

double center(const Contact& contact, const State& state, int number) {
  const bool of_second = number == 1;
  const Body& body = *required_body(contact, number);
  const UnitRatios units = units_of(contact, number);
  const double overlap = state.center + contact.extent;
  // The centre of mass of both rests, and the share of a body in their relative motion is that of the other's mass.
  const double share = contact.mass / (whole_mass(body) * units.mass);
  return (of_second ? 1.0 : -1.0) * (body.extent * units.length - share * overlap);
}

BodyFrame seen_by(const Contact& contact, const ContactGrid& grid, const Frame& frame, int number) {
  const bool of_second = number == 1;
  BodyFrame seen;
  seen.body = required_body(contact, number);
  const std::size_t modes = mode_count(contact), of_first = mode_count(*contact.first);
  if (frame.state.coordinate.size() != modes) {
    throw InvalidInput::out_of_range("state", std::to_string(frame.state.coordinate.size()) + " coordinates",
                                     std::to_string(modes), "one for every kept mode");
  }
  if (seen.body->part.size < 1.0) {
    throw InvalidInput::out_of_range("body", "number " + std::to_string(number) + " of '" + name(contact) + "'",
                                     std::to_string(1 - number), "of the larger body only the near side is computed");
  }
  const UnitRatios units = units_of(contact, number);
  seen.length = units.length;
  seen.stress = units.stress;
  seen.center = center(contact, frame.state, number);
  seen.points = seen_by(grid.points, units);
  const auto begin = frame.state.coordinate.begin();
  const auto middle = begin + static_cast<std::ptrdiff_t>(of_first);
  seen.coordinate.assign(of_second ? middle : begin, of_second ? frame.state.coordinate.end() : middle);
  for (double& each : seen.coordinate) each /= units.length;
  const double unit = contact.first->mass / (seen.body->mass * units.force);
  seen.node_force = frame.node_force;
  for (double& each : seen.node_force) each *= unit;
  seen.crept_force = frame.crept_force[of_second ? 1 : 0];
  for (double& each : seen.crept_force) each *= unit;
  return seen;
}

std::vector<double> surface_displacement(const BodyFrame& seen, const ContactPoints& points) {
  const std::vector<double> shape = seen.body->surface(points).shape;
  std::vector<double> displacement(points.count);
  std::size_t k = 0;
  for (const ModeGroup& group : seen.body->groups) {
    double upper = 0.0, lower = 0.0;
    for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
      upper += seen.coordinate[k] * group.upper[l];
      lower += seen.coordinate[k] * group.lower[l];
    }
    const double* const above = shape.data() + group.upper_row * points.count;
    const double* const below = shape.data() + group.lower_row * points.count;
    for (std::size_t i = 0; i < points.count; ++i) displacement[i] += upper * above[i] + lower * below[i];
  }
  return displacement;
}

std::vector<double> residual_compliance(const BodyFrame& seen, const Poll& poll) {
  std::vector<double> compliance = seen.body->residual_compliance(seen.points, poll);
  for (double& each : compliance) each *= seen.body->mass;  // forces are in its mc²/R
  return compliance;
}

std::vector<Frame> frames_at(const Contact& contact, const Impact& impact, const std::vector<double>& times,
                             const Poll& poll) {
  require_times(times);
  if (name(contact) != impact.contact || contact.cutoff != impact.cutoff || !same_modes(contact, impact.energy.modes)) {
    throw InvalidInput::out_of_range("body", "'" + name(contact) + "'",
                                     "the one of the impact with the same modes, '" + impact.contact + "'");
  }
  std::vector<Frame> frames;
  frames.reserve(times.size());
  const auto wanted = [&] { return frames.size() < times.size(); };
  const auto is_due = [&](double time) {
    return wanted() && times[frames.size()] <= time + 0.5 * impact.resolution.step;
  };
  bool first = true;
  const ImpactObserver observer = [&](const Snapshot& now) {
    const auto state = [&] {
      return State{now.center,
                   now.velocity,
                   {now.coordinate.begin(), now.coordinate.end()},
                   {now.momentum.begin(), now.momentum.end()}};
    };
    while (first && wanted() && times[frames.size()] < 0.0) {
      if (poll) poll();
      const double time = times[frames.size()];
      frames.push_back(apart(time, free_motion(contact, state(), time), now.node_force.size()));
    }
    first = false;
    while (is_due(now.time)) {
      if (poll) poll();
      const auto& [one, other] = now.crept_force;
      frames.push_back({now.time,
                        now.force,
                        now.contact_half_width,
                        state(),
                        {now.node_force.begin(), now.node_force.end()},
                        {{{one.begin(), one.end()}, {other.begin(), other.end()}}}});
    }
  };
  const ImpactOptions options{.resolution = Resolution(impact.resolution), .start = impact.start, .poll = poll};
  const Impact again =
      stoss::impact(contact, impact.speed, options, {.observer = observer, .modes = true, .wanted = is_due});
  const double end = static_cast<double>(again.steps) * again.resolution.step;
  while (wanted()) {
    if (poll) poll();
    const double time = times[frames.size()];
    frames.push_back(apart(time, free_motion(contact, again.final_state, time - end),
                           static_cast<std::size_t>(impact.resolution.nodes)));
  }
  return frames;
}

}  // namespace stoss
