#include <array>
#include <cstdio>

#include "javascript.hpp"
#include "questions.hpp"
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

val quantity(double value, const double* error, const std::string& unit, double scale) {
  val made = object({{"value", val(value * scale)}, {"unit", val(unit)}});
  if (error != nullptr) made.set("error", *error * scale);
  return made;
}

/// What is a number, by the names of the command: with a material in units of the first body and in SI.
val quantities(const Meeting& meeting, const Restitution& result) {
  val all = val::object();
  for (const auto& each : restitution_quantities()) {
    const Value value = each.value(result);
    const auto* real = std::get_if<double>(&value);
    const auto* count = std::get_if<long>(&value);
    if (real == nullptr && count == nullptr) continue;
    const double number = real != nullptr ? *real : static_cast<double>(*count);
    const double error = each.error ? each.error(result) : 0.0;
    const double* const its_error = each.error ? &error : nullptr;
    all.set(each.name, quantity(number, its_error, meeting.own_unit_name(each.dimension), 1.0));
    if (!meeting.si || each.dimension == Dimension::none || each.dimension == Dimension::frequency) continue;
    all.set(each.name + "_si",
            quantity(number, its_error, meeting.unit_name(each.dimension), meeting.unit(each.dimension)));
  }
  return all;
}

CurveOptions options(const Question& asked) {
  return {.each = {.tolerance = asked.number("tolerance"), .poll = say_alive}, .threads = 1};
}

}  // namespace

namespace answer {

val restitution(const Question& asked) {
  const auto meeting = asked.meeting();
  const double speed = asked.number("speed");
  const std::vector<double> speeds{own_speed(meeting->encounter, speed)};
  const Restitution result = restitution_curve(meeting->contact, speeds, options(asked)).front();
  val made = object({{"speed", val(speed)},
                     {"quantities", quantities(*meeting, result)},
                     {"converged", val(result.converged)},
                     {"reason", val(result.reason)},
                     {"cutoff", val(result.finest.cutoff)},
                     {"beyondSmallStrain", val(result.finest.beyond_small_strain)}});
  if (const auto yield = yield_speed(meeting->encounter)) made.set("yieldSpeed", *yield);
  return made;
}

val curve(const Question& asked) {
  const auto meeting = asked.meeting();
  const std::vector<double> speeds = numbers(asked.given["speeds"]);
  std::vector<double> own;
  for (const double speed : speeds) own.push_back(own_speed(meeting->encounter, speed));
  restitution_curve(meeting->contact, own, options(asked), [&](std::size_t i, const Restitution& result) {
    asked.deliver(object({{"speed", val(speeds[i])},
                          {"restitution", val(result.restitution.value)},
                          {"error", val(result.restitution.error)},
                          {"converged", val(result.converged)}}),
                  i);
  });
  return val::undefined();
}

val header(const Question& asked) {
  const auto meeting = asked.meeting();
  const double slowest = asked.number("slowest"), fastest = asked.number("fastest"), error = asked.number("error");
  const RestitutionFunction function = restitution_function(
      meeting->contact, own_speed(meeting->encounter, slowest), own_speed(meeting->encounter, fastest),
      {.error = error, .beyond = Beyond::clamp, .threads = 1, .poll = say_alive});
  TableLabel label{.unit = meeting->unit_name(Dimension::speed), .scale = meeting->unit(Dimension::speed)};
  label.provenance = {"stoss " + std::string(version()) + ": table", name(meeting->contact.at(0)),
                      "speed[" + label.unit + "]: " + text(slowest) + ":" + text(fastest), "error: " + text(error)};
  return val(c_header(function, label));
}

}  // namespace answer
}  // namespace stoss::web
