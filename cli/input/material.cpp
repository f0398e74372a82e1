// The material of a body in SI: by its name, its numbers, or its speeds of waves.
#include <fmt/format.h>

#include "input/encounter.hpp"
#include "stoss/encounter/materials.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

/// Modulus and Poisson's ratio of the speeds of waves, if they were given.
void take_wave_speeds(Participant& of) {
  if (!of.values.contains("c_p") && !of.values.contains("c_s")) return;
  for (const char* needed : {"c_p", "c_s", "density"}) {
    if (!of.values.contains(needed)) {
      throw InvalidInput::missing(needed, "a number", "c_p, c_s and density make a material together");
    }
  }
  for (const char* other : {"young", "poisson"}) {
    if (of.values.contains(other)) throw InvalidInput::conflict(other, "c_p and c_s give it", "leave it out, or them");
  }
  const Material its = material_of_wave_speeds(of.values.at("c_p"), of.values.at("c_s"), of.values.at("density"));
  of.values["young"] = its.young, of.values["poisson"] = its.poisson;
  of.values.erase("c_p"), of.values.erase("c_s");
}

}  // namespace

void take_young(Participant& of, const std::string& young_is) {
  if (young_is.empty() || (young_is == "instantaneous" && of.relaxation)) return;
  if (of.modal) throw InvalidInput::conflict("young_is", "the modes of a body file are those of E(0)", "leave it out");
  take_young_as_relaxed(of);
}

void set_material(Participant& of, double poisson, const std::string& option) {
  if (!of.material_name.empty()) {
    const NamedMaterial& its = material_of_the_list(of.material_name);
    of.material_name = its.name, of.material = its.material;
  } else {
    take_wave_speeds(of);
    if (of.rigid) of.values.insert(units_of_rigid.begin(), units_of_rigid.end());
    const bool young = of.values.contains("young"), density = of.values.contains("density");
    if (!young || !density) {
      throw InvalidInput::out_of_range(
          fmt::format("{}", option), fmt::format("{} without {}", of.kind, young ? "density" : "young"),
          "young, density and sizes together, in SI, or a named material", "which sizes and plane need");
    }
    of.material = Material{of.values.at("young"), poisson, of.values.at("density")};
    if (const auto own = of.values.find("poisson"); own != of.values.end()) of.material->poisson = own->second;
    for (const char* own : {"young", "poisson", "density"}) of.values.erase(own);
  }
}

}  // namespace stoss::cli
