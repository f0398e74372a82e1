// Who meets whom, as the inputs of a result say it.
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "encounter.hpp"

namespace stoss::cli {

void Encounter::describe(nlohmann::ordered_json& inputs) const {
  inputs["body"] = name(first_.kind);
  if (first_.kind == BodyKind::disk) first_.disk.describe(inputs);
  if (first_.kind == BodyKind::sphere) cli::describe(first_.disk.poisson, first_.sphere, inputs);
  if (first_.rod) cli::describe(*first_.rod, inputs);
  if (first_.rigid) inputs["rigid_body"] = true;
  if (lossy()) inputs[si_ ? "loss_time[s]" : "loss_time"] = first_.loss_time;
  inputs["against"] = against_.kind;
  if (against_.kind == "exponential") {
    inputs["against_hardness"] = against_.value("hardness", default_hardness);
    inputs["against_strength"] = against_.value("strength", 1.0);
  } else if (second_is_given()) {
    describe_second(inputs);
  }
}

void Encounter::describe_second(nlohmann::ordered_json& inputs) const {
  if (const auto loss_time = against_.values.find("loss_time"); loss_time != against_.values.end()) {
    inputs[si_ ? "against_loss_time[s]" : "against_loss_time"] = loss_time->second;
  }
  if (si_) {
    if (first_.kind == BodyKind::disk) inputs["against_poisson"] = second_disk(0.0).poisson;
    if (first_.kind == BodyKind::sphere) inputs["against_poisson"] = second_material().poisson;
    inputs["against_material_young[Pa]"] = against_.values.at("young");
    if (first_.kind == BodyKind::disk) inputs["against_material_poisson"] = second_material().poisson;
    inputs["against_material_density[kg/m^3]"] = against_.values.at("density");
    if (against_.values.contains("yield")) inputs["against_material_yield[Pa]"] = against_.values.at("yield");
    for (const auto& [key, unit] : {std::pair{"radius", "m"}, {"length", "m"}, {"area", "m^2"}}) {
      if (against_.values.contains(key)) inputs[fmt::format("against_{}[{}]", key, unit)] = against_.values.at(key);
    }
    return;
  }
  if (!rods()) {
    const auto poisson = against_.values.find("poisson");
    inputs["against_poisson"] = poisson == against_.values.end() ? nlohmann::ordered_json("as the first")
                                                                 : nlohmann::ordered_json(poisson->second);
  }
  const std::vector<std::string> round{"radius", "young", "density"}, rod{"length", "young", "density", "area"};
  for (const std::string& key : rods() ? rod : round) {
    if (key == "radius" && against_.is_unbounded()) continue;
    inputs["against_" + key] = against_.value(key, 1.0);
  }
}

}  // namespace stoss::cli
