#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

#include "questions.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/encounter/inputs.hpp"
#include "stoss/encounter/materials.hpp"
#include "stoss/encounter/schema.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/prediction/quantities.hpp"
#include "stoss/restitution/quantities.hpp"
#include "stoss/version.hpp"

namespace stoss {

using Json = nlohmann::ordered_json;

static void to_json(Json& json, const Parameter& of) {
  json = {{"name", of.name}, {"unit", of.unit}, {"ofMaterial", of.of_material}, {"help", of.help}};
  if (of.default_value) json["otherwise"] = *of.default_value;
  if (std::isfinite(of.high)) json["most"] = of.high;
}

static void to_json(Json& json, const Kind& kind) {
  json = {{"name", kind.name},
          {"help", kind.help},
          {"solid", !kind.wall},
          {"bounded", kind.bounded},
          {"canYield", kind.can_yield},
          {"hasPlane", kind.has_plane},
          {"fromFile", kind.from_file},
          {"length", unit_name(Dimension::length, kind.own)},
          {"parameters", kind.parameters},
          {"meets", Json::array()}};
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

static void to_json(Json& json, const NamedMaterial& named) {
  const Material& its = named.material;
  json = {{"name", named.name}, {"young", its.young}, {"poisson", its.poisson}, {"density", its.density}};
  json["loss_time"] = its.loss_time.value_or(0.0);
  if (its.yield_strength) json["yield_strength"] = *its.yield_strength;
  json["source"] = named.source;
}

namespace web {
Meeting::Meeting(const std::string& document)
    : encounter(encounter_from_json(document)),
      first(first_solid(encounter)),
      second(second_solid(encounter)),
      si(si_scales(encounter)),
      contact(refinable(encounter)) {
  if (encounter.vibration.empty()) return;
  throw InvalidInput::out_of_range("vibration", std::to_string(encounter.vibration.size()) + " modes", "none",
                                   "the command and the Python package compute bodies that vibrate before");
}

bool Meeting::against_unbounded() const {
  const Kind& its = kind(encounter.against.kind);
  return !its.wall && !its.bounded;
}

bool Meeting::against_plate() const {
  return second && (std::holds_alternative<Plate>(*second) || std::holds_alternative<Strip>(*second));
}

bool Meeting::of_file() const { return encounter.first.modal || encounter.against.modal; }

std::string Meeting::unit_name(Dimension dimension) const {
  return std::string(stoss::unit_name(dimension, unit_system(encounter)));
}

std::shared_ptr<const Meeting> Question::meeting() const {
  constexpr std::size_t kept = 4;
  static std::vector<std::pair<std::string, std::shared_ptr<const Meeting>>> known;
  const std::string document = text("document");
  const auto found = std::find_if(known.begin(), known.end(), [&](const auto& each) { return each.first == document; });
  auto its = found != known.end() ? found->second : std::make_shared<const Meeting>(document);
  if (found != known.end()) known.erase(found);
  known.emplace_back(document, its);
  if (known.size() > kept) known.erase(known.begin());
  return its;
}

namespace {

using emscripten::val;

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

val version(const Question&) { return val(std::string(stoss::version())); }

/// The schema of documents, of which web/plugins/documents.mjs makes their types.
val schema(const Question&) { return val(encounter_schema()); }

/// The quantities of answers with what they are, as JSON: web/plugins/kinds.mjs makes their types.
val quantities(const Question&) {
  Json all;
  const auto add = [&](const auto& table) {
    for (const auto& each : table) all[each.name] = each.help;
  };
  add(restitution_quantities()), add(oblique_quantities()), add(prediction_quantities());
  add(impact_quantities()), add(oblique_ledger_quantities());
  return val(all.dump());
}

/// The table of kinds, the named materials and ranges of inputs, as JSON: web/plugins/kinds.mjs writes them for the
/// page.
val kinds(const Question&) {
  return val(Json{{"kinds", stoss::kinds()}, {"materials", named_materials()}, {"ranges", ranges_of_motions()}}.dump());
}

/// Units of the first body, and the elastic numbers of both in these. @throws InvalidInput for what cannot meet
val units(const Question& asked) {
  constexpr double fewest_modes = 4.0;  // cutoff, c/R
  constexpr double quick = 0.5;         // c
  using enum Dimension;
  const Meeting meeting(asked.text("document"));
  // The ratios of two bodies are checked where they meet; of the fewest modes that is soon done.
  if (meeting.of_file()) {
    (void)meeting.contact.at(0);
  } else if (meeting.second) {
    (void)contact_of(meeting.encounter, fewest_modes, quick);
  }
  // A rod in SI keeps its numbers.
  const auto* rod = std::get_if<Rod>(&meeting.first);
  const double modulus = rod != nullptr ? rod->young : 1.0;
  val made = object({{"speed", meeting.unit(Dimension::speed)},
                     {"time", meeting.unit(time)},
                     {"frequency", meeting.unit(frequency)},
                     {"first", elastic(meeting.first, modulus)}});
  if (meeting.si) made.set("modulus", meeting.encounter.first.material->density * std::pow(meeting.si->speed, 2));
  if (meeting.second) made.set("second", elastic(*meeting.second, modulus));
  return made;
}

/// A speed in c of the first body. @throws InvalidInput for one out of range
val speed(const Question& asked) {
  return val(speed_in_c(encounter_from_json(asked.text("document")), asked.number("speed")));
}

/// What a text stands for, as the command reads it. @throws InvalidInput with its name
val number(const Question& asked) { return val(parse_number(asked.text("name"), asked.text("text"))); }

val series(const Question& asked) { return float64_array(parse_series(asked.text("name"), asked.text("text"))); }

}  // namespace

EMSCRIPTEN_BINDINGS(encounter) {
  emscripten::function("version", &answered<version>);
  emscripten::function("schema", &answered<schema>);
  emscripten::function("quantities", &answered<quantities>);
  emscripten::function("kinds", &answered<kinds>);
  emscripten::function("units", &answered<units>);
  emscripten::function("speed", &answered<speed>);
  emscripten::function("number", &answered<number>);
  emscripten::function("series", &answered<series>);
}

}  // namespace web
}  // namespace stoss
