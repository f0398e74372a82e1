// u = ∫ G(t − t') dF(t') of the ground's own answer G, with errors from what each part of F and of the method changes.
#include "stoss/encounter/seismogram.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "check.hpp"
#include "encounter/ground.hpp"
#include "encounter/seismogram/pulse_loads.hpp"
#include "encounter/seismogram/recorder.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using Series = std::vector<double>;

/// What the material of the ground does in an impact of a duration, in its own time: its stiffness over that at first,
/// and the loss angle of the layer that loses most.
struct Damping {
  double stiffness = 1.0, angle = 0.0;

  Damping(const Body& ground, double duration) : frequency(std::numbers::pi / duration) {
    std::vector<MaterialLoss> layers = ground.layers;
    if (layers.empty()) layers = {{ground.loss_time, ground.relaxation}};
    stiffness = std::abs(modulus(layers.front(), {0.0, frequency}));
    for (const MaterialLoss& each : layers) angle = std::max(angle, std::arg(modulus(each, {0.0, frequency})));
  }

  /// Share of a motion that its waves may have lost until a time.
  [[nodiscard]] double share(double time) const { return std::min(1.0, angle * frequency * time); }

 private:
  double frequency;
};

/// Greatest size of a series within so many steps of each instant: errors that swing pass through 0.
Series around(const Series& of, std::size_t width) {
  Series greatest(of.size());
  for (std::size_t i = 0; i < of.size(); ++i) {
    const std::size_t end = std::min(of.size(), i + width + 1);
    for (std::size_t k = i < width ? 0 : i - width; k < end; ++k) greatest[i] = std::max(greatest[i], std::abs(of[k]));
  }
  return greatest;
}

Series minus(Series one, const Series& other) {
  for (std::size_t i = 0; i < one.size(); ++i) one[i] -= other[i];
  return one;
}

double greatest_of(const Series& series) {
  double greatest = 0.0;
  for (const double each : series) greatest = std::max(greatest, std::abs(each));
  return greatest;
}

/// One component of the motion with its error.
/// @param lost shares that waves may have lost
std::vector<Estimate> estimates(const ground::Recorded& all, Series bodies::Motion::*of, std::size_t width, double unit,
                                const Series& lost) {
  constexpr double of_cutoff = 3.0, of_means = 2.0, of_size = 0.1;
  const Series& value = all.of(ground::whole).*of;
  const Series size = minus(value, all.of(ground::point).*of);
  const double relative = greatest_of(size) / std::max(greatest_of(value), 1e-300);
  const Series left = around(all.unresolved.*of, width),
               coarse = around(minus(all.of(ground::coarse).*of, value), width),
               change = around(all.of(ground::change).*of, width), sized = around(size, width),
               moved = around(value, width);
  std::vector<Estimate> made;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const double error =
        of_cutoff * left[i] + of_means * coarse[i] + change[i] + (of_size + relative) * sized[i] + lost[i] * moved[i];
    made.push_back({value[i] * unit, error * unit});
  }
  return made;
}

Estimate greatest_of(const std::vector<Estimate>& series) {
  const auto larger = [](const Estimate& a, const Estimate& b) { return std::abs(a.value) < std::abs(b.value); };
  const Estimate its = *std::max_element(series.begin(), series.end(), larger);
  return {std::abs(its.value), its.error};
}

void require_receiver(const Receiver& receiver, double thickness, double contact) {
  constexpr double apart = 2.0;
  require("distance", receiver.distance, ranges::place, "R, along the surface");
  if (std::isinf(thickness)) {
    require("depth", receiver.depth, ranges::place, "R, below the surface");
  } else if (!(receiver.depth >= 0.0 && receiver.depth <= thickness * (1.0 + 1e-12))) {
    throw InvalidInput::out_of_range("depth", shown(receiver.depth), "0 to " + shown_most(thickness) + " R",
                                     "the thickness of the plate");
  }
  if (std::hypot(receiver.distance, receiver.depth) < apart * contact) {
    throw InvalidInput::out_of_range("distance", shown(receiver.distance), shown_least(apart * contact) + " R or more",
                                     "twice the radius of the contact");
  }
}

}  // namespace

Seismogram seismogram(const Encounter& encounter, const Pulse& pulse, const Receiver& receiver,
                      const SeismogramOptions& options) {
  const auto solid = second_solid(encounter);
  if (!solid || !(std::holds_alternative<HalfSpace>(*solid) || std::holds_alternative<Plate>(*solid))) {
    throw InvalidInput::out_of_range("against", encounter.against.kind, "a half-space or a plate",
                                     "in which a receiver is");
  }
  require("points", static_cast<long>(options.points), 2, 20'000, "instants of a seismogram");
  constexpr double any = 1.0;  // for units, and for what they lose
  const Body first = first_maker(encounter)(any, options.poll), second = second_maker(encounter)(any, options.poll);
  if (first.contour != Contour::ball) {
    throw InvalidInput::out_of_range("body", encounter.first.kind, "one that touches on a circle");
  }
  const OwnUnits elastic(first, second, 1.0);
  const Damping damping(second, duration_of(pulse) / elastic.time);
  constexpr double most_lossy = 0.1;
  if (!(damping.angle <= most_lossy)) {
    throw InvalidInput::out_of_range("against", "a material with tan delta = " + rounded(std::tan(damping.angle), 2),
                                     "up to 0.1 for a receiver", "waves are those of an elastic one");
  }
  const OwnUnits units(first, second, damping.stiffness);
  const double thickness = ground::thickness_of(*solid) * units.length;
  require_receiver(receiver, thickness, pulse.finest.max_half_width);
  const Receiver own{receiver.distance / units.length, receiver.depth / units.length};
  double until = options.until;
  if (!(until > 0.0)) until = pulse.contact_time.value + ground::passing_time(*solid, own) * units.time;
  const PulseLoads loads = loads_of(pulse, until, options.points, units);
  const ground::Recorded moved = ground::recorded(*solid, own, loads.instants, loads.all, loads.duration, options.poll);

  Seismogram made;
  made.receiver = receiver;
  made.arrival = ground::arrival(*solid, own) * units.time;
  constexpr double window = 0.05;  // of the contact
  const double interval = loads.instants.step * static_cast<double>(loads.instants.stride);
  const auto width = static_cast<std::size_t>(std::ceil(window * loads.duration / interval));
  const double speed = units.length / units.time;
  Series lost(loads.instants.outputs);
  for (std::size_t i = 0; i < lost.size(); ++i) lost[i] = damping.share(interval * static_cast<double>(i));
  const auto normal = estimates(moved, &bodies::Motion::normal, width, units.length, lost),
             radial = estimates(moved, &bodies::Motion::radial, width, units.length, lost),
             normal_velocity = estimates(moved, &bodies::Motion::normal_velocity, width, speed, lost),
             radial_velocity = estimates(moved, &bodies::Motion::radial_velocity, width, speed, lost);
  made.max_normal = greatest_of(normal), made.max_radial = greatest_of(radial);
  made.max_normal_velocity = greatest_of(normal_velocity), made.max_radial_velocity = greatest_of(radial_velocity);
  const Course force(pulse.time, pulse.force), error(pulse.time, pulse.force_error);
  for (std::size_t i = 0; i < normal.size(); ++i) {
    const double time = interval * static_cast<double>(i) * units.time;
    made.instants.push_back(
        {time, {force(time), error(time)}, normal[i], radial[i], normal_velocity[i], radial_velocity[i]});
  }
  return made;
}

}  // namespace stoss
