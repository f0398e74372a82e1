#include "results.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/restitution/quantities.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

CurveOptions options(const Question& asked) {
  return {.each = {.tolerance = asked.number("tolerance", RestitutionOptions{}.tolerance), .poll = say_alive},
          .threads = 1};
}

/// ε at one speed.
val restitution(const Question& asked) {
  const auto meeting = asked.meeting();
  const double speed = asked.number("speed");
  const std::vector<double> speeds{speed_in_c(meeting->encounter, speed)};
  const Restitution result = restitution_curve(meeting->contact, speeds, options(asked)).front();
  val quantities = val::object();
  add(quantities, *meeting, restitution_quantities(), result);
  return answer(*meeting, speed, quantities, result, result.finest);
}

/// ε at many speeds, one by one.
val curve(const Question& asked) {
  const auto meeting = asked.meeting();
  const std::vector<double> speeds = numbers(asked.given["speeds"]);
  std::vector<double> own;
  for (const double speed : speeds) own.push_back(speed_in_c(meeting->encounter, speed));
  restitution_curve(meeting->contact, own, options(asked), [&](std::size_t i, const Restitution& result) {
    asked.deliver(object({{"speed", speeds[i]},
                          {"restitution", result.restitution.value},
                          {"error", result.restitution.error},
                          {"converged", result.converged}}),
                  i);
  });
  return val::undefined();
}

}  // namespace

EMSCRIPTEN_BINDINGS(restitution) {
  emscripten::function("restitution", &answered<restitution>);
  emscripten::function("curve", &answered<curve>);
}

}  // namespace stoss::web
