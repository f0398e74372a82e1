#include <algorithm>
#include <cmath>
#include <limits>

#include "arrays.hpp"
#include "bindings.hpp"
#include "interpreter.hpp"
#include "stoss/bodies/half_space/field.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/replay.hpp"
#include "vibration.hpp"

namespace stoss::python {
namespace {

using namespace bodies::half_space;

using Values = std::vector<double>;
using Doubles = py::array_t<double, py::array::c_style>;

/// Below the surface of a half-space at several instants, one after another, in units of the first body.
struct Waves {
  Values time, force, center, lateral, normal, lateral_velocity, normal_velocity;
};

/// What meets, with a half-space that is good for as long as the waves are looked at: its unit of length is that of the
/// first body.
Contact lasting(const BodyMaker& first, const BodyMaker& second, double cutoff, double latest, const PlaneGrid& points,
                double poisson, const Poll& poll) {
  Body one = first(cutoff, poll);
  constexpr double any = 1.0;
  const Body probe = second(any, poll);  // for its units
  const double length = probe.scale.length / one.scale.length;
  const double time = length / (probe.scale.speed / one.scale.speed);
  const double reach = std::hypot(*std::max_element(points.depth.begin(), points.depth.end()),
                                  *std::max_element(points.distance.begin(), points.distance.end()));
  const double shear = wave_speeds(probe.contour, poisson).shear;
  constexpr double margin = 1.2, least = 12.0;
  const double duration = margin * (std::max(latest, least) + 2.0 * reach * time / length / shear);
  return contact(std::move(one), probe.near_side(duration / time, cutoff * time, poll));
}

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
  for (std::size_t i = 0; i < now.node_force.size(); ++i) {
    changing.node_force[i] = time > 0.0 ? (after.node_force[i] - before.node_force[i]) / time : 0.0;
  }
  return changing;
}

Waves waves(double poisson, const BodyMaker& first, const BodyMaker& second, const Impact& original,
            const Vibration& vibration, const Values& times, PlaneGrid points, const Poll& poll) {
  const double latest = times.empty() ? 0.0 : times.back();
  const Contact meeting = lasting(first, second, original.cutoff, latest, points, poisson, poll);
  Resolution resolution(original.resolution);
  resolution.step.reset();
  ImpactOptions options{.resolution = resolution, .poll = poll};
  if (!vibration.empty()) options.start = approach(meeting, original.speed, vibration);
  const Impact impact = stoss::impact(meeting, original.speed, options);
  const ContactGrid grid = contact_grid(meeting, impact.resolution.half_width, impact.resolution.nodes);

  Waves all;
  Values around;
  for (const double time : times)
    around.insert(around.end(), {time - impact.resolution.step, time, time + impact.resolution.step});
  std::sort(around.begin(), around.end());
  const std::vector<Frame> frames = motion(meeting, impact, around, poll);
  const auto at = [&](double time) {
    const auto place = std::lower_bound(around.begin(), around.end(), time);
    return frames[static_cast<std::size_t>(std::min(place, around.end() - 1) - around.begin())];
  };
  const double length = meeting.second->scale.length / meeting.first->scale.length;
  for (Values* places : {&points.distance, &points.depth}) {
    for (double& place : *places) place /= length;
  }
  const ContactPoints own{grid.points.radius / length, grid.points.spacing, grid.points.count};
  const HalfSpaceField below(poisson, *meeting.second, own, std::move(points));
  const auto add = [&](const Frame& frame, Values& lateral, Values& normal) {
    const BodyFrame seen = seen_by(meeting, grid, frame, 1);
    const Field field = below.at(seen.coordinate, seen.node_force, poll);
    for (const double each : field.lateral) lateral.push_back(each * seen.length);
    for (const double each : field.normal) normal.push_back(each * seen.length);
  };
  for (const double time : times) {
    const Frame now = at(time);
    all.time.push_back(now.time);
    all.force.push_back(now.force);
    all.center.push_back(seen_by(meeting, grid, now, 0).center);
    add(now, all.lateral, all.normal);
    add(rate(meeting, at(time - impact.resolution.step), now, at(time + impact.resolution.step)), all.lateral_velocity,
        all.normal_velocity);
  }
  return all;
}

py::dict to_dict(Waves&& all, py::ssize_t depths, py::ssize_t distances) {
  const std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(all.time.size()), depths, distances};
  py::dict named;
  named["time"] = take(std::move(all.time));
  named["force"] = take(std::move(all.force));
  named["center"] = take(std::move(all.center));
  named["lateral"] = take(std::move(all.lateral), shape);
  named["normal"] = take(std::move(all.normal), shape);
  named["lateral_velocity"] = take(std::move(all.lateral_velocity), shape);
  named["normal_velocity"] = take(std::move(all.normal_velocity), shape);
  return named;
}

}  // namespace

void bind_wave(py::module_& module) {
  module.def(
      "waves",
      [](double poisson, const BodyMaker& first, const BodyMaker& second, const Impact& impact,
         const Oscillations& state, const Doubles& times, const Doubles& distance, const Doubles& depth) {
        const Values at = to_vector(times);
        const Vibration vibration = to_vibration(state);
        PlaneGrid points{to_vector(distance), to_vector(depth)};
        const Poll poll = signal_poll();
        Waves all;
        {
          const Released released;
          all = waves(poisson, first, second, impact, vibration, at, std::move(points), poll);
        }
        return to_dict(std::move(all), depth.size(), distance.size());
      },
      py::arg("poisson"), py::arg("first"), py::arg("second"), py::arg("impact"), py::arg("state"), py::arg("times"),
      py::arg("distance"), py::arg("depth"), "arrays of times x depths x distances");
  module.def(
      "wave_speeds",
      [](double poisson, bool plane) {
        const WaveSpeeds speeds = wave_speeds(plane ? Contour::cylinder : Contour::ball, poisson);
        return py::make_tuple(speeds.pressure, speeds.shear, speeds.rayleigh);
      },
      py::arg("poisson"), py::arg("plane"), "of pressure, shear and Rayleigh waves, in c of the half-space");
}

}  // namespace stoss::python
