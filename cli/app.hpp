#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "stoss/encounter/series.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {

/// Declares all subcommands and options, once: the man page and the completion are made from this declaration too.
/// @param commit that --version names; none if it is empty
void declare(CLI::App& app, std::string_view commit = {});

/// Thrown at the end of a subcommand that has written all it has, but not as accurate as asked for.
struct NotAsAsked {};

/// The help of the command and its subcommands, wrapped to a width in characters: names left, what they mean right.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> help_formatter(std::size_t width);

/// The command line, quoted so that a shell reads it back: for provenance.
[[nodiscard]] std::string command_line();
void set_command_line(int argc, char** argv);

/// The subcommands register themselves. They succeed or throw.
void add_modes(CLI::App& app);
void add_impact(CLI::App& app);
void add_bounce(CLI::App& app);
void add_restitution(CLI::App& app);
void add_oblique(CLI::App& app);
void add_distribution(CLI::App& app);
void add_quasistatic(CLI::App& app);
void add_predict(CLI::App& app);
void add_pulse(CLI::App& app);
void add_row(CLI::App& app);
void add_table(CLI::App& app);
void add_relaxation(CLI::App& app);
void add_materials(CLI::App& app);
void add_schema(CLI::App& app);
void add_sweep(CLI::App& app);
void add_merge(CLI::App& app);
void add_fit(CLI::App& app);
void add_calibrate(CLI::App& app);

/// Adds a subcommand with arguments of its own, on which it runs. They know it as their member `command`.
template <typename Arguments>
Arguments& add_subcommand(CLI::App& app, const std::string& name, const std::string& description,
                          void (*run)(const Arguments&), const std::string& footer) {
  const auto arguments = std::make_shared<Arguments>();
  arguments->command = app.add_subcommand(name, description);
  arguments->command->footer(footer);
  arguments->command->callback([arguments, run] { run(*arguments); });
  return *arguments;
}

/// An option that takes a text, a number, or a list of texts, for each of which it is given once. A number that cannot
/// be read is refused under the name of the input, as in flight_time.
/// @param name  with its dashes, as in "--speed"
/// @param type  what help shows in place of the value
/// @param group of the help
template <typename Value>
CLI::Option* add(CLI::App& command, const std::string& name, Value& value, const std::string& help,
                 const std::string& type, const std::string& group) {
  CLI::Option* option = nullptr;
  if constexpr (std::is_same_v<Value, std::string> || std::is_same_v<Value, std::vector<std::string>>) {
    option = command.add_option(name, value, help)->allow_extra_args(false);
  } else {
    std::string input = name.substr(2);
    std::replace(input.begin(), input.end(), '-', '_');
    const auto read = [input, &value](const std::string& text) {
      constexpr bool whole = std::is_same_v<Value, int> || std::is_same_v<Value, std::optional<int>>;
      if constexpr (whole) {
        value = parse_integer(input, text);
      } else {
        value = parse_number(input, text);
      }
    };
    option = command.add_option_function<std::string>(name, read, help);
  }
  return option->type_name(type)->group(group);
}

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

/// How what was asked for takes less memory, by the options that its subcommand has; "" if by none.
[[nodiscard]] std::string way_to_less_memory(const CLI::App& app);

/// What the core says, without a hint at an input that the subcommand has no option for.
[[nodiscard]] std::string message_of(const CLI::App& app, const NotConverged& failure);

/// What the core says, with the option by which its hint is followed, where the subcommand has it.
[[nodiscard]] std::string message_of(const CLI::App& app, const InvalidInput& refusal);

/// What to say of words that no option or subcommand of `app` has taken; "" if all were taken.
[[nodiscard]] std::string unknown_words(const CLI::App& app);

}  // namespace stoss::cli
