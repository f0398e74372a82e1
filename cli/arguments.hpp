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

/// Heading of the options that give a disk or a sphere in SI.
inline const std::string round_material_group = "Material in SI (all of young, density, radius, or none)";

/// Heading of the options that give a body in SI.
inline const std::string material_group =
    "Material in SI (disk, sphere: all of young, density, radius; rod: young, density, length, area)";

/// The disk: a 2-D Poisson's ratio, or a material in SI with a radius. A sphere is given in the same way, but for a
/// plane (SphereArguments).
struct DiskArguments {
  double poisson = 0.0;
  std::optional<double> young;
  std::optional<double> density;
  std::optional<double> radius;
  std::string plane = "stress";

  void add_to(CLI::App& command);

  /// Only the Poisson's ratio.
  /// @return the option, which may be left out
  CLI::Option* add_poisson_to(CLI::App& command);

  /// All but the Poisson's ratio.
  void add_material_to(CLI::App& command, const std::string& group);

  /// SI scales if a material was given. @throws InvalidInput if only part of one was
  [[nodiscard]] std::optional<Scales> si() const;

  /// The Poisson's ratio that the core computes with.
  [[nodiscard]] double plane_poisson() const;

  [[nodiscard]] Plane chosen_plane() const;
  [[nodiscard]] bool plane_given() const { return plane_option_ != nullptr && plane_option_->count() > 0; }

  /// Adds what was given, and the scales, to the inputs of a result.
  void describe(nlohmann::ordered_json& inputs) const;

 private:
  [[nodiscard]] Material material() const;
  CLI::Option* plane_option_ = nullptr;
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

/// stoss sweep and stoss merge, which become Python with the same words.
void add_sweeps(CLI::App& app);

}  // namespace stoss::cli
