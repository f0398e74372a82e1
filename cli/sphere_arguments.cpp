#include "sphere_arguments.hpp"

#include <fmt/format.h>

#include "options.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {

void SphereArguments::add_to(CLI::App& command, const std::string& group) {
  add_number(
      command, "--yield", yield,
      "Yield strength of a sphere in Pa; adds the speed at which it begins\nto yield, and flags values beyond it")
      ->type_name("PA")
      ->group(group);
}

std::optional<SolidSphere> SphereArguments::si(const DiskArguments& given) const {
  if (given.plane_given()) {
    throw InvalidInput("plane: got --plane with --body sphere, allowed only with --body disk");
  }
  const int count = (given.young ? 1 : 0) + (given.density ? 1 : 0) + (given.radius ? 1 : 0);
  if (count == 0 && yield) {
    throw InvalidInput("yield: got --yield without a material, allowed only with --young, --density, --radius");
  }
  if (count == 0) return std::nullopt;
  if (count != 3) {
    throw InvalidInput(fmt::format(
        "material: got {} of --young, --density, --radius with --body sphere, allowed all three or none", count));
  }
  return SolidSphere{{*given.young, given.poisson, *given.density, yield}, *given.radius};
}

void describe(double poisson, const std::optional<SolidSphere>& sphere, nlohmann::ordered_json& inputs) {
  inputs["poisson"] = poisson;
  if (!sphere) return;
  const Scales units = scales(sphere->sphere());
  inputs["material_young[Pa]"] = sphere->material.young;
  inputs["material_density[kg/m^3]"] = sphere->material.density;
  if (sphere->material.yield_strength) inputs["material_yield[Pa]"] = *sphere->material.yield_strength;
  inputs["radius[m]"] = sphere->radius;
  inputs["c[m/s]"] = units.speed;
  inputs["R/c[s]"] = units.time;
}

}  // namespace stoss::cli
