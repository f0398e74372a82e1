// stoss modes: the eigenmodes of a disk or a sphere.
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "encounter.hpp"
#include "options.hpp"
#include "tables.hpp"

namespace stoss::cli {
namespace {

struct ModesArguments {
  BodyOptions body;
  double cutoff = 30.0;
  OutputArguments output;
};

double in_hertz(const Scales& si) { return si.frequency / (2.0 * std::numbers::pi); }

template <typename Mode>
void write(const ModesArguments& arguments, const Encounter& encounter, const Table<Mode>& table,
           const std::vector<Mode>& modes) {
  nlohmann::ordered_json inputs;
  describe_first(encounter, inputs);
  inputs["cutoff"] = arguments.cutoff;
  const Provenance provenance{"modes", command_line(), std::move(inputs)};
  Units units = units_of(encounter);
  const auto si = std::exchange(units.si, std::nullopt);  // in SI, frequencies are in Hz
  Report report(Output(arguments.output.path), arguments.output.chosen_format(), provenance);
  for (const Mode& mode : modes) {
    Record record;
    add_quantities(record, table, mode, units);
    if (si) record.push_back({"frequency", "Hz", mode.omega * in_hertz(*si), 13});
    report.add(record);
  }
  report.finish();
}

void run(const ModesArguments& arguments) {
  const Encounter encounter{.first = arguments.body.body()};
  validate(encounter);
  const double poisson = poisson_of(first_solid(encounter));
  if (encounter.first.kind == "sphere") {
    write(arguments, encounter, sphere_mode_table(), bodies::sphere::modes(poisson, arguments.cutoff));
  } else {
    write(arguments, encounter, mode_table(), bodies::disk::modes(poisson, arguments.cutoff));
  }
}

}  // namespace

void add_modes(CLI::App& app) {
  auto* command = app.add_subcommand("modes", "Eigenmodes of a free elastic disk or sphere, with edge amplitudes");
  auto arguments = std::make_shared<ModesArguments>();
  arguments->body.add_kind_to(*command, {"disk", "sphere"});
  arguments->body.add_poisson_to(*command);
  arguments->body.add_material_to(*command, false);
  add_number(*command, "--cutoff", arguments->cutoff, "Highest frequency in c/R, up to 1000 (default: 30)")
      ->type_name("OMEGA")
      ->group("Resolution");
  arguments->output.add_to(*command);
  command->footer(
      "Examples:\n"
      "  stoss modes --poisson 0.33 --cutoff 30 --format csv -o modes.csv\n"
      "  stoss modes --body sphere --poisson 0.3 --cutoff 12.5");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace stoss::cli
