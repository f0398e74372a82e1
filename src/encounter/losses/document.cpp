#include "encounter/losses/document.hpp"

#include <array>
#include <utility>

#include "stoss/encounter/relaxing.hpp"

namespace stoss::json {

Relaxation relaxing_terms(const std::string& where, const Json& given) {
  constexpr const char* pairs = "a list of pairs [share, time], as in [[0.5, 1], [0.2, 10]]";
  if (!given.is_array()) refuse(where, given, pairs);
  Relaxation made;
  for (const Json& each : given) {
    if (!each.is_array() || each.size() != 2) refuse(where, each, pairs);
    made.terms.push_back({number(where, each[0]), number(where, each[1])});
  }
  return made;
}

Json document_of(const Relaxation& relaxation) {
  Json json = Json::array();
  for (const RelaxationTerm& term : relaxation.terms) json.push_back({term.share, term.time});
  return json;
}

bool is_relaxed(const std::string& where, const Json& given) {
  const std::string allowed = "\"instantaneous\" or \"relaxed\"";
  const std::string which = word(where, given, allowed);
  if (which != "instantaneous" && which != "relaxed") refuse(where, given, allowed);
  return which == "relaxed";
}

Material material_of_numbers(const std::string& where, const Json& given) {
  Material material;
  bool relaxed = false;
  const auto optional = [](std::optional<double>& place) {
    return [&place](const std::string& of, const Json& value) { place = number(of, value); };
  };
  const auto needed = [](double& place) {
    return [&place](const std::string& of, const Json& value) { place = number(of, value); };
  };
  using Read = std::function<void(const std::string& of, const Json& value)>;
  double c_p = 0.0, c_s = 0.0;
  const std::array<std::pair<const char*, Read>, 12> keys{{
      {"young", needed(material.young)},
      {"poisson", needed(material.poisson)},
      {"density", needed(material.density)},
      {"yield_strength", optional(material.yield_strength)},
      {"loss_time", optional(material.loss_time)},
      {"surface_energy", optional(material.surface_energy)},
      {"relaxation",
       [&](const std::string& of, const Json& value) { material.relaxation = relaxing_terms(of, value); }},
      {"young_is", [&](const std::string& of, const Json& value) { relaxed = is_relaxed(of, value); }},
      {"quality", optional(material.quality)},
      {"frequency", needed(material.frequency)},
      {"c_p", needed(c_p)},
      {"c_s", needed(c_s)},
  }};
  const bool of_speeds = given.contains("c_p") && given.contains("c_s");
  for (std::size_t i = of_speeds ? 2 : 0; i < 3; ++i) {
    if (!given.contains(keys[i].first)) refuse(where, given, "young (or c_p, c_s), poisson and density, or a name");
  }
  if (of_speeds && (given.contains("young") || given.contains("poisson"))) {
    throw InvalidInput::conflict(where + " young", "c_p and c_s give it, and poisson", "leave it out, or them");
  }
  std::string names;
  for (const auto& [name, read] : keys) names += (names.empty() ? "" : ", ") + std::string(name);
  for (const auto& [name, value] : given.items()) {
    const auto* const key =
        std::find_if(keys.begin(), keys.end(), [&n = name](const auto& of) { return n == of.first; });
    if (key == keys.end()) refuse(where, name, names);
    key->second(where + " " + name, value);
  }
  if (of_speeds) {
    const Material its = material_of_wave_speeds(c_p, c_s, material.density);
    material.young = its.young, material.poisson = its.poisson;
  }
  if (relaxed) material.young = instantaneous_of_relaxed(material.young, material.relaxation.value_or(Relaxation{}));
  return material;
}

Json document_of(const Material& material) {
  Json json{{"young", material.young}, {"poisson", material.poisson}, {"density", material.density}};
  if (material.yield_strength) json["yield_strength"] = *material.yield_strength;
  if (material.loss_time) json["loss_time"] = *material.loss_time;
  if (material.surface_energy) json["surface_energy"] = *material.surface_energy;
  if (material.relaxation) json["relaxation"] = document_of(*material.relaxation);
  if (material.quality) json["quality"] = *material.quality;
  if (material.frequency != usual_frequency) json["frequency"] = material.frequency;
  return json;
}

}  // namespace stoss::json
