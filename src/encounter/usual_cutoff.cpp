#include <algorithm>
#include <limits>

#include "contact/unit_ratios.hpp"
#include "stoss/encounter/encounter.hpp"

namespace stoss {
namespace {

/// Frequency up to which all modes of both are known, and computed, c/R of the first.
double known_to(const Encounter& encounter) {
  if (!kind(encounter.first.kind).from_file && !kind(encounter.against.kind).from_file) {
    return std::numeric_limits<double>::infinity();
  }
  // What is known, and computed, does not depend on what is kept.
  constexpr double any = 1.0;
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

}  // namespace

double usual_cutoff(const Encounter& encounter, double speed, double most) {
  validate(encounter);
  const double usual = std::min(most, known_to(encounter));
  const Kind& against = kind(encounter.against.kind);
  if (against.wall || against.bounded) return usual;
  // Modes are as many as the square of duration times cutoff. Slow impacts are long, and need no high ones.
  constexpr double slowest = 1e-8, fastest = 1.0;
  constexpr int level = 14;  // 64 over the time_scale
  const RefinableContact contact = refinable(encounter);
  return std::min(usual, contact.cutoff(level) / contact.stretch(std::clamp(speed, slowest, fastest)));
}

}  // namespace stoss
