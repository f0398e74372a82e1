// stoss relaxation: how a material relaxes, from what dynamic mechanical analysis measures of it.
#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "app.hpp"
#include "input/encounter.hpp"
#include "output/output_options.hpp"
#include "process/process.hpp"
#include "stoss/encounter/moduli_file.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

struct RelaxationArguments {
  std::string file, wlf;
  std::optional<double> temperature;
  OutputOptions output;
  CLI::App* command = nullptr;
};

/// The same at --temperature, by the constants C1:C2:REFERENCE.
Relaxation at_temperature(const RelaxationArguments& arguments, const Relaxation& relaxation) {
  if (arguments.wlf.empty() && !arguments.temperature) return relaxation;
  if (arguments.wlf.empty()) throw InvalidInput::missing("wlf", "C1:C2:REFERENCE, as in 17.4:51.6:20");
  if (!arguments.temperature) throw InvalidInput::missing("temperature", "that to which --wlf shifts the times");
  const std::vector<std::string> parts = split(arguments.wlf, ':');
  if (parts.size() != 3) {
    throw InvalidInput::out_of_range("wlf", fmt::format("'{}'", shortened(arguments.wlf)),
                                     "C1:C2:REFERENCE, as in 17.4:51.6:20");
  }
  return shifted(relaxation, parse_number("wlf", parts[0]), parse_number("wlf", parts[1]),
                 parse_number("wlf", parts[2]), *arguments.temperature);
}

void run(const RelaxationArguments& arguments) {
  const std::string path = arguments.file, name = shortened(std::filesystem::path(path).filename().string());
  const Moduli measured = moduli_from_csv(text_of_file("file", path, "a CSV file of moduli"), name);
  FittedRelaxation made;
  try {
    made = relaxation_of_measurement(measured);
  } catch (const InvalidInput& error) {
    throw error.within(name);
  }
  const Relaxation relaxation = at_temperature(arguments, made.relaxation);
  const Columns columns{{"share", "", 14}, {"time", "s", 14}};
  nlohmann::ordered_json inputs{{"file", path}};
  if (arguments.temperature) inputs["wlf"] = arguments.wlf, inputs["temperature"] = *arguments.temperature;
  Writer writer = arguments.output.writer({"relaxation", command_line(), inputs}, columns, Output::Use::whole);
  writer.attach("relaxation", text_of(relaxation));
  writer.attach("young", made.instantaneous);
  writer.attach("relaxed", made.instantaneous * relaxation.relaxed());
  writer.attach("storage_misfit", made.storage_misfit);
  writer.attach("loss_misfit", made.loss_misfit);
  for (const RelaxationTerm& term : relaxation.terms) writer.add({term.share, term.time});
  if (arguments.output.chosen_format() == Format::table) {
    writer.close_table(
        fmt::format("\n--young {:.6g} --relaxation {}\nmodulus: E(0) {:.4g}, after all relaxation {:.4g}\n"
                    "misfit (root mean square): {:.2g} % of E', {:.2g} % of E''\n",
                    made.instantaneous, text_of(relaxation), made.instantaneous,
                    made.instantaneous * relaxation.relaxed(), 100.0 * made.storage_misfit, 100.0 * made.loss_misfit));
  }
  writer.finish();
}

}  // namespace

void add_relaxation(CLI::App& app) {
  auto& arguments = add_subcommand<RelaxationArguments>(
      app, "relaxation", "How a material relaxes, from measured moduli: the terms that --relaxation takes", run,
      "Examples:\n"
      "  stoss relaxation rubber.csv\n"
      "  stoss relaxation rubber.csv --wlf 17.4:51.6:20 --temperature 30\n"
      "The file has a header, as in f, E' [MPa], E'' [MPa] or omega, E', tan_delta; frequencies rise.");
  CLI::App& command = *arguments.command;
  add(command, "file", arguments.file, "CSV file of frequencies and moduli", "FILE", "Measurement")->required();
  add(command, "--wlf", arguments.wlf,
      "Constants of Williams, Landel and Ferry, and the temperature of the\nmeasurement, at which they hold",
      "C1:C2:REFERENCE", "Measurement");
  add(command, "--temperature", arguments.temperature,
      "With --wlf: temperature of the material, in the unit of these constants", "T", "Measurement");
  arguments.output.add_to(command);
}

}  // namespace stoss::cli
