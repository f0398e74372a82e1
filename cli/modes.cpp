// stoss modes: the eigenmodes of a disk or a sphere.
#include <memory>
#include <numbers>
#include <vector>

#include "arguments.hpp"
#include "options.hpp"
#include "sphere_arguments.hpp"
#include "tables.hpp"

namespace stoss::cli {
namespace {

struct ModesArguments {
  DiskArguments disk;
  std::string body = "disk";
  double cutoff = 30.0;
  OutputArguments output;
};

double in_hertz(const Scales& si) { return si.frequency / (2.0 * std::numbers::pi); }

/// @param hertz what c/R is in Hz; 0 without a material
template <typename Mode>
void write(const ModesArguments& arguments, nlohmann::ordered_json inputs, double hertz, const Table<Mode>& table,
           const std::vector<Mode>& modes) {
  inputs["cutoff"] = arguments.cutoff;
  const Provenance provenance{"modes", command_line(), std::move(inputs)};
  Report report(Output(arguments.output.path), arguments.output.chosen_format(), provenance);
  for (const Mode& mode : modes) {
    Record record;
    add_quantities(record, table, mode, {{}, body_kind(arguments.body)});
    if (hertz > 0.0) record.push_back({"frequency", "Hz", mode.omega * hertz, 13});
    report.add(record);
  }
  report.finish();
}

void run(const ModesArguments& arguments) {
  nlohmann::ordered_json inputs;
  inputs["body"] = arguments.body;
  if (body_kind(arguments.body) == BodyKind::sphere) {
    const auto sphere = SphereArguments{}.si(arguments.disk);
    const double hertz = sphere ? in_hertz(scales(sphere->sphere())) : 0.0;
    describe(arguments.disk.poisson, sphere, inputs);
    write(arguments, std::move(inputs), hertz, sphere_mode_table(),
          bodies::sphere::modes(arguments.disk.poisson, arguments.cutoff));
    return;
  }
  const auto si = arguments.disk.si();
  const double hertz = si ? in_hertz(*si) : 0.0;
  arguments.disk.describe(inputs);
  write(arguments, std::move(inputs), hertz, mode_table(),
        bodies::disk::modes(arguments.disk.plane_poisson(), arguments.cutoff));
}

}  // namespace

void add_modes(CLI::App& app) {
  auto* command = app.add_subcommand("modes", "Eigenmodes of a free elastic disk or sphere, with edge amplitudes");
  auto arguments = std::make_shared<ModesArguments>();
  command->add_option("--body", arguments->body, "Kind of body (default: disk)")
      ->check(CLI::IsMember({"disk", "sphere"}))
      ->type_name("BODY")
      ->group("Body");
  arguments->disk.add_to(*command);
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
