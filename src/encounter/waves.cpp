#include "stoss/encounter/waves.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "encounter/ground.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

namespace half_space = bodies::half_space;

using Numbers = std::vector<double>;

double modulus_of(const Solid& solid) {
  return std::visit([](const auto& its) { return its.young / its.density; }, solid);
}

Solid ground_of(const Encounter& encounter) {
  const auto second = second_solid(encounter);
  if (!second || !ground::is_unbounded(*second)) {
    throw InvalidInput::out_of_range("against", encounter.against.kind,
                                     "a half-space, a half-plane, a plate or a strip");
  }
  return *second;
}

}  // namespace

Contact lasting(const Encounter& encounter, double cutoff, double latest, const half_space::PlaneGrid& points,
                const Poll& poll) {
  const Solid solid = ground_of(encounter);
  Body one = first_maker(encounter)(cutoff, poll);
  constexpr double any = 1.0;
  const Body probe = second_maker(encounter)(any, poll);  // for its units
  const double length = probe.scale.length / one.scale.length;
  const double time = length / (probe.scale.speed / one.scale.speed);
  const double reach = std::hypot(*std::max_element(points.depth.begin(), points.depth.end()),
                                  *std::max_element(points.distance.begin(), points.distance.end()));
  constexpr double least = 12.0;
  const double duration = ground::lasting_duration(solid, std::max(latest, least) / time, reach / length);
  return contact(std::move(one), probe.near_side(duration, cutoff * time, poll));
}

namespace {

/// How fast a frame changes, as a frame.
Frame rate(const Contact& contact, const Frame& before, const Frame& now, const Frame& after) {
  Frame changing = now;
  std::size_t k = 0;
  for (std::size_t g = 0; g < contact.groups.size(); ++g) {
    const double mass = modal_mass(contact, g);
    for (std::size_t l = 0; l < contact.groups[g].omega.size(); ++l, ++k) {
      changing.state.coordinate[k] = now.state.momentum[k] / mass;
    }
  }
  const double time = after.time - before.time;
  for (std::size_t body = 0; body < now.crept_force.size(); ++body) {
    const std::vector<double>&from = before.crept_force[body], &to = after.crept_force[body];
    for (std::size_t i = 0; i < from.size(); ++i) {
      changing.crept_force[body][i] = time > 0.0 ? (to[i] - from[i]) / time : 0.0;
    }
  }
  return changing;
}

}  // namespace

Waves waves(const Encounter& encounter, const Impact& original, const Vibration& vibration, const Numbers& times,
            half_space::PlaneGrid points, const Poll& poll) {
  const Solid solid = ground_of(encounter);
  const double latest = std::max(original.contact_time, times.empty() ? 0.0 : times.back());
  const Contact meeting = lasting(encounter, original.cutoff, latest, points, poll);
  Resolution resolution(original.resolution);
  resolution.step.reset();
  ImpactOptions options{.resolution = resolution, .poll = poll};
  if (!vibration.empty()) options.start = approach(meeting, original.speed, vibration);
  const Impact again = impact(meeting, original.speed, options);
  const ContactGrid grid = contact_grid(meeting, again.resolution.half_width, again.resolution.nodes);

  Waves all;
  Numbers around;
  for (const double time : times)
    around.insert(around.end(), {time - again.resolution.step, time, time + again.resolution.step});
  std::sort(around.begin(), around.end());
  const std::vector<Frame> frames = frames_at(meeting, again, around, poll);
  const auto at = [&](double time) {
    const auto place = std::lower_bound(around.begin(), around.end(), time);
    return frames[static_cast<std::size_t>(std::min(place, around.end() - 1) - around.begin())];
  };
  const double length = meeting.second->scale.length / meeting.first->scale.length;
  for (Numbers* places : {&points.distance, &points.depth}) {
    for (double& place : *places) place /= length;
  }
  const ContactPoints own{grid.points.radius / length, grid.points.spacing, grid.points.count};
  const ground::FieldBelow below = ground::field_below(solid, *meeting.second, own, points, poll);
  const auto add = [&](const Frame& frame, Numbers& lateral, Numbers& normal) {
    const BodyFrame seen = seen_by(meeting, grid, frame, 1);
    const half_space::Field field = below(seen.coordinate, seen.crept_force, poll);
    for (const double each : field.lateral) lateral.push_back(each * seen.length);
    for (const double each : field.normal) normal.push_back(each * seen.length);
  };
  for (const double time : times) {
    const Frame now = at(time);
    all.time.push_back(now.time);
    all.force.push_back(now.force);
    all.center.push_back(seen_by(meeting, grid, now, 0).center);
    add(now, all.lateral, all.normal);
    add(rate(meeting, at(time - again.resolution.step), now, at(time + again.resolution.step)), all.lateral_velocity,
        all.normal_velocity);
  }
  return all;
}

half_space::WaveSpeeds wave_speeds(const Encounter& encounter) {
  const Solid solid = ground_of(encounter);
  const double unit = std::sqrt(modulus_of(solid) / modulus_of(first_solid(encounter)));
  const half_space::WaveSpeeds own = ground::speeds_below(solid);
  return {unit * own.pressure, unit * own.shear, unit * own.rayleigh};
}

Surfaces surfaces(const Encounter& encounter, const Contact& contact, const Impact& impact,
                  const std::vector<Frame>& frames, double reach, std::size_t count, const Poll& poll) {
  const Solid solid = ground_of(encounter);
  const ContactGrid grid = contact_grid(contact, impact.resolution.half_width, impact.resolution.nodes);
  Surfaces all;
  // On a circle so large that they are evenly spaced.
  constexpr double flat = 1e4;
  const ContactPoints even{flat * reach, 1.0 / (flat * static_cast<double>(count)), count};
  for (std::size_t i = 0; i < count; ++i) all.lateral.push_back(even.radius * std::sin(even.angle(i)));
  ground::FieldBelow lower;
  for (const Frame& frame : frames) {
    if (poll) poll();
    const BodyFrame seen = seen_by(contact, grid, frame, 1);
    ContactPoints own = even;
    own.radius /= seen.length;
    for (const double each : surface_displacement(seen, own)) all.place.push_back(seen.center - each * seen.length);
    const double thickness = ground::thickness_of(solid);
    if (thickness * seen.length > reach) continue;
    if (!lower) {
      half_space::PlaneGrid points{all.lateral, {thickness}};
      for (double& distance : points.distance) distance /= seen.length;
      lower = ground::field_below(solid, *seen.body, seen.points, points, poll);
    }
    for (const double each : lower(seen.coordinate, seen.crept_force, poll).normal) {
      all.lower.push_back(seen.center + (thickness + each) * seen.length);
    }
  }
  return all;
}

}  // namespace stoss
