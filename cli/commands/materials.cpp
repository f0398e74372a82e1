// stoss materials: the named materials, with their sources.
#include "stoss/encounter/materials.hpp"

#include <string>

#include "app.hpp"
#include "output/output_options.hpp"

namespace stoss::cli {
namespace {

struct MaterialsArguments {
  OutputOptions output;
  CLI::App* command = nullptr;
};

/// For JSON: where the other constants are from, and within which factor 1 + u each is known.
nlohmann::ordered_json details_of(const NamedMaterial& of) {
  const Uncertainties& its = of.uncertainties;
  return {{"strength_source", of.strength_source},
          {"surface_source", of.surface_source},
          {"uncertainties",
           {{"young", its.young},
            {"poisson", its.poisson},
            {"density", its.density},
            {"loss_time", its.loss_time},
            {"yield_strength", its.yield_strength},
            {"surface_energy", its.surface_energy}}}};
}

void run(const MaterialsArguments& arguments) {
  const Columns columns{{"name", "", 17},
                        {"young", "Pa", 9},
                        {"poisson", "", 8},
                        {"density", "kg/m^3", 8},
                        {"yield_strength", "Pa", 15},
                        {"quality", "", 8},
                        {"loss_time", "s"},
                        {"surface_energy", "J/m^2", 15},
                        {"source", ""}};
  Writer writer = arguments.output.writer({"materials", command_line(), {}}, columns, Output::Use::whole);
  const auto known = [](const std::optional<double>& value) { return value ? Value(*value) : Value(std::string()); };
  for (const NamedMaterial& each : named_materials()) {
    const Material& its = each.material;
    writer.add({std::string(each.name), its.young, its.poisson, its.density, known(its.yield_strength),
                each.quality > 0.0 ? Value(each.quality) : Value(std::string()), known(its.loss_time),
                known(its.surface_energy), std::string(each.source)},
               details_of(each));
  }
  if (arguments.output.chosen_format() == Format::table) {
    writer.close_table(
        "\nquality: at contacts of 50 us (rubber: 1 ms); nothing: not known well enough\n"
        "sources, loss times and uncertainties: --format json\n");
  }
  writer.finish();
}

}  // namespace

void add_materials(CLI::App& app) {
  auto& arguments =
      add_subcommand<MaterialsArguments>(app, "materials", "The materials that --material takes, with their sources",
                                         run, "Examples:\n  stoss materials\n  stoss materials --format json");
  arguments.output.add_to(*arguments.command);
}

}  // namespace stoss::cli
