#include "output/output_options.hpp"

#include <fmt/format.h>

#include "app.hpp"
#include "process/process.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/impact.hpp"

namespace stoss::cli {

void OutputOptions::add_to(CLI::App& command) {
  add_choice(command, "--format", format, {"table", "csv", "json"}, "Output format (default: table)", "FORMAT",
             "Output");
  add_place_to(command);
}

void OutputOptions::add_place_to(CLI::App& command) {
  add(command, "-o,--output", path, "Write to FILE instead of stdout", "FILE", "Output");
  command.add_flag("--quiet", quiet, "No warnings and no progress on stderr")->group("Output");
}

Format OutputOptions::chosen_format() const {
  if (format == "csv") return Format::csv;
  return format == "json" ? Format::json : Format::table;
}

Writer OutputOptions::writer(const Provenance& provenance, const Columns& columns, Output::Use use) const {
  return {Output(path, use), chosen_format(), provenance, columns};
}

void OutputOptions::warn(const std::string& text) const {
  if (!quiet) say("stoss: warning: " + text);
}

void OutputOptions::warn_of_strain(double strain, const std::string& where) const {
  warn(fmt::format("strain of some {:.3g}, above {:g}: linear elasticity is no longer accurate {}", strain,
                   small_strain_limit, where));
}

void OutputOptions::warn_of_turning(double turned) const {
  warn(fmt::format(
      "the bodies turn by {:.2g} rad while they touch, and their contact rolls by more than its half-width: "
      "linear kinematics is no longer accurate there",
      turned));
}

void RowOptions::add_to(CLI::App& to) {
  command = &to;
  output.add_to(to);
  add(to, "--resume", resume,
      "Continue the run stored in FILE (CSV): add the rows that are missing; create FILE if it does not exist", "FILE",
      "Output");
}

void RowOptions::redirect() {
  if (!given(*command, "--resume")) return;
  if (resume == "-") throw InvalidInput::out_of_range("resume", "'-'", "the name of a file");
  if (given(*command, "--format") && output.format != "csv") {
    throw InvalidInput::out_of_range("resume", fmt::format("--format {}", output.format), "csv",
                                     "which --resume implies");
  }
  if (given(*command, "--output") && !same_output(output.path, resume)) {
    throw InvalidInput::out_of_range("resume", "another file as --output", fmt::format("'{}'", shortened(resume)),
                                     "all rows go there");
  }
  output.format = "csv";
  output.path = resume;
}

}  // namespace stoss::cli
