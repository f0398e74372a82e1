#include "restitution.hpp"

#include <array>
#include <cstdio>

#include "javascript.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/restitution/quantities.hpp"
#include "stoss/table/adaptive.hpp"
#include "stoss/table/c_source.hpp"
#include "stoss/version.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

/// A number for a message.
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

CurveOptions options(double tolerance) { return {.each = {.tolerance = tolerance, .poll = say_alive}, .threads = 1}; }

}  // namespace

val restitution(const Meeting& meeting, double speed, double tolerance) {
  const std::vector<double> speeds{own_speed(meeting.encounter, speed)};
  const Restitution result = restitution_curve(meeting.contact, speeds, options(tolerance)).front();
  val made = object({{"speed", val(speed)},
                     {"quantities", quantities(meeting, result)},
                     {"converged", val(result.converged)},
                     {"reason", val(result.reason)},
                     {"cutoff", val(result.finest.cutoff)},
                     {"beyondSmallStrain", val(result.finest.beyond_small_strain)}});
  if (const auto yield = yield_speed(meeting.encounter)) made.set("yieldSpeed", *yield);
  return made;
}

void curve(const Meeting& meeting, const std::vector<double>& speeds, double tolerance, const val& deliver) {
  std::vector<double> own;
  for (const double speed : speeds) own.push_back(own_speed(meeting.encounter, speed));
  restitution_curve(meeting.contact, own, options(tolerance), [&](std::size_t i, const Restitution& result) {
    deliver(object({{"speed", val(speeds[i])},
                    {"restitution", val(result.restitution.value)},
                    {"error", val(result.restitution.error)},
                    {"converged", val(result.converged)}}),
            i);
  });
}

std::string header(const Meeting& meeting, double slowest, double fastest, double error) {
  const double from = own_speed(meeting.encounter, slowest), to = own_speed(meeting.encounter, fastest);
  if (from >= to) {
    throw InvalidInput("speed: got " + text(slowest) + " to " + text(fastest) +
                       ", allowed a slowest speed below the fastest");
  }
  const RestitutionFunction function = restitution_function(
      meeting.contact, from, to, {.error = error, .beyond = Beyond::clamp, .threads = 1, .poll = say_alive});
  TableLabel label{.unit = meeting.unit_name(Dimension::speed), .scale = meeting.unit(Dimension::speed)};
  label.provenance = {"stoss " + std::string(version()) + ": table", name(meeting.contact.at(0)),
                      "speed[" + label.unit + "]: " + text(slowest) + ":" + text(fastest), "error: " + text(error)};
  return c_header(function, label);
}

}  // namespace stoss::web
