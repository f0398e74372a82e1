// One impact, and what is seen of it when it is repeated.
#include <optional>

#include "rows.hpp"
#include "stoss/encounter/inner_fields.hpp"
#include "stoss/encounter/waves.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/impact/replay.hpp"
#include "stoss/impact/sound.hpp"
#include "support.hpp"

namespace stoss::python {
namespace {

/// Instants of one impact.
struct Frames {
  std::vector<Frame> all;
};

/// A Frame without what belongs to modes and nodes.
struct FrameSummary {
  double time, center, velocity, force, contact_half_width;
};

py::array summaries(const Frames& frames) {
  std::vector<FrameSummary> list;
  list.reserve(frames.all.size());
  for (const Frame& frame : frames.all) {
    list.push_back({frame.time, frame.state.center, frame.state.velocity, frame.force, frame.contact_half_width});
  }
  return take(std::move(list));
}

/// The quantities of an impact with what it was made with, for the fields of stoss.Impact.
py::dict numbers(const Impact& impact) {
  py::dict numbers = to_dict(impact_quantities(), impact);
  numbers["speed"] = impact.speed;
  return numbers;
}

/// The instants of a repetition of an impact, every so many steps.
py::array trajectory(const Impact& impact, const Contact& contact, int every) {
  auto instants = computed([&](const Poll& poll) {
    Rows<Snapshot> rows(snapshot_quantities());
    const ImpactObserver observer = [&](const Snapshot& now) { rows.add(now); };
    const ImpactOptions options{.resolution = Resolution(impact.resolution), .start = impact.start, .poll = poll};
    (void)stoss::impact(contact, impact.speed, options, {.observer = observer, .every = every});
    return rows;
  });
  return instants.take();
}

Impact made(const Contact& contact, const std::string& tail, double speed, std::optional<double> step,
            std::optional<int> nodes, std::optional<double> half_width, const Oscillations& state) {
  ImpactOptions options{.resolution = {step, nodes, half_width, to_tail(tail)}, .poll = signal_poll()};
  if (state.size() > 0) options.start = approach(contact, speed, to_vibration(state));
  const Released released;
  return impact(contact, speed, options);
}

py::ssize_t count_of(const Frames& frames) { return static_cast<py::ssize_t>(frames.all.size()); }

py::dict fields(const Encounter& encounter, int number, const Contact& contact, const Impact& impact,
                const Frames& frames, const Doubles& radius, const Doubles& angle) {
  const std::vector<double> radii = to_vector(radius), angles = to_vector(angle);
  InnerFields inside = computed([&](const Poll& poll) {
    return inner_fields(encounter, number, contact, impact, frames.all, radii, angles, poll);
  });
  py::dict all;
  for (auto& [name, field] : inside.fields) {
    all[py::str(std::string(name))] = take(std::move(field), {count_of(frames), radius.size(), angle.size()});
  }
  all["center"] = take(std::move(inside.center));
  all["size"] = inside.size;
  return all;
}

py::dict waves_below(const Encounter& encounter, const Impact& impact, const Oscillations& state, const Doubles& times,
                     const Doubles& distance, const Doubles& depth) {
  const std::vector<double> at = to_vector(times);
  const Vibration vibration = to_vibration(state);
  bodies::half_space::PlaneGrid points{to_vector(distance), to_vector(depth)};
  Waves all =
      computed([&](const Poll& poll) { return waves(encounter, impact, vibration, at, std::move(points), poll); });
  const std::vector<py::ssize_t> shape{times.size(), depth.size(), distance.size()};
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

void bind_motion(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(FrameSummary, time, center, velocity, force, contact_half_width);
  PYBIND11_NUMPY_DTYPE(ModeShare, body, order, index, omega, energy);
  py::class_<Frames> handle(module, "Frames", "An impact at some times, with the motion of all modes.");
  seal(handle);
  def(handle, "summaries", &summaries);
  def(module, "motion", {"contact", "impact", "times"},
      [](const Contact& contact, const Impact& impact, const Doubles& times) {
        const std::vector<double> at = to_vector(times);
        return computed([&](const Poll& poll) { return Frames{frames_at(contact, impact, at, poll)}; });
      });
  def(module, "surfaces", {"encounter", "contact", "impact", "frames", "reach", "count"},
      [](const Encounter& encounter, const Contact& contact, const Impact& impact, const Frames& frames, double reach,
         std::size_t count) {
        Surfaces all = computed(
            [&](const Poll& poll) { return surfaces(encounter, contact, impact, frames.all, reach, count, poll); });
        const std::vector<py::ssize_t> shape{count_of(frames), static_cast<py::ssize_t>(count)};
        const py::object lower = all.lower.empty() ? py::none() : py::object(take(std::move(all.lower), shape));
        return py::make_tuple(take(std::move(all.lateral)), take(std::move(all.place), shape), lower);
      });
  def(module, "energies_at", {"contact", "impact", "times"},
      [](const Contact& contact, const Impact& impact, const Doubles& times) {
        const std::vector<double> at = to_vector(times);
        auto shares = computed([&](const Poll& poll) { return mode_shares(contact, impact, at, poll); });
        return take(std::move(shares), {times.size(), static_cast<py::ssize_t>(impact.energy.modes.size())});
      });
  def(module, "sound", {"contact", "impact", "number", "interval", "count", "quality"},
      [](const Contact& contact, const Impact& impact, int number, double interval, std::size_t count,
         std::optional<double> quality) {
        const SoundOptions options{.body = number, .interval = interval, .count = count, .quality = quality};
        return take(computed([&](const Poll& poll) { return sound(contact, impact, options, poll); }));
      });
}

}  // namespace

void bind_impacts(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(Oscillation, body, order, index, energy, phase);
  PYBIND11_NUMPY_DTYPE(ModeEnergy, body, order, index, omega, before, after, average);
  module.attr("oscillation") = py::dtype::of<Oscillation>();
  py::class_<Impact> handle(module, "Impact", "One impact, from which its trajectory can be repeated.");
  seal(handle);
  def(handle, "numbers", &numbers);
  def(handle, "modes", [](const py::object& self) { return view(self.cast<const Impact&>().energy.modes, self); });
  def(handle, "trajectory", {"contact", "every"}, &trajectory);
  def(handle, "vibration_after", {"contact", "flight"},
      [](const Impact& impact, const Contact& contact, double flight) {
        return take(vibration_after(contact, impact.final_state, flight));
      });
  def(module, "impact", {"contact", "tail", "speed", "step", "nodes", "half_width", "state"}, &made);
  bind_motion(module);
  def(module, "fields", {"encounter", "number", "contact", "impact", "frames", "radius", "angle"}, &fields);
  def(module, "waves", {"encounter", "impact", "state", "times", "distance", "depth"}, &waves_below);
}

}  // namespace stoss::python
