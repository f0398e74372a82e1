// A row as it is given: bodies, each with the units of the first, what stands at its ends, and gaps.
#include "stoss/encounter/row.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "check.hpp"
#include "encounter/json_values.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using namespace json;

Participant participant_of(const std::string& where, const Json& given) {
  return participant_from_json(where, given.dump());
}

Oscillation oscillation_of(const std::string& where, const Json& given) {
  require_keys(where, given, {"body", "order", "index", "energy", "phase"});
  const auto whole = [&](const char* name) {
    if (!given.contains(name) || !given[name].is_number_integer())
      refuse(where, given, "whole numbers body, order, index");
    return given[name].get<int>();
  };
  Oscillation mode{.body = whole("body"), .order = whole("order"), .index = whole("index")};
  if (!given.contains("energy")) refuse(where, given, "an object with an energy");
  mode.energy = number(where + " energy", given["energy"]);
  if (given.contains("phase")) mode.phase = number(where + " phase", given["phase"]);
  return mode;
}

bool is_wall(const Participant& of) { return of.kind == "wall"; }

/// What stands at an end: a smooth wall, or what has no end itself.
void require_standing(const std::string& where, const Participant& of) {
  const Kind& its = kind(of.kind);
  if (is_wall(of) ? of.values.empty() : !its.wall && !its.bounded) return;
  throw InvalidInput::out_of_range(where, is_wall(of) ? "a wall with " + of.values.begin()->first : of.kind,
                                   "a wall, a half-space or a plate",
                                   "what moves is one of the bodies, and roughness is a key of bodies");
}

}  // namespace

GivenRow row_from_json(std::string_view text) {
  const Json document = parsed("row", text);
  require_keys("row", document, {"format", "bodies", "before", "after", "gaps", "vibration"});
  if (document.contains("format")) require_format("format", document["format"], row_format);
  if (!document.contains("bodies") || !document["bodies"].is_array() || document["bodies"].empty()) {
    refuse("row", document, "an object with a list of bodies");
  }
  GivenRow row;
  for (const Json& each : document["bodies"]) {
    row.bodies.push_back(participant_of("body " + std::to_string(row.bodies.size()), each));
  }
  if (document.contains("before")) {
    const Participant before = participant_of("before", document["before"]);
    if (!is_wall(before)) refuse("before", document["before"], "\"wall\"; what else stands is after the last body");
    require_standing("before", before);
    row.wall_before = true;
  }
  if (document.contains("after")) row.after = participant_of("after", document["after"]);
  if (document.contains("gaps")) row.gaps = numbers("gaps", document["gaps"], std::nullopt);
  if (document.contains("vibration")) {
    if (!document["vibration"].is_array()) refuse("vibration", document["vibration"], "a list of modes");
    for (const Json& each : document["vibration"]) row.vibration.push_back(oscillation_of("vibration", each));
  }
  (void)row_of(row);
  return row;
}

std::string to_json(const GivenRow& row) {
  Json document{{"format", row_format}, {"bodies", Json::array()}};
  for (const Participant& each : row.bodies) document["bodies"].push_back(Json::parse(to_json(each)));
  if (row.wall_before) document["before"] = "wall";
  if (row.after) document["after"] = is_wall(*row.after) ? Json("wall") : Json::parse(to_json(*row.after));
  if (!row.gaps.empty()) document["gaps"] = row.gaps;
  for (const Oscillation& each : row.vibration) {
    document["vibration"].push_back({{"body", each.body},
                                     {"order", each.order},
                                     {"index", each.index},
                                     {"energy", each.energy},
                                     {"phase", each.phase}});
  }
  return document.dump();
}

Encounter first_of(const GivenRow& row) {
  if (row.bodies.empty()) throw InvalidInput::missing("bodies", "1 to 100 bodies");
  return {.first = row.bodies.front()};
}

Row row_of(const GivenRow& given) {
  const Encounter first = first_of(given);
  Row row;
  if (given.after) require_standing("after", *given.after);
  std::map<std::string, std::size_t> numbers;  // of kinds, by their documents
  std::vector<Participant> all = given.bodies;
  const bool stands = given.after && !is_wall(*given.after);
  if (stands) all.push_back(*given.after);
  for (const Participant& each : all) {
    const auto [place, is_new] = numbers.emplace(to_json(each), row.kinds.size());
    if (is_new) {
      const Encounter pair{.first = first.first, .against = each};
      if (row.kinds.empty()) validate(first);
      if (!row.kinds.empty()) validate(pair);
      row.kinds.push_back(row.kinds.empty() ? first_maker(first) : second_maker(pair));
    }
    row.bodies.push_back(place->second);
  }
  row.wall_before = given.wall_before;
  row.wall_after = given.after && is_wall(*given.after);
  const std::optional<Scales> scales = si_scales(first);
  for (const double each : given.gaps) row.gaps.push_back(scales ? each / scales->length : each);
  row.vibration = given.vibration;
  return row;
}

std::vector<double> speeds_in_c(const GivenRow& given, const std::vector<double>& speeds) {
  if (speeds.empty() || speeds.size() > given.bodies.size()) {
    throw InvalidInput::out_of_range("speed", std::to_string(speeds.size()) + " values",
                                     "1 to " + std::to_string(given.bodies.size()),
                                     "velocities to the right from the first body on; the others rest");
  }
  const double unit = speed_unit(first_of(given));
  std::vector<double> all(given.bodies.size() + (given.after && !is_wall(*given.after) ? 1 : 0));
  for (std::size_t b = 0; b < speeds.size(); ++b) {
    const double own = speeds[b] / unit;
    if (!(std::abs(own) <= 1.0)) {
      throw InvalidInput::out_of_range("speed", shown(speeds[b]), shown(-unit) + " to " + shown(unit),
                                       "up to the wave speed of the first body");
    }
    all[b] = own;
  }
  return all;
}

RowResult row(const GivenRow& given, const std::vector<double>& speeds, const RowOptions& options) {
  RowResult result = row(row_of(given), speeds_in_c(given, speeds), options);
  result.velocities_after.resize(given.bodies.size());
  return result;
}

RowImpact row_impact(const GivenRow& given, const std::vector<double>& speeds, double cutoff, const Poll& poll,
                     const RowWatch& watch) {
  return row_impact(row_of(given), speeds_in_c(given, speeds), cutoff, poll, watch);
}

}  // namespace stoss
