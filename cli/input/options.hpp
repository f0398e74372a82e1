#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace stoss::cli {

/// Options with one value. What a parser of numbers refuses is reported under the option's name.
/// @param name  with its dashes, as in "--speed"
/// @param type  what help shows in place of the value
/// @param group of the help
CLI::Option* add(CLI::App& command, const std::string& name, std::string& value, const std::string& help,
                 const std::string& type, const std::string& group);
CLI::Option* add(CLI::App& command, const std::string& name, double& value, const std::string& help,
                 const std::string& type, const std::string& group);
CLI::Option* add(CLI::App& command, const std::string& name, std::optional<double>& value, const std::string& help,
                 const std::string& type, const std::string& group);
CLI::Option* add(CLI::App& command, const std::string& name, int& value, const std::string& help,
                 const std::string& type, const std::string& group);
CLI::Option* add(CLI::App& command, const std::string& name, std::optional<int>& value, const std::string& help,
                 const std::string& type, const std::string& group);

/// An option that may be given several times.
CLI::Option* add(CLI::App& command, const std::string& name, std::vector<std::string>& values, const std::string& help,
                 const std::string& type, const std::string& group);

/// An option whose value is one of some words.
CLI::Option* add_choice(CLI::App& command, const std::string& name, std::string& value,
                        const std::vector<std::string>& words, const std::string& help, const std::string& type,
                        const std::string& group);

/// The option --threads, of work whose result does not depend on it.
void add_threads(CLI::App& command, int& threads);

/// The subcommands of an app, in the order of their declaration.
template <typename App>
[[nodiscard]] auto subcommands(App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// Whether an option was given.
[[nodiscard]] inline bool given(const CLI::App& command, const std::string& option) {
  return command.get_option(option)->count() > 0;
}

/// Lets every option of the command and its subcommands refuse an empty value, as an unset shell variable leaves it.
void refuse_empty_values(CLI::App& app);

/// What to say of words that no option or subcommand of `app` has taken; "" if all were taken.
[[nodiscard]] std::string unknown_words(const CLI::App& app);

}  // namespace stoss::cli
