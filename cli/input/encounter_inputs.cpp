// Who meets whom, as the inputs of a result say it.
#include <fmt/format.h>

#include <string>

#include "input/encounter.hpp"

namespace stoss::cli {
namespace {

using Json = nlohmann::ordered_json;

bool is_size(const Parameter& parameter) { return !parameter.of_material && parameter.name != "loss_time"; }

/// A material and the sizes that go with it. @param prefix of the names
void describe_in_si(const std::string& prefix, const Participant& of, Json& inputs) {
  const Kind& its = kind(of.kind);
  if (!of.material_name.empty()) inputs[prefix + "material"] = of.material_name;
  inputs[prefix + "material_young[Pa]"] = of.material->young;
  if (its.has_plane) inputs[prefix + "material_poisson"] = of.material->poisson;
  inputs[prefix + "material_density[kg/m^3]"] = of.material->density;
  if (of.material->yield_strength && its.can_yield)
    inputs[prefix + "material_yield[Pa]"] = *of.material->yield_strength;
  for (const Parameter& each : its.parameters) {
    if (!is_size(each)) continue;
    inputs[fmt::format("{}{}[{}]", prefix, each.name, each.unit)] = of.values.at(std::string(each.name));
  }
}

/// As ratios to the first body.
void describe_ratios(const Participant& of, Json& inputs) {
  for (const Parameter& each : kind(of.kind).parameters) {
    if (each.name == "loss_time") continue;
    const auto found = of.values.find(each.name);
    Json& value = inputs["against_" + std::string(each.name)];
    if (found != of.values.end()) {
      value = found->second;
    } else if (each.otherwise) {
      value = *each.otherwise;
    } else {
      value = "as the first";
    }
  }
}

void describe_against(const Encounter& encounter, Json& inputs) {
  const Participant& against = encounter.against;
  if (kind(against.kind).wall) return describe_ratios(against, inputs);
  if (const auto found = against.values.find("loss_time"); found != against.values.end()) {
    inputs[against.material ? "against_loss_time[s]" : "against_loss_time"] = found->second;
  }
  if (!against.material) return describe_ratios(against, inputs);
  if (!is_rod(encounter)) inputs["against_poisson"] = poisson_of(*second_solid(encounter));
  describe_in_si("against_", against, inputs);
}

}  // namespace

void describe_first(const Encounter& encounter, Json& inputs) {
  const Participant& first = encounter.first;
  inputs["body"] = first.kind;
  if (!is_rod(encounter)) inputs["poisson"] = poisson_of(first_solid(encounter));
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
  describe_against(encounter, inputs);
}

}  // namespace stoss::cli
