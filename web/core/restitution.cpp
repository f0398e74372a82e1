#include <array>
#include <cstdio>

#include "results.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/restitution/quantities.hpp"
#include "stoss/table/adaptive.hpp"
#include "stoss/table/c_source.hpp"
#include "stoss/version.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

/// A number for what a header says of itself.
std::string text(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.6g", value);
  return buffer.data();
}

CurveOptions options(const Question& asked) {
  return {.each = {.tolerance = asked.number("tolerance", RestitutionOptions{}.tolerance), .poll = say_alive},
          .threads = 1};
}

/// ε at one speed.
val restitution(const Question& asked) {
  const auto meeting = asked.meeting();
  const double speed = asked.number("speed");
  const std::vector<double> speeds{own_speed(meeting->encounter, speed)};
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
  for (const double speed : speeds) own.push_back(own_speed(meeting->encounter, speed));
  restitution_curve(meeting->contact, own, options(asked), [&](std::size_t i, const Restitution& result) {
    asked.deliver(object({{"speed", speeds[i]},
                          {"restitution", result.restitution.value},
                          {"error", result.restitution.error},
                          {"converged", result.converged}}),
                  i);
  });
  return val::undefined();
}

/// The header in C of ε between two speeds, as `stoss table --format c` writes it but for its provenance.
val header(const Question& asked) {
  const auto meeting = asked.meeting();
  const double slowest = asked.number("slowest"), fastest = asked.number("fastest");
  const double error = asked.number("error", FunctionOptions{}.error);
  const RestitutionFunction function = restitution_function(
      meeting->contact, own_speed(meeting->encounter, slowest), own_speed(meeting->encounter, fastest),
      {.error = error, .beyond = Beyond::clamp, .threads = 1, .poll = say_alive});
  TableLabel label{.unit = meeting->unit_name(Dimension::speed), .scale = meeting->unit(Dimension::speed)};
  label.provenance = {"stoss " + std::string(stoss::version()) + ": table", name(meeting->contact.at(0)),
                      "speed[" + label.unit + "]: " + text(slowest) + ":" + text(fastest), "error: " + text(error)};
  return val(c_header(function, label));
}

}  // namespace

EMSCRIPTEN_BINDINGS(restitution) {
  emscripten::function("restitution", &answered<restitution>);
  emscripten::function("curve", &answered<curve>);
  emscripten::function("header", &answered<header>);
}

}  // namespace stoss::web
