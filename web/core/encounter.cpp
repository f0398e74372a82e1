#include "encounter.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

#include "javascript.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/encounter/materials.hpp"

namespace stoss::web {
namespace {

using emscripten::val;
using Json = nlohmann::ordered_json;

/// @param unit that of the modulus
val elastic(const Solid& solid, double unit) {
  val made = val::object();
  std::visit(
      [&](const auto& its) {
        made.set("young", its.young / unit);
        if constexpr (requires { its.poisson; }) made.set("poisson", its.poisson);
      },
      solid);
  return made;
}

Json described(const Parameter& of) {
  Json json{{"name", of.name}, {"unit", of.unit}, {"ofMaterial", of.of_material}, {"help", of.help}, {"low", of.low}};
  json["lowIncluded"] = of.low_included;
  if (std::isfinite(of.high)) json["high"] = of.high;
  if (of.otherwise) json["otherwise"] = *of.otherwise;
  return json;
}

Json described(const Kind& kind) {
  Json json{{"name", kind.name}, {"help", kind.help}, {"wall", kind.wall}, {"bounded", kind.bounded}};
  json["canYield"] = kind.can_yield;
  json["hasPlane"] = kind.has_plane;
  json["length"] = unit_name(Dimension::length, kind.own);
  json["parameters"] = Json::array();
  for (const Parameter& each : kind.parameters) json["parameters"].push_back(described(each));
  json["meets"] = Json::array();
  for (const Kind& other : kinds()) {
    if (!other.wall && meets(kind, other)) json["meets"].push_back(other.name);
  }
  return json;
}

Json described(const NamedMaterial& named) {
  const Material& its = named.material;
  Json json{{"name", named.name}, {"young", its.young}, {"poisson", its.poisson}, {"density", its.density}};
  json["loss_time"] = its.loss_time.value_or(0.0);
  if (its.yield_strength) json["yield_strength"] = *its.yield_strength;
  json["source"] = named.source;
  return json;
}

}  // namespace

Meeting::Meeting(const std::string& document)
    : encounter(encounter_from_json(document)),
      first(first_solid(encounter)),
      second(second_solid(encounter)),
      si(si_scales(encounter)),
      contact(refinable(encounter)) {}

bool Meeting::against_half_space() const {
  return second && (std::holds_alternative<HalfSpace>(*second) || std::holds_alternative<HalfPlane>(*second));
}

std::string Meeting::unit_name(Dimension dimension) const {
  return std::string(stoss::unit_name(dimension, unit_system(encounter)));
}

std::string Meeting::own_unit_name(Dimension dimension) const {
  return std::string(stoss::unit_name(dimension, kind(encounter.first.kind).own));
}

val units(const Meeting& meeting) {
  constexpr double fewest_modes = 4.0;  // cutoff, c/R
  constexpr double quick = 0.5;         // c
  using enum Dimension;
  // The ratios of two bodies are checked where they meet; of the fewest modes that is soon done.
  if (meeting.second) (void)contact_of(meeting.encounter, fewest_modes, quick);
  // A rod in SI keeps its numbers.
  const auto* rod = std::get_if<Rod>(&meeting.first);
  const double modulus = rod != nullptr ? rod->young : 1.0;
  val made = object({{"speed", val(meeting.unit(speed))},
                     {"time", val(meeting.unit(time))},
                     {"frequency", val(meeting.unit(frequency))},
                     {"first", elastic(meeting.first, modulus)}});
  if (meeting.si) made.set("modulus", meeting.encounter.first.material->density * std::pow(meeting.unit(speed), 2));
  if (meeting.second) made.set("second", elastic(*meeting.second, modulus));
  return made;
}

std::string table_of_kinds() {
  Json table{{"kinds", Json::array()}, {"materials", Json::array()}};
  for (const Kind& each : kinds()) table["kinds"].push_back(described(each));
  for (const NamedMaterial& each : named_materials()) table["materials"].push_back(described(each));
  return table.dump(2);
}

}  // namespace stoss::web
