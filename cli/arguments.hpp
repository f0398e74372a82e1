#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report.hpp"
#include "stoss/material.hpp"

namespace stoss::cli {

/// How the result is written: --format, -o, --quiet.
struct OutputArguments {
  std::string format = "table";
  std::string path;
  bool quiet = false;

  void add_to(CLI::App& command);

  /// All but --format.
  void add_place_to(CLI::App& command);

  [[nodiscard]] Format chosen_format() const;

  /// A line on stderr, unless --quiet.
  void warn(const std::string& text) const;
};

/// Speeds that are allowed, in c, and what a refusal says of them.
struct SpeedRange {
  double slowest = 1e-8;
  double fastest = 1.0;
  std::string hint = "speed of approach, 1e-8 to 1 c";
};

/// Speeds as typed, in c or, where there are scales, in m/s; the result is in c.
/// @throws InvalidInput unless they are in the range
[[nodiscard]] std::vector<double> parse_speeds(const std::string& text, const std::optional<Scales>& si,
                                               const SpeedRange& range = {});

/// The command line, quoted so that a shell reads it back: for provenance.
[[nodiscard]] std::string command_line();
void set_command_line(int argc, char** argv);

/// The subcommands register themselves. They succeed or throw; only a curve or a distribution may end with exit code 1.
void add_modes(CLI::App& app);
void add_impact(CLI::App& app);
void add_bounce(CLI::App& app);
void add_restitution(CLI::App& app, int& exit_code);
void add_distribution(CLI::App& app, int& exit_code);
void add_quasistatic(CLI::App& app);
void add_table(CLI::App& app);
void add_materials(CLI::App& app);
void add_schema(CLI::App& app);

/// stoss sweep and stoss merge, which become Python with the same words.
void add_sweeps(CLI::App& app);

}  // namespace stoss::cli
