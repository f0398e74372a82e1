// What the core knows of kinds, materials, quantities and documents.
#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>
#include <vector>

#include "questions.hpp"
#include "stoss/encounter/inputs.hpp"
#include "stoss/encounter/materials.hpp"
#include "stoss/encounter/schema.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/prediction/quantities.hpp"
#include "stoss/restitution/quantities.hpp"
#include "stoss/row/quantities.hpp"

namespace stoss {

using Json = nlohmann::ordered_json;

static void to_json(Json& json, const Parameter& of) {
  json = {{"name", of.name}, {"unit", of.unit}, {"ofMaterial", of.of_material}, {"help", of.help}};
  if (of.default_value) json["otherwise"] = *of.default_value;
  if (std::isfinite(of.high)) json["most"] = of.high;
  // The field shows the range of what must be given.
  if (!of.of_material && !of.default_value && of.low_included) json["least"] = of.low;
}

/// What is no number of a body, but a list of them.
static Json relaxation() {
  return {{"name", "relaxation"},
          {"unit", "s"},
          {"ofMaterial", false},
          {"otherwise", 0},
          {"help", "shares of the modulus E(0) that relax, and their times, as in 0.5:1+0.2:10"}};
}

static void to_json(Json& json, const Kind& kind) {
  json = {{"name", kind.name},           {"help", kind.help},
          {"solid", !kind.wall},         {"bounded", kind.bounded},
          {"canYield", kind.can_yield},  {"hasPlane", kind.has_plane},
          {"fromFile", kind.from_file},  {"length", unit_name(Dimension::length, kind.own)},
          {"parameters", Json::array()}, {"meets", Json::array()}};
  for (const Parameter& each : kind.parameters) {
    // The page has smooth walls, balls without further mass, of a body the rms height of its asperities, and a strength
    // at any rate.
    const bool left_out = each.name == "u0" || each.name == "extra_mass" ||
                          (each.name.starts_with("yield_") && each.name != "yield_strength") ||
                          (kind.wall && is_of_face(each.name));
    if (!left_out) json["parameters"].push_back(Json(each));
  }
  if (!kind.wall) json["parameters"].push_back(relaxation());
  for (const Kind& other : kinds()) {
    if (!other.wall && meets(kind, other)) json["meets"].push_back(other.name);
  }
}

/// Ranges in words of what says how bodies meet, where they are the same in all units.
static Json ranges_of_motions() {
  Json ranges = Json::object();
  for (const Input& each : inputs()) {
    if (each.use(Question::oblique) && each.dimension == Dimension::none) ranges[std::string(each.name)] = each.range;
  }
  return ranges;
}

/// Q at the frequency of the modulus, to four digits: by it the page tells the loss of a named material, which the core
/// knows, from one that was typed. 0 where none is known.
static double quality_there(const Material& its) {
  if (!its.relaxation) return its.quality.value_or(0.0);
  const std::complex<double> there = modulus(*its.relaxation, {0.0, its.frequency});
  constexpr double digits = 1e3;
  return std::round(digits * there.real() / there.imag()) / digits;
}

static void to_json(Json& json, const NamedMaterial& named) {
  const Material& its = named.material;
  json = {{"name", named.name}, {"young", its.young}, {"poisson", its.poisson}, {"density", its.density}};
  json["quality"] = quality_there(its);
  if (its.yield_strength) json["yield_strength"] = *its.yield_strength;
  json["source"] = named.source;
}

namespace web {
namespace {

using emscripten::val;

/// The schema of documents, of which web/plugins/documents.mjs makes their types.
val schema(const Question&) { return val(encounter_schema()); }

/// The quantities of answers with what they are, as JSON: web/plugins/kinds.mjs makes their types.
val quantities(const Question&) {
  Json all;
  const auto add = [&](const auto& table) {
    for (const auto& each : table) all[each.name] = each.help;
  };
  add(row_quantities()), add(row_body_quantities()), add(row_contact_quantities());
  add(restitution_quantities()), add(oblique_quantities()), add(prediction_quantities());
  add(impact_quantities()), add(oblique_ledger_quantities());
  return val(all.dump());
}

/// Those with a quality that the page can ask for, or none: other relaxations have more terms than a field shows.
std::vector<NamedMaterial> materials_of_qualities() {
  constexpr double least = 3.0;
  std::vector<NamedMaterial> all = named_materials();
  std::erase_if(
      all, [](const NamedMaterial& each) { return each.material.relaxation && quality_there(each.material) < least; });
  return all;
}

/// The table of kinds, the named materials and ranges of inputs, as JSON: web/plugins/kinds.mjs writes them for the
/// page.
val kinds(const Question&) {
  return val(
      Json{{"kinds", stoss::kinds()}, {"materials", materials_of_qualities()}, {"ranges", ranges_of_motions()}}.dump());
}

}  // namespace

EMSCRIPTEN_BINDINGS(tables) {
  emscripten::function("schema", &answered<schema>);
  emscripten::function("quantities", &answered<quantities>);
  emscripten::function("kinds", &answered<kinds>);
}

}  // namespace web
}  // namespace stoss
