#include "input/options.hpp"

#include <fmt/format.h>

#include "input/words.hpp"
#include "process/text.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

template <typename Value, typename Parse>
CLI::Option* add_parsed(CLI::App& command, const std::string& name, Value& value, Parse parse, const std::string& help,
                        const std::string& type, const std::string& group) {
  const auto read = [name, &value, parse](const std::string& text) { value = parse(name.substr(2), text); };
  return command.add_option_function<std::string>(name, read, help)->type_name(type)->group(group);
}

/// The names that may stand where `word` stands.
std::vector<std::string> candidates(const CLI::App& app) {
  std::vector<std::string> names;
  const auto parsed = app.get_subcommands();
  if (parsed.empty()) {
    for (const CLI::App* command : subcommands(app)) names.push_back(command->get_name());
  }
  for (const CLI::Option* option : (parsed.empty() ? app : *parsed.front()).get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

}  // namespace

CLI::Option* add(CLI::App& command, const std::string& name, std::string& value, const std::string& help,
                 const std::string& type, const std::string& group) {
  return command.add_option(name, value, help)->type_name(type)->group(group);
}

CLI::Option* add(CLI::App& command, const std::string& name, double& value, const std::string& help,
                 const std::string& type, const std::string& group) {
  return add_parsed(command, name, value, parse_number, help, type, group);
}

CLI::Option* add(CLI::App& command, const std::string& name, std::optional<double>& value, const std::string& help,
                 const std::string& type, const std::string& group) {
  return add_parsed(command, name, value, parse_number, help, type, group);
}

CLI::Option* add(CLI::App& command, const std::string& name, int& value, const std::string& help,
                 const std::string& type, const std::string& group) {
  return add_parsed(command, name, value, parse_integer, help, type, group);
}

CLI::Option* add(CLI::App& command, const std::string& name, std::optional<int>& value, const std::string& help,
                 const std::string& type, const std::string& group) {
  return add_parsed(command, name, value, parse_integer, help, type, group);
}

CLI::Option* add(CLI::App& command, const std::string& name, std::vector<std::string>& values, const std::string& help,
                 const std::string& type, const std::string& group) {
  return command.add_option(name, values, help)->allow_extra_args(false)->type_name(type)->group(group);
}

CLI::Option* add_choice(CLI::App& command, const std::string& name, std::string& value,
                        const std::vector<std::string>& words, const std::string& help, const std::string& type,
                        const std::string& group) {
  return command.add_option(name, value, help)->check(CLI::IsMember(words))->type_name(type)->group(group);
}

void add_threads(CLI::App& command, int& threads) {
  add(command, "--threads", threads, "Threads, 0 for all cores; results do not depend on it\n(default: 0)", "N",
      "Resolution");
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
  for (CLI::App* command : subcommands(app)) refuse_empty_values(*command);
}

std::string unknown_words(const CLI::App& app) {
  const auto unknown = app.remaining(true);
  if (unknown.empty()) return {};
  const std::string word = unknown.front().substr(0, unknown.front().find('='));
  const std::string similar = nearest(word, candidates(app));
  return "unknown argument: " + shortened(word) + (similar.empty() ? "" : fmt::format(", did you mean {}?", similar));
}

}  // namespace stoss::cli
