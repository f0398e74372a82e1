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

void run(const MaterialsArguments& arguments) {
  const Columns columns{{"name", "", 18},         {"young", "Pa", 10}, {"poisson", "", 9}, {"density", "kg/m^3", 9},
                        {"yield_strength", "Pa"}, {"loss_time", "s"},  {"source", "", 60}};
  Writer writer = arguments.output.writer({"materials", command_line(), {}}, columns, Output::Use::whole);
  const auto known = [](const std::optional<double>& value) { return value ? Value(*value) : Value(std::string()); };
  for (const NamedMaterial& each : named_materials()) {
    const Material& its = each.material;
    writer.add({std::string(each.name), its.young, its.poisson, its.density, known(its.yield_strength),
                known(its.loss_time), std::string(each.source)});
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
