#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "questions.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/quantity.hpp"

/// What the page gets of a result.
namespace stoss::web {

/// Adds a quantity by a name, if it is a number. @param unit in which it is given to the page
template <typename Result>
void put(emscripten::val& all, const std::string& name, const Quantity<Result>& quantity, const Result& result,
         UnitSystem system, double unit = 1.0) {
  using emscripten::val;
  const Value value = quantity.value(result);
  const auto* real = std::get_if<double>(&value);
  const auto* count = std::get_if<std::int64_t>(&value);
  if (real == nullptr && count == nullptr) return;
  const double number = real != nullptr ? *real : static_cast<double>(*count);
  const std::string called(unit_name(quantity.dimension, system));
  val made = object({{"value", number * unit}, {"unit", called}, {"help", quantity.help}});
  if (quantity.error) made.set("error", quantity.error(result) * unit);
  all.set(name, made);
}

/// Adds what is a number, by the names of the command: with a material in units of the first body and in SI.
template <typename Result>
void add(emscripten::val& all, const Encounter& encounter, const std::optional<Scales>& si,
         const Quantities<Result>& quantities, const Result& result) {
  for (const auto& each : quantities) {
    put(all, each.name, each, result, kind(encounter.first.kind).own);
    if (!si || each.dimension == Dimension::none || each.name == "cutoff") continue;
    put(all, each.name + "_si", each, result, unit_system(encounter), unit_in_si(each.dimension, *si));
  }
}
template <typename Result>
void add(emscripten::val& all, const Meeting& meeting, const Quantities<Result>& quantities, const Result& result) {
  add(all, meeting.encounter, meeting.si, quantities, result);
}

/// Restitution of the protocol. @param speed as the page gave it @param finest impact of the result
template <typename Result>
emscripten::val answer(const Meeting& meeting, double speed, const emscripten::val& quantities, const Result& result,
                       const Impact& finest) {
  using emscripten::val;
  val made = object({{"speed", speed},
                     {"quantities", quantities},
                     {"converged", result.converged},
                     {"reason", result.reason},
                     {"cutoff", finest.cutoff},
                     {"note", finest.remaining > 0.0 ? note_of_staying() : std::string()},
                     {"beyondSmallStrain", finest.beyond_small_strain}});
  if (const auto yield = yield_speed(meeting.encounter)) made.set("yieldSpeed", *yield);
  if (const std::string said = yield_warning(meeting.encounter, speed); !said.empty()) made.set("yieldWarning", said);
  std::vector<std::string> lines = shell_warnings(meeting.encounter, speed);
  for (std::string& line : sound_warnings(meeting.encounter)) lines.push_back(std::move(line));
  made.set("materialWarnings", list(lines, [](const std::string& line) { return val(line); }));
  return made;
}

}  // namespace stoss::web
