#include "input/inputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>

#include "process/process.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/encounter/modal_file.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/encounter/visible.hpp"
#include "stoss/errors.hpp"
#include "stoss/prediction/prediction.hpp"

namespace stoss::cli {
namespace {

/// " c (with a material m/s)", or the unit that it always has.
std::string units_in_words(const Input& its) {
  if (its.dimension == Dimension::none) return its.unit.empty() ? "" : fmt::format(" {}", its.unit);
  return fmt::format(" {} (with a material {})", unit_name(its.dimension, UnitSystem::sphere),
                     unit_name(its.dimension, UnitSystem::sphere_si));
}

/// As typed or by default; null where it is neither, or given by another option in its place.
nlohmann::ordered_json described(const CLI::Option& option, const Use& use) {
  if (option.count() == 0) {
    const auto is_given = [](const CLI::Option* other) { return other->count() > 0; };
    const auto& others = option.get_excludes();
    if (!use.usual || std::any_of(others.begin(), others.end(), is_given)) return nullptr;
    return use.form == Form::whole ? nlohmann::ordered_json(std::llround(*use.usual))
                                   : nlohmann::ordered_json(*use.usual);
  }
  std::string text = option.results().front();
  std::erase(text, ' ');
  if (use.form == Form::whole) return parse_integer("", text);
  const bool single = use.form != Form::range && text.find_first_of(",:") == std::string::npos;
  return single ? nlohmann::ordered_json(parse_number("", text)) : nlohmann::ordered_json(text);
}

/// A body of a file by what tells it from others.
nlohmann::ordered_json without_modes(const std::string& name, const std::string& text) {
  std::uint64_t digest = 14695981039346656037U;  // Fowler, Noll and Vo
  for (const char c : text) digest = (digest ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return {{"name", name}, {"digest", fmt::format("{:016x}", digest)}};
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

double own_value(const Input& input, double value, const Units& units) {
  return in_own_units(input, value, units.si, system_of(units));
}

std::vector<double> series_of(const Input& input, const std::string& text, const Units& units) {
  return series_in_own_units(input, text, units.si, system_of(units));
}

Ends ends_of(const Input& input, const std::string& text, const Units& units) {
  const std::string name(input.name);
  const std::vector<std::string> parts = split(text, ':');
  const std::string got = fmt::format("'{}'", shortened(text));
  if (parts.size() != 2) throw InvalidInput::out_of_range(name, got, "LOW:HIGH, as in 0.01:1");
  const double low = parse_number(name, parts[0]), high = parse_number(name, parts[1]);
  if (!(low < high)) throw InvalidInput::out_of_range(name, got, "a lower end below the higher one");
  return {{low, high}, {own_value(input, low, units), own_value(input, high, units)}};
}

Provenance provenance(const CLI::App& command, const Encounter& encounter) {
  Provenance made{command.get_name(), command_line(), nlohmann::ordered_json::parse(to_json(encounter))};
  auto& all = made.inputs;
  all.erase("format");
  for (const auto& [name, of] : {std::pair{"first", &encounter.first}, std::pair{"against", &encounter.against}}) {
    if (of->modal) all[name]["body"] = without_modes(of->modal->name, to_json(*of->modal));
  }
  const Units units = units_of(encounter);
  const auto question = std::find_if(questions().begin(), questions().end(),
                                     [&](const auto& each) { return each.second == command.get_name(); });
  if (question == questions().end()) return made;
  for (const Input& each : inputs()) {
    const Use* use = each.use(question->first);
    if (use == nullptr) continue;
    const auto value = described(*command.get_option("--" + option_of(each.name)), *use);
    if (value.is_null()) continue;
    const std::string_view unit =
        each.dimension == Dimension::none || !units.si ? each.unit : unit_name(each.dimension, units.in_si);
    all[unit.empty() ? std::string(each.name) : fmt::format("{}[{}]", each.name, unit)] = value;
  }
  return made;
}

void ApproachOptions::add_to(CLI::App& command, Question of, const std::string& group) {
  question = of;
  CLI::Option* of_speed = add_input(command, of, "speed", speed, group);
  add_input(command, of, "height", height, group)->excludes(of_speed);
}

void ApproachOptions::require_given(const Units& units) const {
  if (speed.empty() && height.empty()) throw CLI::RequiredError("--speed or --height");
  if (!height.empty() && !units.si) {
    throw InvalidInput::conflict("height", "needs a body with a material", "or give --speed in c of the body");
  }
}

std::vector<double> ApproachOptions::series(const Units& units) const {
  require_given(units);
  const Input& its = input(question, "speed");
  if (height.empty()) return series_of(its, speed, units);
  std::vector<double> speeds = series_of(input(question, "height"), height, units);
  for (double& each : speeds) each = own_value(its, speed_of_drop(each), units);
  return speeds;
}

double ApproachOptions::one(const Units& units, const std::string& note) const {
  const std::vector<double> speeds = series(units);
  if (speeds.size() == 1) return speeds.front();
  throw InvalidInput::out_of_range(height.empty() ? "speed" : "height", fmt::format("{} numbers", speeds.size()), "one",
                                   note);
}

Ends ApproachOptions::ends(const Units& units) const {
  require_given(units);
  const Input& its = input(question, "speed");
  if (height.empty()) return ends_of(its, speed, units);
  const Ends heights = ends_of(input(question, "height"), height, units);
  const double slowest = speed_of_drop(heights.typed.first), fastest = speed_of_drop(heights.typed.second);
  return {{slowest, fastest}, {own_value(its, slowest, units), own_value(its, fastest, units)}};
}

void refuse_word(const std::string& option, const std::string& got, const std::vector<std::string>& allowed,
                 const std::string& where) {
  const std::string similar = nearest(got, allowed);
  const std::string names = allowed.empty() ? "none" : fmt::format("{}", fmt::join(allowed, ", "));
  throw InvalidInput::out_of_range(
      fmt::format("{}", option), fmt::format("'{}'", shortened(got)),
      fmt::format("{}{}{}", names, where, similar.empty() ? "" : fmt::format(", did you mean {}?", similar)));
}

std::vector<std::pair<std::string, std::string>> parse_keys(const std::string& option,
                                                            const std::vector<std::string>& parts, std::size_t first,
                                                            const std::vector<std::string>& keys,
                                                            const std::string& where) {
  std::vector<std::pair<std::string, std::string>> found;
  for (std::size_t i = first; i < parts.size(); ++i) {
    const auto equals = parts[i].find('=');
    const std::string key = without_spaces(parts[i].substr(0, equals));
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) refuse_word(option, key, keys, where);
    if (equals == std::string::npos) {
      throw InvalidInput::out_of_range(fmt::format("{}", option), fmt::format("'{}' without a value", key),
                                       fmt::format("{}=NUMBER", key));
    }
    if (std::any_of(found.begin(), found.end(), [&](const auto& each) { return each.first == key; })) {
      throw InvalidInput::out_of_range(fmt::format("{}", option), fmt::format("{} twice", key), "once");
    }
    found.emplace_back(key, parts[i].substr(equals + 1));
  }
  return found;
}

}  // namespace stoss::cli
