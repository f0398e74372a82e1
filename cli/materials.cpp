// stoss materials: the named materials, with their sources.
#include "stoss/encounter/materials.hpp"

#include <memory>
#include <string>

#include "arguments.hpp"

namespace stoss::cli {
namespace {

void run(const OutputArguments& output) {
  Report report(Output(output.path), output.chosen_format(), {"materials", command_line(), {}});
  for (const NamedMaterial& each : named_materials()) {
    const Material& its = each.material;
    Record record{{"name", "", std::string(each.name), 18},
                  {"young", "Pa", its.young, 10},
                  {"poisson", "", its.poisson, 9},
                  {"density", "kg/m^3", its.density, 9}};
    record.push_back({"yield_strength", "Pa", its.yield_strength ? Value(*its.yield_strength) : Value(std::string())});
    record.push_back({"loss_time", "s", its.loss_time ? Value(*its.loss_time) : Value(std::string())});
    record.push_back({"source", "", std::string(each.source), 60});
    report.add(record);
  }
  report.finish();
}

}  // namespace

void add_materials(CLI::App& app) {
  auto* command = app.add_subcommand("materials", "The materials that --material takes, with their sources");
  auto output = std::make_shared<OutputArguments>();
  output->add_to(*command);
  command->footer("Examples:\n  stoss materials\n  stoss materials --format json");
  command->callback([output] { run(*output); });
}

}  // namespace stoss::cli
