#include "options.hpp"

#include <fmt/format.h>

#include "numbers.hpp"
#include "stoss/errors.hpp"
#include "suggestion.hpp"
#include "text.hpp"

namespace stoss::cli {
namespace {

template <typename Value, typename Parse>
CLI::Option* add_parsed(CLI::App& command, const std::string& name, Value& value, const std::string& help,
                        Parse parse) {
  const auto read = [name, &value, parse](const std::string& text) { value = parse(name.substr(2), text); };
  return command.add_option_function<std::string>(name, read, help);
}

/// The names that may stand where `word` stands.
std::vector<std::string> candidates(const CLI::App& app) {
  std::vector<std::string> names;
  const auto parsed = app.get_subcommands();
  if (parsed.empty()) {
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
      names.push_back(command->get_name());
    }
  }
  for (const CLI::Option* option : (parsed.empty() ? app : *parsed.front()).get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

}  // namespace

CLI::Option* add_number(CLI::App& command, const std::string& name, double& value, const std::string& help) {
  return add_parsed(command, name, value, help, parse_number);
}

CLI::Option* add_number(CLI::App& command, const std::string& name, std::optional<double>& value,
                        const std::string& help) {
  return add_parsed(command, name, value, help, parse_number);
}

CLI::Option* add_integer(CLI::App& command, const std::string& name, int& value, const std::string& help) {
  return add_parsed(command, name, value, help, parse_integer);
}

CLI::Option* add_integer(CLI::App& command, const std::string& name, std::optional<int>& value,
                         const std::string& help) {
  return add_parsed(command, name, value, help, parse_integer);
}

void add_threads(CLI::App& command, int& threads) {
  add_integer(command, "--threads", threads, "Threads, 0 for all cores; results do not depend on it\n(default: 0)")
      ->type_name("N")
      ->group("Resolution");
}

void refuse_empty_values(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_expected_min() == 0) continue;  // a flag
    const std::string name = option->get_single_name();
    option->transform([name](std::string text) {
      if (text.empty()) throw InvalidInput(fmt::format("{}: got '', allowed a value (is a variable not set?)", name));
      return text;
    });
  }
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) refuse_empty_values(*command);
}

std::string unknown_words(const CLI::App& app) {
  const auto unknown = app.remaining(true);
  if (unknown.empty()) return {};
  const std::string word = unknown.front().substr(0, unknown.front().find('='));
  const std::string similar = nearest(word, candidates(app));
  return "unknown argument: " + shortened(word) + (similar.empty() ? "" : fmt::format(", did you mean {}?", similar));
}

}  // namespace stoss::cli
