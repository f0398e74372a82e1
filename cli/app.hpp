#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace stoss::cli {

/// Declares all subcommands and options, once: the man page and the completion are made from this declaration too.
/// @param exit_code set by a subcommand that ends without an error but not as asked
void declare(CLI::App& app, int& exit_code);

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
void add_sweep(CLI::App& app);
void add_merge(CLI::App& app);

}  // namespace stoss::cli
