// What a body file may have.
#include "encounter/modal_schema.hpp"

namespace stoss::json {

Json schema_of_modal_body() {
  const auto in = [](const char* unit, Json schema) {
    schema["x-unit"] = unit;
    return schema;
  };
  const Json number{{"type", "number"}}, positive{{"type", "number"}, {"exclusiveMinimum", 0}};
  const Json not_negative{{"type", "number"}, {"minimum", 0}}, numbers{{"type", "array"}, {"items", number}};
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
  const Json both{{"type", "array"}, {"items", number}, {"minItems", 2}, {"maxItems", 2}};
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

}  // namespace stoss::json
