#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace stoss::cli {

/// Options whose value is one number. What parse_number or parse_integer refuses is reported under the option's name.
/// @param name with its dashes, as in "--speed"
CLI::Option* add_number(CLI::App& command, const std::string& name, double& value, const std::string& help);
CLI::Option* add_number(CLI::App& command, const std::string& name, std::optional<double>& value,
                        const std::string& help);
CLI::Option* add_integer(CLI::App& command, const std::string& name, int& value, const std::string& help);
CLI::Option* add_integer(CLI::App& command, const std::string& name, std::optional<int>& value,
                         const std::string& help);

/// The option --threads, of work whose result does not depend on it.
void add_threads(CLI::App& command, int& threads);

/// Lets every option of the command and its subcommands refuse an empty value, as an unset shell variable leaves it.
void refuse_empty_values(CLI::App& app);

/// What to say of words that no option or subcommand of `app` has taken; "" if all were taken.
[[nodiscard]] std::string unknown_words(const CLI::App& app);

}  // namespace stoss::cli
