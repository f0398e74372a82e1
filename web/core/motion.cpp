#include "motion.hpp"

#include "stoss/restitution/oblique_curve.hpp"

namespace stoss::web {

using emscripten::val;

ObliqueCase at_angle(const Question& asked, const Meeting& meeting, double angle) {
  return own_units(meeting.encounter, {.speed = asked.number("speed"),
                                       .angle = angle,
                                       .spin = asked.number("spin", 0.0),
                                       .second_spin = asked.number("second_spin", 0.0),
                                       .friction = asked.number("friction", 0.0)});
}

ObliqueCase case_of(const Question& asked, const Meeting& meeting) {
  return at_angle(asked, meeting, asked.number("angle"));
}

namespace {

/// Whether the motion is in range. @throws InvalidInput with the name of what is not
val motion(const Question& asked) {
  const auto meeting = asked.meeting();
  validate(meeting->contact, {case_of(asked, *meeting)}, {});
  return val::undefined();
}

}  // namespace

EMSCRIPTEN_BINDINGS(motion) { emscripten::function("motion", &answered<motion>); }

}  // namespace stoss::web
