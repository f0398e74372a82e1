#include <algorithm>
#include <limits>

#include "contact/unit_ratios.hpp"
#include "stoss/encounter/encounter.hpp"

namespace stoss {
namespace {

/// Frequency up to which all modes of both are known, c/R of the first.
double known_to(const Encounter& encounter) {
  if (!kind(encounter.first.kind).from_file && !kind(encounter.against.kind).from_file) {
    return std::numeric_limits<double>::infinity();
  }
  // What is known does not depend on what is kept.
  constexpr double any = 1.0;
  constexpr double rounding = 1.0 + 1e-12;  // with the last mode
  const Body first = first_maker(encounter)(any, {});
  double known = first.known.complete_to;
  if (const BodyMaker maker = second_maker(encounter)) {
    const Body second = maker(any, {});
    known = std::min(known, second.known.complete_to / UnitRatios(second, first).time);
  }
  return rounding * known;
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
