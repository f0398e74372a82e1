// The options that say who meets whom.
#include "input/encounter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "input/options.hpp"
#include "input/words.hpp"
#include "process/text.hpp"
#include "stoss/encounter/materials.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

/// The keys of a kind as --against has them.
std::vector<std::string> keys_of(const Kind& its) {
  std::vector<std::string> keys;
  for (const Parameter& each : its.parameters) keys.emplace_back(each.name);
  if (its.can_yield) keys.emplace_back("yield");
  if (!its.wall) keys.emplace_back("material");
  return keys;
}

/// Its help: name, keys, and what it is.
std::string lines_of(const Kind& its) {
  const std::vector<std::string> keys = keys_of(its);
  const std::string with = keys.empty() ? "" : fmt::format(";\n    keys {}", fmt::join(keys, ", "));
  return fmt::format("\n  {}: {}{}", its.name, its.help, with);
}

std::string shown_kinds(bool exponential) {
  std::vector<std::string> names;
  for (const Kind& its : kinds()) {
    if (exponential || its.name != "exponential") names.emplace_back(its.name);
  }
  return fmt::format("{}", fmt::join(names, ","));
}

/// The material of a second body in SI, of what was given of it.
/// @param solid Poisson's ratio that it has without its own
Material second_material(const Kind& its, const Values& given, const std::string& name, double solid) {
  const auto number = [&given](const char* key) {
    const auto found = given.find(key);
    return found == given.end() ? std::nullopt : std::optional(found->second);
  };
  Material made;
  if (name.empty()) {
    for (const Parameter& each : its.parameters) {
      const bool needed = each.name != "poisson" && each.name != "loss_time";
      if (needed && !given.contains(each.name)) {
        std::vector<std::string> all;
        for (const Parameter& every : its.parameters) {
          if (every.name != "poisson" && every.name != "loss_time") all.emplace_back(every.name);
        }
        throw InvalidInput(fmt::format("against: got {} without {}, allowed all of {}, in SI as the first", its.name,
                                       each.name, fmt::join(all, ", ")));
      }
    }
    made = {*number("young"), number("poisson").value_or(solid), *number("density")};
  } else {
    for (const char* key : {"poisson", "young", "density"}) {
      if (number(key)) {
        throw InvalidInput(
            fmt::format("against: got {} with material, allowed only without (the material has one)", key));
      }
    }
    made = named_material(name);
  }
  if (number("yield")) made.yield_strength = number("yield");
  return made;
}

}  // namespace

void EncounterOptions::add_to(CLI::App& to, bool exponential, const std::string& note) {
  first.add_kind_to(to, {"disk", "sphere", "rod"});
  first.add_dynamics_to(to);
  first.add_material_to(to, true);
  std::string help =
      "What the body meets (default: wall); numbers in units of the first, or\nin SI if it has a material";
  for (const Kind& its : kinds()) {
    if (exponential || its.name != "exponential") help += lines_of(its);
  }
  add(to, "--against", against, help + note, "{" + shown_kinds(exponential) + "}[,KEY=NUMBER]...", "Against");
}

Participant parse_against(const std::string& text, const Participant& first) {
  const std::vector<std::string> parts = split(text, ',');
  std::vector<std::string> names;
  for (const Kind& each : kinds()) names.emplace_back(each.name);
  const std::string name = without_spaces(parts.front());
  if (std::find(names.begin(), names.end(), name) == names.end()) refuse_word("against", name, names);
  const Kind& its = kind(name);
  Participant against{.kind = name};
  for (const auto& [key, value] : parse_keys("against", parts, 1, keys_of(its), " with " + name)) {
    if (key == "material") {
      against.material_name = without_spaces(value);
    } else {
      against.values[key] = parse_number("against " + key, value);
    }
  }
  if (its.wall || !meets(kind(first.kind), its)) return against;
  if (!first.material) {
    if (against.values.contains("yield")) {
      throw InvalidInput("against: got yield without a material, allowed only with --young, --density, --radius");
    }
    if (!against.material_name.empty()) {
      throw InvalidInput(
          "against: got material without one of the first body, allowed only with --material, or --young, --density "
          "and a size");
    }
    return against;
  }
  against.plane = first.plane;
  against.material = second_material(its, against.values, against.material_name, first.material->poisson);
  if (against.values.contains("yield")) against.material_name.clear();
  for (const char* key : {"poisson", "young", "density", "yield"}) against.values.erase(key);
  return against;
}

Encounter EncounterOptions::encounter() const {
  Encounter encounter{.first = first.body()};
  encounter.against = parse_against(against, encounter.first);
  validate(encounter);
  return encounter;
}

void refuse_tail(const CLI::App& command, const Encounter& encounter) {
  if (!is_soft(encounter) || !given(command, "--tail")) return;
  throw InvalidInput("tail: got a tail with --against exponential, allowed only without (the soft wall leaves it out)");
}

void refuse_soft(const Encounter& encounter, const std::string& hint) {
  if (is_soft(encounter)) throw InvalidInput("against: got exponential, allowed wall, same or a body" + hint);
}

double poisson_of(const Solid& solid) {
  return std::visit(
      [](const auto& of) {
        if constexpr (requires { of.poisson; }) {
          return of.poisson;
        } else {
          return 0.0;
        }
      },
      solid);
}

}  // namespace stoss::cli
