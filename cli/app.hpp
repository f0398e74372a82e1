#pragma once

#include <CLI/CLI.hpp>

namespace stoss::cli {

/// Declares all subcommands and options, once: the man page and the completion are made from this declaration too.
/// @param exit_code set by a subcommand that ends without an error but not as asked
void declare(CLI::App& app, int& exit_code);

/// The subcommands of an app, in the order of their declaration.
[[nodiscard]] inline auto subcommands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

}  // namespace stoss::cli
