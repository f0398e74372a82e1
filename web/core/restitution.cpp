#include "restitution.hpp"

#include "alive.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/restitution/quantities.hpp"
#include "stoss/table/adaptive.hpp"
#include "stoss/table/c_source.hpp"
#include "stoss/version.hpp"
#include "text.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

val quantity(double value, const double* error, const std::string& unit, double scale) {
  val made = val::object();
  made.set("value", value * scale);
  made.set("unit", unit);
  if (error != nullptr) made.set("error", *error * scale);
  return made;
}

/// What is a number, by the names of the command: with a material in units of the first body and in SI.
val quantities(const Encounter& encounter, const Restitution& result) {
  val all = val::object();
  for (const auto& each : restitution_quantities()) {
    const Value value = each.value(result);
    const auto* real = std::get_if<double>(&value);
    const auto* count = std::get_if<long>(&value);
    if (real == nullptr && count == nullptr) continue;
    const double number = real != nullptr ? *real : static_cast<double>(*count);
    const double error = each.error ? each.error(result) : 0.0;
    const double* const its_error = each.error ? &error : nullptr;
    all.set(each.name, quantity(number, its_error, encounter.own_unit_name(each.dimension), 1.0));
    if (!encounter.si() || each.dimension == Dimension::none || each.dimension == Dimension::frequency) continue;
    all.set(each.name + "_si",
            quantity(number, its_error, encounter.unit_name(each.dimension), encounter.unit(each.dimension)));
  }
  return all;
}

CurveOptions options(double tolerance) { return {.each = {.tolerance = tolerance, .poll = say_alive}, .threads = 1}; }

}  // namespace

val restitution(const Encounter& encounter, double speed, double tolerance) {
  const std::vector<double> speeds{encounter.own_speed(speed)};
  const Restitution result = restitution_curve(encounter.refinable(), speeds, options(tolerance)).front();
  val made = val::object();
  made.set("speed", speed);
  made.set("quantities", quantities(encounter, result));
  made.set("converged", result.converged);
  made.set("reason", result.reason);
  made.set("cutoff", result.finest.cutoff);
  made.set("beyondSmallStrain", result.finest.beyond_small_strain);
  if (const auto yield = encounter.yield_speed()) made.set("yieldSpeed", *yield);
  return made;
}

void curve(const Encounter& encounter, const std::vector<double>& speeds, double tolerance, const val& deliver) {
  std::vector<double> own;
  for (const double speed : speeds) own.push_back(encounter.own_speed(speed));
  restitution_curve(encounter.refinable(), own, options(tolerance), [&](std::size_t i, const Restitution& result) {
    val point = val::object();
    point.set("speed", speeds[i]);
    point.set("restitution", result.restitution.value);
    point.set("error", result.restitution.error);
    point.set("converged", result.converged);
    deliver(point, i);
  });
}

std::string header(const Encounter& encounter, double slowest, double fastest, double error) {
  const double from = encounter.own_speed(slowest), to = encounter.own_speed(fastest);
  if (from >= to) {
    throw InvalidInput("speed: got " + text(slowest) + " to " + text(fastest) +
                       ", allowed a slowest speed below the fastest");
  }
  const RestitutionFunction function = restitution_function(
      encounter.refinable(), from, to, {.error = error, .beyond = Beyond::clamp, .threads = 1, .poll = say_alive});
  TableLabel label{.unit = encounter.unit_name(Dimension::speed), .scale = encounter.unit(Dimension::speed)};
  label.provenance = {"stoss " + std::string(version()) + ": table", name(encounter.refinable().at(0)),
                      "speed[" + label.unit + "]: " + text(slowest) + ":" + text(fastest), "error: " + text(error)};
  return c_header(function, label);
}

}  // namespace stoss::web
