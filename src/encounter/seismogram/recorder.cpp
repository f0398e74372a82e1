#include "encounter/seismogram/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "bodies/half_space/pressed_block.hpp"
#include "bodies/plate/given.hpp"
#include "bodies/plate/pressed_plate.hpp"
#include "check.hpp"
#include "encounter/ground.hpp"
#include "stoss/errors.hpp"

namespace stoss::ground {
namespace {

using bodies::Instants;

double last_of(const Instants& its) { return its.step * static_cast<double>(its.outputs * its.stride); }

double greatest_radius(const bodies::PressedLoad& load) {
  return *std::max_element(load.radius.begin(), load.radius.end());
}

Recorded of_block(double poisson, const Receiver& receiver, const Instants& instants, const Loads& loads,
                  const Poll& poll) {
  const bodies::half_space::PressedBlock block(poisson, receiver.distance, receiver.depth, greatest_radius(loads[0]),
                                               instants, poll);
  Recorded all{{}, bodies::Motion(instants.outputs)};
  for (const bodies::PressedLoad& load : loads) all.motions.push_back(block.of(load));
  return all;
}

/// Layers in the units of the uppermost one; what lies so deep that nothing is back from there is left out.
bodies::plate::Lamina lamina_of(const Plate& plate, double latest) {
  const bodies::plate::Given given = bodies::plate::given_of(plate);
  constexpr double margin = 1.1;
  const double duration = margin * latest;
  return bodies::plate::lamina(given.contour,
                               bodies::plate::sheets_of(given, bodies::plate::kinds_of(given, duration), duration));
}

Recorded of_plate(const Plate& plate, const Receiver& receiver, const Instants& instants, const Loads& loads,
                  double duration, const Poll& poll) {
  constexpr double fastest = 120.0, least = 30.0, most_waves = 8e4,
                   lower = 0.95;  // cutoffs over those of the contact
  const double passing = std::hypot(receiver.distance, receiver.depth) / speeds_below(Solid{plate}).pressure;
  const bodies::plate::Lamina lamina = lamina_of(plate, last_of(instants) + passing);
  double cutoff = fastest / duration;
  while (bodies::plate::count_of_waves(lamina, receiver.distance, instants, cutoff) > most_waves) {
    cutoff *= lower;
    if (cutoff > least / duration) continue;
    throw InvalidInput::out_of_range("until", "a time or a distance for which a plate has too many waves",
                                     "an earlier one, or a nearer receiver");
  }
  bodies::plate::PressedPlate made = bodies::plate::pressed_plate(
      lamina, plate.poisson, receiver.distance, receiver.depth, instants, {loads.begin(), loads.end()}, cutoff, poll);
  return {std::move(made.motions), std::move(made.unresolved)};
}

}  // namespace

Recorded recorded(const Solid& solid, const Receiver& receiver, const Instants& instants, const Loads& loads,
                  double duration, const Poll& poll) {
  if (const auto* block = std::get_if<HalfSpace>(&solid)) {
    return of_block(block->poisson, receiver, instants, loads, poll);
  }
  const auto& plate = std::get<Plate>(solid);
  const double echo = std::hypot(receiver.distance, 2.0 * plate.thickness - receiver.depth);
  const bool like_block = plate.below.empty() && echo > speeds_below(solid).pressure * last_of(instants);
  if (like_block) return of_block(plate.poisson, receiver, instants, loads, poll);
  return of_plate(plate, receiver, instants, loads, duration, poll);
}

double arrival(const Solid& solid, const Receiver& receiver) {
  return std::hypot(receiver.distance, receiver.depth) / speeds_below(solid).pressure;
}

double passing_time(const Solid& solid, const Receiver& receiver) {
  constexpr double margin = 1.2, crossings = 8.0;
  const bodies::half_space::WaveSpeeds speeds = speeds_below(solid);
  const double thickness = thickness_of(solid);
  const double echoes = std::isinf(thickness) ? 0.0 : crossings * thickness / speeds.pressure;
  return margin * std::hypot(receiver.distance, receiver.depth) / speeds.rayleigh + echoes;
}

}  // namespace stoss::ground
