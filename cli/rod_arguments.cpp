#include "rod_arguments.hpp"

#include <fmt/format.h>

#include "options.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {

void RodArguments::add_to(CLI::App& command) {
  add_number(command, "--length", length, "Length of the rod in m")->type_name("M")->group(material_group);
  add_number(command, "--area", area, "Cross-section of the rod in m^2")->type_name("M2")->group(material_group);
}

std::optional<Rod> RodArguments::si(const DiskArguments& material) const {
  const int given = (material.young ? 1 : 0) + (material.density ? 1 : 0) + (length ? 1 : 0) + (area ? 1 : 0);
  if (given == 0) return std::nullopt;
  if (given != 4) {
    throw InvalidInput(fmt::format(
        "material: got {} of --young, --density, --length, --area with --body rod, allowed all four or none", given));
  }
  return Rod{*length, *material.young, *material.density, *area};
}

void describe(const Rod& rod, nlohmann::ordered_json& inputs) {
  const Scales units = scales(rod);
  inputs["material_young[Pa]"] = rod.young;
  inputs["material_density[kg/m^3]"] = rod.density;
  inputs["length[m]"] = rod.length;
  inputs["area[m^2]"] = rod.area;
  inputs["c[m/s]"] = units.speed;
  inputs["L/c[s]"] = units.time;
}

}  // namespace stoss::cli
