#include "stoss/encounter/schema.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "encounter/json_values.hpp"
#include "stoss/encounter/inputs.hpp"
#include "stoss/encounter/kinds.hpp"
#include "stoss/encounter/materials.hpp"

namespace stoss {
namespace {

using Json = nlohmann::ordered_json;

Json number_of(const Parameter& its) {
  Json schema{{"type", "number"}, {"description", its.help}};
  if (!its.unit.empty()) schema["x-unit"] = its.unit;
  schema[its.low_included ? "minimum" : "exclusiveMinimum"] = its.low;
  if (std::isfinite(its.high)) schema["maximum"] = its.high;
  if (its.default_value) schema["default"] = *its.default_value;
  return schema;
}

/// The same of what may be limited in units of a body, which are not those of the document: η, and asperities.
Json given_as(const Parameter& its) {
  Json schema = number_of(its);
  const bool size_of_face = is_of_face(its.name) && its.unit == "m";
  if (its.name == "loss_time" || size_of_face) {
    for (const char* key : {"minimum", "exclusiveMinimum", "maximum"}) schema.erase(key);
  }
  if (size_of_face) schema["minimum"] = 0;
  return schema;
}

Json relaxation() {
  const Json share{{"type", "number"}, {"exclusiveMinimum", 0}, {"maximum", 1}};
  const Json time{{"type", "number"}, {"exclusiveMinimum", 0}};
  return {{"type", "array"},
          {"description", "shares of the modulus E(0) that relax, and their times; in SI with a material, else in R/c"},
          {"items", {{"type", "array"}, {"prefixItems", {share, time}}, {"minItems", 2}, {"maxItems", 2}}},
          {"maxItems", most_relaxation_terms}};
}

Json young_is() { return {{"enum", {"instantaneous", "relaxed"}}, {"default", "instantaneous"}}; }

Json materials() {
  Json names = Json::array();
  for (const NamedMaterial& each : named_materials()) names.push_back(each.name);
  const Json positive{{"type", "number"}, {"exclusiveMinimum", 0}};
  const Json poisson{{"type", "number"}, {"exclusiveMinimum", -1}, {"exclusiveMaximum", 0.5}};
  const Json numbers{{"type", "object"},
                     {"properties",
                      {{"young", positive},
                       {"poisson", poisson},
                       {"density", positive},
                       {"yield_strength", positive},
                       {"loss_time", {{"type", "number"}, {"minimum", 0}}},
                       {"surface_energy", {{"type", "number"}, {"minimum", 0}}},
                       {"relaxation", {{"$ref", "#/$defs/relaxation"}}},
                       {"young_is", young_is()},
                       {"quality", {{"type", "number"}, {"minimum", 3}, {"maximum", 1e9}}},
                       {"frequency", positive},
                       {"c_p", positive},
                       {"c_s", positive}}},
                     {"required", {"density"}},
                     {"oneOf", {{{"required", {"young", "poisson"}}}, {{"required", {"c_p", "c_s"}}}}},
                     {"additionalProperties", false}};
  return {{"description", "a named material, or its numbers in SI"}, {"oneOf", {{{"enum", names}}, numbers}}};
}

/// The layers of what may have some, from the top down.
Json layers_of(const Kind& kind) {
  Json properties = Json::object();
  for (const Parameter& each : kind.parameters) {
    if (!is_of_whole(each.name)) properties[std::string(each.name)] = number_of(each);
  }
  properties["material"] = {{"$ref", "#/$defs/material"}};
  return {{"type", "array"},
          {"description", "in place of the numbers above, from the top down; the last may have no thickness: a block"},
          {"items", {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}}},
          {"minItems", 1},
          {"maxItems", most_layers}};
}

Json list_of_numbers() { return {{"type", "array"}, {"items", {{"type", "number"}}}}; }

/// The file of a body by its modes at a point (modal_file.hpp).
Json modal_body() {
  const auto in = [](const char* unit, Json schema) {
    schema["x-unit"] = unit;
    return schema;
  };
  const Json number{{"type", "number"}}, positive{{"type", "number"}, {"exclusiveMinimum", 0}};
  const Json not_negative{{"type", "number"}, {"minimum", 0}}, numbers = list_of_numbers();
  Json vector = numbers;
  vector["minItems"] = vector["maxItems"] = 3;
  const Json rotation{
      {"type", "object"},
      {"properties",
       {{"inertia", in("kg m^2", {{"type", "array"}, {"items", vector}, {"minItems", 3}, {"maxItems", 3}})},
        {"point", in("m", vector)},
        {"normal", vector}}},
      {"required", {"inertia", "point", "normal"}},
      {"additionalProperties", false}};
  const Json both{{"type", "array"}, {"items", not_negative}, {"minItems", 2}, {"maxItems", 2}};
  const Json modes{{"type", "object"},
                   {"properties",
                    {{"frequency", in("Hz", numbers)},
                     {"displacement", in("kg^(-1/2)", numbers)},
                     {"displacement_curvature", in("kg^(-1/2) m^-2", numbers)},
                     {"frequency_error", in("Hz", numbers)},
                     {"displacement_error", in("kg^(-1/2)", numbers)},
                     {"tangential_displacement", in("kg^(-1/2)", numbers)},
                     {"tangential_displacement_curvature", in("kg^(-1/2) m^-2", numbers)},
                     {"tangential_displacement_error", in("kg^(-1/2)", numbers)}}},
                   {"required", {"frequency", "displacement"}},
                   {"additionalProperties", false}};
  const Json tangent{{"type", "object"},
                     {"description", "what friction along a direction asks of it; without rotation, inertia and arm"},
                     {"properties",
                      {{"direction", vector},
                       {"compliance", in("m/N", number)},
                       {"compliance_error", in("m/N", not_negative)},
                       {"mass", in("kg", positive)},
                       {"inertia", in("kg m^2", not_negative)},
                       {"arm", in("m", not_negative)},
                       {"cross", in("1/kg", number)}}},
                     {"required", {"compliance"}},
                     {"additionalProperties", false}};
  return {{"type", "object"},
          {"description", "a body by its modes at a point and the compliance of all others, as its file has it"},
          {"properties",
           {{"format", {{"const", json::modal_body_format}}},
            {"name", {{"type", "string"}}},
            {"origin", {{"type", "string"}}},
            {"mass", in("kg", positive)},
            {"rotation", rotation},
            {"curvature", in("1/m", {{"oneOf", {not_negative, both}}})},
            {"young", in("Pa", positive)},
            {"poisson", {{"type", "number"}, {"minimum", -0.95}, {"maximum", 0.4999}}},
            {"density", in("kg/m^3", positive)},
            {"loss_time", in("s", not_negative)},
            {"compliance", in("m/N", number)},
            {"compliance_error", in("m/N", not_negative)},
            {"complete_to", in("Hz", positive)},
            {"held", {{"type", "boolean"}, {"default", false}}},
            {"tangent", tangent},
            {"modes", modes}}},
          {"required", {"format", "mass", "curvature", "young", "poisson", "density", "compliance", "modes"}},
          {"additionalProperties", false}};
}

/// @param first whether it is of the first body, whose numbers have no default but 1
Json object_of(const Kind& kind, bool first) {
  if (kind.from_file) {
    Json properties{{"kind", {{"const", kind.name}}},
                    {"body", {{"$ref", "#/$defs/modal_body"}}},
                    {"relaxation", {{"$ref", "#/$defs/relaxation"}}}};
    for (const Parameter& each : kind.parameters) properties[std::string(each.name)] = given_as(each);
    return {{"type", "object"},
            {"description", kind.help},
            {"properties", properties},
            {"required", {"kind", "body"}},
            {"additionalProperties", false}};
  }
  Json properties{{"kind", {{"const", kind.name}}}};
  for (const Parameter& each : kind.parameters) {
    properties[std::string(each.name)] = given_as(each);
  }
  if (!kind.wall) properties["relaxation"] = {{"$ref", "#/$defs/relaxation"}};
  if (!kind.wall) properties["young_is"] = young_is();
  if (!kind.wall) properties["material"] = {{"$ref", "#/$defs/material"}};
  if (kind.add_layer) properties["layers"] = layers_of(kind);
  if (kind.has_plane) properties["plane"] = {{"enum", {"stress", "strain"}}, {"default", "stress"}};
  if (kind.can_be_rigid) properties["rigid"] = {{"type", "boolean"}, {"default", false}};
  Json schema{{"type", "object"},
              {"description", kind.help},
              {"properties", properties},
              {"required", {"kind"}},
              {"additionalProperties", false}};
  for (const Parameter& each : kind.parameters) {
    if (each.default_value || each.of_material) continue;
    if (kind.add_layer) {
      schema["oneOf"] = {{{"required", {each.name}}}, {{"required", {"layers"}}}};
    } else {
      schema["required"].push_back(each.name);
    }
  }
  if (first && parameter(kind, "poisson") != nullptr) {
    schema["oneOf"] = {{{"required", {"poisson"}}}, {{"required", {"material"}}}};
  }
  return schema;
}

Json vibration() {
  const Json number{{"type", "number"}}, whole{{"type", "integer"}, {"minimum", 0}};
  const Json mode{{"type", "object"},
                  {"properties",
                   {{"body", {{"enum", {"first", "second"}}, {"default", "first"}}},
                    {"order", whole},
                    {"index", whole},
                    {"energy", {{"type", "number"}, {"minimum", 0}}},
                    {"phase", number}}},
                  {"required", {"order", "index", "energy"}},
                  {"additionalProperties", false}};
  return {{"type", "array"}, {"items", mode}};
}

/// How they meet: a document of its own, whose ranges are in units of the first body.
Json collision() {
  Json properties = Json::object();
  for (const char* name : {"speed", "tangential", "angle", "spin", "second_spin", "friction"}) {
    const Input& its = input(Question::oblique, name);
    Json& schema = properties[name] = {{"type", "number"}, {"description", its.help}};
    if (its.dimension != Dimension::none) {
      schema["x-dimension"] = dimension_name(its.dimension);
    } else {
      schema[its.low_included ? "minimum" : "exclusiveMinimum"] = its.low;
      schema[its.high_included ? "maximum" : "exclusiveMaximum"] = its.high;
    }
  }
  return {{"type", "object"}, {"properties", properties}, {"required", {"speed"}}, {"additionalProperties", false}};
}

}  // namespace

std::string encounter_schema() {
  Json first = Json::array(), against = Json::array(), names = Json::array();
  for (const Kind& each : kinds()) {
    if (each.bounded && !each.wall) first.push_back(object_of(each, true));
    against.push_back(object_of(each, false));
    if (each.wall || !each.bounded) names.push_back(each.name);
  }
  against.push_back({{"enum", names}});
  const Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                    {"$id", "urn:stoss:encounter:1"},
                    {"title", json::encounter_format},
                    {"description", "Who meets whom, and how both are given; " + who_meets_whom()},
                    {"type", "object"},
                    {"properties",
                     {{"format", {{"const", json::encounter_format}}},
                      {"first", {{"oneOf", first}}},
                      {"against", {{"oneOf", against}, {"default", "wall"}}},
                      {"vibration", vibration()}}},
                    {"required", {"first"}},
                    {"additionalProperties", false},
                    {"$defs",
                     {{"material", materials()},
                      {"relaxation", relaxation()},
                      {"modal_body", modal_body()},
                      {"collision", collision()}}}};
  return schema.dump(2);
}

}  // namespace stoss
