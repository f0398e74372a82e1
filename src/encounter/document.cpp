#include "stoss/encounter/document.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "encounter/json_values.hpp"
#include "encounter/losses/document.hpp"
#include "encounter/vibration_document.hpp"
#include "stoss/encounter/materials.hpp"
#include "stoss/encounter/modal_file.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using namespace json;

/// Of a rigid body the modulus cancels, and need not be given.
Json with_units_of_rigid(Json given) {
  if (given.contains("c_p") || given.contains("c_s")) return given;
  for (const auto& [name, unit] : units_of_rigid) given.emplace(name, unit);
  return given;
}

/// @param rigid whether it is that of a rigid body
void read_material(const std::string& where, const Json& given, bool rigid, Participant& into) {
  if (given.is_string()) {
    const NamedMaterial& its = material_of_the_list(given.get<std::string>());
    into.material_name = its.name, into.material = its.material;
  } else {
    const Json& its = object(where, given);
    into.material = material_of_numbers(where, rigid ? with_units_of_rigid(its) : its);
  }
}

std::string words_of(const Kind& kind) {
  std::string text = "kind";
  if (kind.from_file) text += ", body";
  for (const Parameter& each : kind.parameters) text += ", " + std::string(each.name);
  if (!kind.wall && !kind.from_file) text += ", relaxation, young_is, material";
  if (kind.add_layer) text += ", layers";
  if (kind.has_plane) text += ", plane";
  if (kind.can_be_rigid) text += ", rigid";
  return text;
}

Plane plane_of(const std::string& where, const Json& value) {
  const std::string name = word(where, value, "\"stress\" or \"strain\"");
  if (name != "stress" && name != "strain") refuse(where, value, "\"stress\" or \"strain\"");
  return name == "stress" ? Plane::stress : Plane::strain;
}

Participant participant(const std::string& where, const Json& given);

/// Whether layers have it together.
bool is_of_all_layers(const std::string& name) {
  return name == "kind" || name == "layers" || name == "relaxation" || name == "young_is" || is_of_whole(name);
}

/// "kind, layers, loss_time, …": what a body of layers has besides them.
std::string keys_of_layered(const Kind& its) {
  std::string keys = "kind, layers, relaxation, young_is";
  for (const Parameter& each : its.parameters) {
    if (is_of_whole(each.name)) keys += ", " + std::string(each.name);
  }
  return keys;
}

/// Layers, each like a whole one but for what all share.
void read_layers(const std::string& where, const Json& given, Participant& made) {
  if (!given.is_array() || given.empty()) refuse(where, given, "a list of layers, from the top");
  std::vector<Participant> layers;
  for (Json each : given) {
    const std::string place = where + " " + std::to_string(layers.size() + 1);
    for (const auto& [name, value] : object(place, each).items()) {
      if (is_of_all_layers(name)) refuse(place, name, "only what is of one layer");
    }
    each["kind"] = made.kind;
    layers.push_back(participant(place, each));
  }
  made.values.insert(layers[0].values.begin(), layers[0].values.end());
  made.material = layers[0].material, made.material_name = layers[0].material_name;
  made.below.assign(layers.begin() + 1, layers.end());
}

/// A body by its file, which stands in the document as it is.
Participant read_modal(const std::string& where, const Json& given) {
  std::vector<std::string> keys{"kind", "body", "relaxation"};
  for (const Parameter& each : kind("modal").parameters) keys.emplace_back(each.name);
  require_keys(where, given, keys);
  if (!given.contains("body")) refuse(where, given, "an object with a body, as its file has it");
  Participant made = modal_participant(modal_body_from_json(given["body"].dump(), where + " body"));
  if (given.contains("relaxation")) made.relaxation = relaxing_terms(where + " relaxation", given["relaxation"]);
  for (const Parameter& each : kind(made.kind).parameters) {
    const std::string name(each.name);
    if (given.contains(name)) made.values[name] = number(where + " " + name, given[name]);
  }
  return made;
}

Participant participant(const std::string& where, const Json& given) {
  Participant made;
  if (given.is_string()) {
    made.kind = kind(given.get<std::string>()).name;
    return made;
  }
  if (!object(where, given).contains("kind")) refuse(where, given, "an object with a kind");
  const Kind& its = kind(word(where + " kind", given["kind"], "the name of a kind"));
  made.kind = its.name;
  if (its.from_file) return read_modal(where, given);
  const bool layered = its.add_layer && given.contains("layers");
  bool relaxed = false;
  for (const auto& [name, value] : given.items()) {
    const std::string place = where + " " + name;
    if (name == "kind") continue;
    if (layered && name == "layers") {
      read_layers(place, value, made);
    } else if (layered && !is_of_all_layers(name)) {
      refuse(where, name, keys_of_layered(its));
    } else if (name == "relaxation" && !its.wall) {
      made.relaxation = relaxing_terms(place, value);
    } else if (name == "young_is" && !its.wall) {
      relaxed = is_relaxed(place, value);
    } else if (parameter(its, name) != nullptr) {
      made.values[name] = number(place, value);
    } else if (name == "material" && !its.wall) {
      read_material(place, value, its.can_be_rigid && given.value("rigid", Json()) == true, made);
    } else if (name == "plane" && its.has_plane) {
      made.plane = plane_of(place, value);
    } else if (name == "rigid" && its.can_be_rigid && value.is_boolean()) {
      made.rigid = value.get<bool>();
    } else if (name == "rigid" && its.can_be_rigid) {
      refuse(place, value, "true or false");
    } else {
      refuse(where, name, words_of(its));
    }
  }
  if (relaxed) take_young_as_relaxed(made);
  return made;
}

Json described(const Participant& of);

Json layers_of(const Participant& of) {
  std::vector<Participant> all{of};
  all.front().below.clear();
  all.insert(all.end(), of.below.begin(), of.below.end());
  Json layers = Json::array();
  for (Participant& each : all) {
    each.kind = of.kind;
    Json its = described(each), own = Json::object();
    for (const auto& [name, value] : its.items()) {
      if (!is_of_all_layers(name)) own[name] = value;
    }
    layers.push_back(std::move(own));
  }
  return layers;
}

Json described(const Participant& of) {
  const Kind& its = kind(of.kind);
  Json json{{"kind", of.kind}};
  if (of.modal) {
    json["body"] = Json::parse(to_json(*of.modal));
    if (of.relaxation) json["relaxation"] = document_of(*of.relaxation);
    for (const auto& [name, value] : of.values) json[name] = value;
    return json;
  }
  if (!of.below.empty()) {
    json["layers"] = layers_of(of);
    for (const auto& [name, value] : of.values) {
      if (is_of_whole(name)) json[name] = value;
    }
    if (of.relaxation) json["relaxation"] = document_of(*of.relaxation);
    return json;
  }
  for (const auto& [name, value] : of.values) json[name] = value;
  if (of.relaxation) json["relaxation"] = document_of(*of.relaxation);
  if (of.material) json["material"] = of.material_name.empty() ? document_of(*of.material) : Json(of.material_name);
  if (of.material && its.has_plane) json["plane"] = of.plane == Plane::stress ? "stress" : "strain";
  if (of.rigid) json["rigid"] = true;
  return json.size() == 1 && its.wall ? Json(of.kind) : json;
}

}  // namespace

Participant participant_from_json(const std::string& where, std::string_view text) {
  return participant(where, parsed(where, text));
}

std::string to_json(const Participant& participant) { return described(participant).dump(); }

Encounter encounter_from_json(std::string_view text) {
  const Json document = parsed("encounter", text);
  if (object("encounter", document).contains("format")) require_format("format", document["format"], encounter_format);
  if (!document.contains("first")) refuse("encounter", document, "an object with a first body");
  Encounter encounter;
  for (const auto& [name, value] : document.items()) {
    if (name == "first") {
      encounter.first = participant("first", value);
    } else if (name == "against") {
      encounter.against = participant("against", value);
    } else if (name == "vibration") {
      encounter.vibration = vibration(name, value);
    } else if (name != "format") {
      refuse("encounter", name, "format, first, against, vibration");
    }
  }
  validate(encounter);
  return encounter;
}

std::string to_json(const Encounter& encounter) {
  Json document{
      {"format", encounter_format}, {"first", described(encounter.first)}, {"against", described(encounter.against)}};
  if (!encounter.vibration.empty()) document["vibration"] = document_of(encounter.vibration);
  return document.dump();
}

}  // namespace stoss
