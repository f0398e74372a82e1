#include <algorithm>
#include <limits>

#include "contact/unit_ratios.hpp"
#include "restitution/lasting.hpp"
#include "stoss/encounter/encounter.hpp"

namespace stoss {
namespace {

constexpr double any = 1.0;  // cutoff: what is known of a body, and its units, do not depend on it

/// Frequency up to which all modes of both are known, and computed, c/R of the first.
double known_to(const Encounter& encounter) {
  if (!kind(encounter.first.kind).from_file && !kind(encounter.against.kind).from_file) {
    return std::numeric_limits<double>::infinity();
  }
  constexpr double with_last = 1.0 + 1e-12, below = 1.0 - 1e-12;
  const auto highest = [](const Body& body) {
    const double known = with_last * body.known.complete_to;
    return is_unbounded(body) ? known : std::min(known, below * body.highest_cutoff);
  };
  const Body first = first_maker(encounter)(any, {});
  const BodyMaker maker = second_maker(encounter);
  if (!maker) return highest(first);
  const Body second = maker(any, {});
  return std::min(highest(first), highest(second) / UnitRatios(second, first).time);
}

constexpr int usual_level = 14;  // 64 over the time_scale

/// Of two bodies: at least twice the lowest that `restitution` takes, as the smaller one must be resolved, and no more
/// than lets the larger one, or its part, be made in half a second or so.
double of_bodies(const Encounter& encounter, double usual) {
  constexpr int least_level = 4;
  constexpr double most = 600.0;  // in its own c/R: some 60 000 modes
  const RefinableContact contact = refinable(encounter);
  const double resolving = std::max(usual, contact.cutoff(least_level));
  const Body first = first_maker(encounter)(any, {});
  if (first.contour == Contour::flat) return resolving;
  const double time = UnitRatios(second_maker(encounter)(any, {}), first).time;
  return std::min({resolving, contact.cutoff(usual_level), most / (contact.part() * std::max(time, 1.0))});
}

/// Of what has no end. Modes are as many as the square of duration times cutoff: slow impacts are long, and need no
/// high ones.
double of_half_space(const Encounter& encounter, double speed, const Poll& poll) {
  constexpr double slowest = 1e-8, fastest = 1.0;
  const RefinableContact contact = refinable(encounter);
  return contact.cutoff(usual_level) / lasting_stretch(contact, std::clamp(speed, slowest, fastest), poll);
}

}  // namespace

double usual_cutoff(const Encounter& encounter, double speed, double most, const Poll& poll) {
  validate(encounter);
  const Kind& against = kind(encounter.against.kind);
  const bool wall = against.wall && against.name != "same";
  const double known = known_to(encounter);
  if (!against.wall && !against.bounded) return std::min({most, known, of_half_space(encounter, speed, poll)});
  return std::min(known, wall ? most : of_bodies(encounter, most));
}

}  // namespace stoss
