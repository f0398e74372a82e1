#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "output/writer.hpp"

namespace stoss::cli {

/// How the result is written: --format, -o, --quiet.
struct OutputOptions {
  std::string format = "table";
  std::string path;
  bool quiet = false;

  void add_to(CLI::App& command);

  /// All but --format.
  void add_place_to(CLI::App& command);

  [[nodiscard]] Format chosen_format() const;

  /// A writer of rows. @param use of the output
  [[nodiscard]] Writer writer(const Provenance& provenance, const Columns& columns,
                              Output::Use use = Output::Use::rows) const;

  /// A line on stderr, unless --quiet.
  void warn(const std::string& text) const;

  /// The warning that linear elasticity has ended. @param where as in "here" or "there"
  void warn_of_strain(double strain, const std::string& where = "there") const;

  /// The warning that bodies turn too far for linear kinematics. @param turned angle
  void warn_of_turning(double turned) const;
};

/// How rows are written of which an interrupted run is continued: also --resume.
struct RowOptions {
  OutputOptions output;
  std::string resume;
  CLI::App* command = nullptr;

  void add_to(CLI::App& to);

  /// Lets the rows go to the file of --resume, as CSV. @throws InvalidInput for other options that do not go with it
  void redirect();
};

}  // namespace stoss::cli
