// The options that say who meets whom.
#include "input/encounter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <map>

#include "app.hpp"
#include "input/words.hpp"
#include "process/text.hpp"
#include "stoss/encounter/modal_file.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

/// The keys of a kind as --against has them.
std::vector<std::string> keys_of(const Kind& its) {
  std::vector<std::string> keys;
  for (const Parameter& each : its.parameters) keys.emplace_back(each.name);
  if (its.can_yield) keys.emplace_back("yield");
  if (its.can_be_rigid) keys.emplace_back("rigid");
  if (!its.wall) keys.emplace_back("material");
  return keys;
}

/// Its help: name, keys, and what it is.
std::string lines_of(const Kind& its) {
  const std::vector<std::string> keys = keys_of(its);
  std::string with = keys.empty() ? "" : fmt::format(";\n   keys {}", fmt::join(keys, ", "));
  if (its.add_layer) with += "\n   and layers below, as /KEY=NUMBER,...; the last may be a block";
  return fmt::format("\n  {}: {}{}", its.name, its.help, with);
}

/// The keys of a further layer of one.
std::vector<std::string> layer_keys_of(const Kind& its) {
  std::vector<std::string> keys;
  for (const Parameter& each : its.parameters) {
    if (is_of_layer(each)) keys.emplace_back(each.name);
  }
  keys.emplace_back("material");
  return keys;
}

/// What the parts key=value from one on say of a kind, or of one of its layers.
/// @param first of which the Poisson's ratio is that of a material without its own
Participant parse_numbers(const Kind& its, const std::vector<std::string>& parts, std::size_t from,
                          const std::vector<std::string>& keys, const Participant& first) {
  const std::string name(its.name);
  Participant against{.kind = name, .plane = first.plane};
  std::optional<double> yield;
  for (const auto& [key, value] : parse_keys("against", parts, from, keys, " with " + name)) {
    if (key == "material") {
      against.material_name = without_spaces(value);
    } else if (const double number = parse_number("against " + key, value); key == "yield") {
      yield = number;
    } else if (key == "rigid") {
      if (number != 0.0 && number != 1.0) {
        throw InvalidInput::out_of_range("against rigid", shortened(value), "0 or 1", "1 of a rigid body");
      }
      against.rigid = number == 1.0;
    } else {
      against.values[key] = number;
    }
  }
  const bool in_si = first.material || yield || !against.material_name.empty();
  if (in_si && !its.wall && meets(kind(first.kind), its)) {
    set_material(against, yield, first.material ? first.material->poisson : 0.0, "against");
  }
  return against;
}

/// What --against says: KIND[,key=value…], with the numbers of further layers after slashes.
/// @throws InvalidInput for an unknown kind or key, a key that comes twice, and what is no number
Participant parse_against(const std::string& text, const Participant& first) {
  if (names_file(text)) return modal_from_file("against", text);
  const std::vector<std::string> layers = split(text, '/');
  const std::vector<std::string> parts = split(layers.front(), ',');
  std::vector<std::string> names;
  for (const Kind& each : kinds()) {
    if (!each.from_file) names.emplace_back(each.name);
  }
  const std::string name = without_spaces(parts.front());
  if (std::find(names.begin(), names.end(), name) == names.end()) refuse_word("against", name, names);
  const Kind& its = kind(name);
  Participant against = parse_numbers(its, parts, 1, keys_of(its), first);
  for (std::size_t i = 1; i < layers.size(); ++i) {
    against.below.push_back(parse_numbers(its, split(layers[i], ','), 0, layer_keys_of(its), first));
  }
  return against;
}

using Json = nlohmann::ordered_json;

/// As the core computes with it.
std::optional<double> poisson_of(const Solid& solid) {
  return std::visit(
      [](const auto& of) -> std::optional<double> {
        if constexpr (requires { of.poisson; }) return of.poisson;
        return std::nullopt;
      },
      solid);
}

bool is_size(const Parameter& parameter) { return !parameter.of_material && parameter.name != "loss_time"; }

/// A body of a file: what it is, and what tells it from others.
void describe_modal(const std::string& prefix, const ModalBody& its, Json& inputs) {
  inputs[prefix + "name"] = its.name;
  if (!its.origin.empty()) inputs[prefix + "origin"] = its.origin;
  inputs[prefix + "mass[kg]"] = its.mass;
  inputs[prefix + "modes"] = its.modes.size();
  std::uint64_t digest = 14695981039346656037U;  // Fowler, Noll and Vo
  for (const char c : to_json(its)) digest = (digest ^ static_cast<unsigned char>(c)) * 1099511628211U;
  inputs[prefix + "digest"] = fmt::format("{:016x}", digest);
}

/// A material and the sizes that go with it. @param prefix of the names
void describe_in_si(const std::string& prefix, const Participant& of, Json& inputs) {
  if (of.modal) describe_modal(prefix, *of.modal, inputs);
  const Kind& its = kind(of.kind);
  if (!of.material_name.empty()) inputs[prefix + "material"] = of.material_name;
  inputs[prefix + "material_young[Pa]"] = of.material->young;
  if (its.has_plane) inputs[prefix + "material_poisson"] = of.material->poisson;
  inputs[prefix + "material_density[kg/m^3]"] = of.material->density;
  if (of.material->yield_strength && its.can_yield)
    inputs[prefix + "material_yield[Pa]"] = *of.material->yield_strength;
  for (const Parameter& each : its.parameters) {
    const auto size = of.values.find(each.name);
    if (is_size(each) && size != of.values.end()) {
      inputs[fmt::format("{}{}[{}]", prefix, each.name, each.unit)] = size->second;
    }
  }
}

/// As ratios to the first body.
void describe_ratios(const std::string& prefix, const Participant& of, Json& inputs) {
  for (const Parameter& each : kind(of.kind).parameters) {
    if (each.name == "loss_time") continue;
    const auto found = of.values.find(each.name);
    Json& value = inputs[prefix + std::string(each.name)];
    if (found != of.values.end()) {
      value = found->second;
    } else if (each.otherwise) {
      value = *each.otherwise;
    } else {
      value = each.of_material ? "as the first" : "without end";
    }
  }
}

void describe_against(const Encounter& encounter, Json& inputs) {
  const Participant& against = encounter.against;
  if (kind(against.kind).wall) return describe_ratios("against_", against, inputs);
  if (const auto found = against.values.find("loss_time"); found != against.values.end()) {
    inputs[against.material ? "against_loss_time[s]" : "against_loss_time"] = found->second;
  }
  if (against.material) {
    if (const auto its = poisson_of(*second_solid(encounter))) inputs["against_poisson"] = *its;
    describe_in_si("against_", against, inputs);
  } else {
    describe_ratios("against_", against, inputs);
  }
  for (std::size_t i = 0; i < against.below.size(); ++i) {
    const std::string prefix = fmt::format("against_layer_{}_", i + 2);
    const Participant& layer = against.below[i];
    if (!layer.material) {
      describe_ratios(prefix, layer, inputs);
      continue;
    }
    inputs[prefix + "poisson"] = layer.material->poisson;
    describe_in_si(prefix, layer, inputs);
  }
}

}  // namespace

void EncounterOptions::add_to(CLI::App& to, bool exponential, const std::string& note) {
  first.add_kind_to(to, {"sphere", "disk", "rod"}, true);
  first.add_dynamics_to(to);
  first.add_material_to(to, true);
  std::string help =
      "What the body meets (default: wall); numbers in units of the first, or\nin SI if it has a material";
  std::vector<std::string_view> names;
  for (const Kind& its : kinds()) {
    if (its.from_file || (its.name == "exponential" && !exponential)) continue;
    help += lines_of(its);
    names.push_back(its.name);
  }
  help += "\n  @FILE: " + std::string(kind("modal").help);
  const std::string type = fmt::format("{{{}}}[,KEY=VALUE]...", fmt::join(names, ","));
  add(to, "--against", against, help + note, type, "Against");
}

Encounter EncounterOptions::encounter() const {
  Encounter encounter{.first = first.body()};
  encounter.against = parse_against(against, encounter.first);
  encounter.vibration = vibration_of(modes);
  validate(encounter);
  return encounter;
}

void refuse_tail(const CLI::App& command, const Encounter& encounter) {
  if (!is_soft(encounter) || !given(command, "--tail")) return;
  throw InvalidInput::out_of_range("tail", "a tail with --against exponential", "only without",
                                   "the soft wall leaves it out");
}

void refuse_soft(const Encounter& encounter, const std::string& hint) {
  if (is_soft(encounter)) throw InvalidInput::out_of_range("against", "exponential", "wall, same or a body" + hint);
}

std::optional<double> poisson_of(const Encounter& encounter) { return poisson_of(first_solid(encounter)); }

void describe_first(const Encounter& encounter, Json& inputs) {
  const Participant& first = encounter.first;
  inputs["body"] = first.kind;
  if (const auto its = poisson_of(encounter)) inputs["poisson"] = *its;
  const auto si = si_scales(encounter);
  if (!si) return;
  describe_in_si("", first, inputs);
  if (kind(first.kind).has_plane) inputs["plane"] = first.plane == Plane::strain ? "strain" : "stress";
  inputs["c[m/s]"] = si->speed;
  inputs[fmt::format("{}[s]", unit_name(Dimension::time, kind(first.kind).own))] = si->time;
}

void describe(const Encounter& encounter, Json& inputs) {
  describe_first(encounter, inputs);
  const Participant& first = encounter.first;
  if (first.rigid) inputs["rigid_body"] = true;
  if (const auto found = first.values.find("loss_time"); found != first.values.end() && found->second != 0.0) {
    inputs[first.material ? "loss_time[s]" : "loss_time"] = found->second;
  }
  inputs["against"] = encounter.against.kind;
  if (encounter.against.rigid) inputs["against_rigid"] = true;
  describe_against(encounter, inputs);
  describe(encounter.vibration, inputs);
}

}  // namespace stoss::cli
