// stoss calibrate: declared here, done by the Python package, which has an optimiser.
#include <fmt/format.h>

#include "app.hpp"
#include "input/encounter.hpp"
#include "input/inputs.hpp"
#include "process/process.hpp"
#include "stoss/encounter/document.hpp"

namespace stoss::cli {
namespace {

struct CalibrateArguments {
  EncounterOptions who;
  std::string data, format = "table", output, report;
  std::vector<std::string> unknowns, uncertainties;
  std::optional<double> friction;
  bool without_air = false;
  CLI::App* command = nullptr;
};

void run(const CalibrateArguments& arguments) {
  const Encounter encounter = arguments.who.encounter();
  if (arguments.friction) {
    (void)own_value(input(Question::calibrate, "friction"), *arguments.friction, units_of(encounter));
  }
  std::vector<std::string> words{"calibrate", "--format=" + arguments.format};
  for (const std::string& each : arguments.unknowns) words.push_back("--unknown=" + each);
  for (const std::string& each : arguments.uncertainties) words.push_back("--uncertainty=" + each);
  if (arguments.friction) words.push_back(fmt::format("--friction={}", *arguments.friction));
  if (arguments.without_air) words.emplace_back("--without-air");
  if (!arguments.output.empty()) words.push_back("--output=" + arguments.output);
  if (!arguments.report.empty()) words.push_back("--report=" + arguments.report);
  words.insert(words.end(), {"--", arguments.data, to_json(encounter)});
  become_python(words);
}

}  // namespace

void add_calibrate(CLI::App& app) {
  auto& arguments = add_subcommand<CalibrateArguments>(
      app, "calibrate", "Constants of materials from measured impacts", run,
      "Examples:\n"
      "  stoss calibrate drops.csv --body sphere --material glass --radius 0.008 --against "
      "half-space,material=granite\n"
      "      --unknown quality --report drops.html\n"
      "  stoss calibrate cue.csv --body sphere --young 5e9 --poisson 0.34 --density 1700 --radius 0.0286\n"
      "      --against same --unknown quality=30 --unknown young --format json");
  CLI::App& command = *arguments.command;
  add(command, "data", arguments.data,
      "CSV file in SI. Columns: speed or drop_height, beside any of restitution, rebound_height, contact_time, "
      "peak_force, angle with tangential_restitution. Or time: successive impacts of a ball that bounces. Each with "
      "its "
      "standard uncertainty, as restitution_uncertainty",
      "DATA.csv", "Data")
      ->required();
  command.add_flag("--without-air", arguments.without_air, "Take heights and times as of a ball without air")
      ->group("Data");
  add(command, "--unknown", arguments.unknowns,
      "Constant to find, one to three: quality, loss_time, relaxation (a factor), young, density, yield_strength, "
      "yield_hardening, roughness, radius, friction. Those of the partner begin with against. as in against.young. "
      "With =START the search begins there",
      "NAME[=START]", "Constants")
      ->required();
  add_input(command, Question::calibrate, "friction", arguments.friction, "Constants");
  add(command, "--uncertainty", arguments.uncertainties,
      "Known within a factor of 1 + U is a constant that is held, as young=0.05 (default: that of a named material)",
      "NAME=U", "Constants");
  arguments.who.first.add_poisson_to(command);
  arguments.who.add_to(command);
  add_choice(command, "--format", arguments.format, {"table", "json", "csv"},
             "How to print: table for people, json with the encounter that was found, csv of the values", "NAME",
             "Output");
  add(command, "-o,--output", arguments.output, "Write to FILE instead of stdout; it appears whole or not at all",
      "FILE", "Output");
  add(command, "--report", arguments.report, "Write a page in HTML with constants, goodness of fit and picture to FILE",
      "FILE", "Output");
}

}  // namespace stoss::cli
