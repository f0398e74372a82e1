// stoss modes: the eigenmodes of a disk.
#include "stoss/bodies/disk/modes.hpp"

#include <memory>
#include <numbers>

#include "arguments.hpp"
#include "options.hpp"
#include "tables.hpp"

namespace stoss::cli {
namespace {

using namespace bodies::disk;

struct ModesArguments {
  DiskArguments disk;
  double cutoff = 30.0;
  OutputArguments output;
};

void run(const ModesArguments& arguments) {
  const auto si = arguments.disk.si();
  const std::vector<Mode> modes = bodies::disk::modes(arguments.disk.plane_poisson(), arguments.cutoff);

  Provenance provenance{"modes", command_line(), {}};
  arguments.disk.describe(provenance.inputs);
  provenance.inputs["cutoff"] = arguments.cutoff;
  Report report(Output(arguments.output.path), arguments.output.chosen_format(), provenance);
  for (const Mode& mode : modes) {
    Record record;
    add_quantities(record, mode_table(), mode, {});
    if (si) record.push_back({"frequency", "Hz", mode.omega * si->frequency / (2.0 * std::numbers::pi), 13});
    report.add(record);
  }
  report.finish();
}

}  // namespace

void add_modes(CLI::App& app) {
  auto* command = app.add_subcommand("modes", "Eigenmodes of a free elastic disk: frequencies and edge amplitudes");
  auto arguments = std::make_shared<ModesArguments>();
  arguments->disk.add_to(*command);
  add_number(*command, "--cutoff", arguments->cutoff, "Highest frequency in c/R, up to 1000 (default: 30)")
      ->type_name("OMEGA")
      ->group("Resolution");
  arguments->output.add_to(*command);
  command->footer("Example:\n  stoss modes --poisson 0.33 --cutoff 30 --format csv -o modes.csv");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace stoss::cli
