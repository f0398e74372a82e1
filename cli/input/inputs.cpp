#include "input/inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "process/text.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/encounter/visible.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

/// " c (with a material m/s)", or the unit that it always has.
std::string units_in_words(const Input& its) {
  if (its.dimension == Dimension::none) return its.unit.empty() ? "" : fmt::format(" {}", its.unit);
  return fmt::format(" {} (with a material {})", unit_name(its.dimension, UnitSystem::sphere),
                     unit_name(its.dimension, UnitSystem::sphere_si));
}

UnitSystem system_of(const Units& units) { return units.si ? units.in_si : units.own; }

}  // namespace

std::string option_of(std::string_view input) {
  std::string name(input);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::string help_of(const Input& input, Question question) {
  const Use& use = *input.use(question);
  std::string text = fmt::format("{}, {}{}", input.help, input.range, units_in_words(input));
  if (use.form == Form::series) text += ": a number, a,b,c, log:a:b:n or lin:a:b:n";
  if (use.usual) text += fmt::format(" (default: {:g})", *use.usual);
  return text;
}

std::string placeholder_of(const Input& input, Question question) {
  const Form form = input.use(question)->form;
  if (form == Form::range) return "LOW:HIGH";
  std::string name = option_of(input.name);
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return form == Form::series ? name + "S" : name;
}

double own_value(Question question, std::string_view name, double value, const Units& units) {
  return in_own_units(input(question, name), value, units.si, system_of(units));
}

std::vector<double> series_of(Question question, std::string_view name, const std::string& text, const Units& units) {
  std::vector<double> values = parse_series(name, text);
  for (double& value : values) value = own_value(question, name, value, units);
  return values;
}

double number_of(Question question, std::string_view name, const std::string& text, const Units& units,
                 const std::string& note) {
  const std::vector<double> values = series_of(question, name, text, units);
  if (values.size() == 1) return values.front();
  throw InvalidInput::out_of_range(std::string(name), fmt::format("{} numbers", values.size()), "one", note);
}

Ends ends_of(Question question, std::string_view name, const std::string& text, const Units& units) {
  const std::vector<std::string> parts = split(text, ':');
  const std::string got = fmt::format("'{}'", shortened(text));
  if (parts.size() != 2) throw InvalidInput::out_of_range(std::string(name), got, "LOW:HIGH, as in 0.01:1");
  const double low = parse_number(name, parts[0]), high = parse_number(name, parts[1]);
  if (!(low < high)) throw InvalidInput::out_of_range(std::string(name), got, "a lower end below the higher one");
  return {{low, high}, {own_value(question, name, low, units), own_value(question, name, high, units)}};
}

}  // namespace stoss::cli
