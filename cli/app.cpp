#include "app.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "input/inputs.hpp"
#include "process/process.hpp"
#include "stoss/errors.hpp"
#include "stoss/version.hpp"

namespace stoss::cli {
namespace {

std::string stored_command_line;

/// Whether the subcommand that was called has this option.
bool has_option(const CLI::App& app, const std::string& option) {
  const auto called = app.get_subcommands();
  return !called.empty() && called.front()->get_option_no_throw(option) != nullptr;
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

void declare(CLI::App& app, std::string_view commit) {
  app.formatter(help_formatter(terminal_width()));
  app.description("Coefficient of restitution of elastic bodies from first principles");
  app.name("stoss");
  const std::string origin = commit.empty() ? "" : fmt::format(" (commit {})", commit);
  app.set_version_flag("--version", fmt::format("stoss {}{}", stoss::version(), origin), "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  app.footer(
      "Begin with a steel ball that falls on glass:\n"
      "    stoss predict --body sphere --material 'bearing steel' --radius 0.005\n"
      "        --height 0.1 --against half-space,material=glass\n"
      "Without a material: lengths in R, speeds in c = sqrt(E/rho), times in R/c, forces in pi R E, "
      "frequencies in c/R of the first body (of a sphere: forces in m c^2/R = (4 pi/3) R^2 E; of a rod: "
      "L, c, L/c, E A, c/L).\n"
      "Exit codes: 0 ok, 1 not converged, 2 usage, 3 bad input, 4 input/output, 130 interrupted.");
  add_modes(app);
  add_impact(app);
  add_bounce(app);
  add_restitution(app);
  add_oblique(app);
  add_distribution(app);
  add_quasistatic(app);
  add_predict(app);
  add_pulse(app);
  add_row(app);
  add_table(app);
  add_fit(app);
  add_calibrate(app);
  add_relaxation(app);
  add_materials(app);
  add_schema(app);
  add_sweep(app);
  add_merge(app);
  refuse_empty_values(app);
}

std::string command_line() { return stored_command_line; }

void set_command_line(int argc, char** argv) {
  stored_command_line = "stoss";
  for (int i = 1; i < argc; ++i) stored_command_line += " " + shell_quoted(argv[i]);
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
      if (text.empty())
        throw InvalidInput::out_of_range(fmt::format("{}", name), "''", "a value", "is a variable not set?");
      return text;
    });
  }
  for (CLI::App* command : subcommands(app)) refuse_empty_values(*command);
}

std::string way_to_less_memory(const CLI::App& app) {
  using Way = std::pair<const char*, const char*>;
  for (const auto& [option, way] :
       {Way{"--cutoff", "use a smaller --cutoff"}, Way{"--samples", "use fewer --samples"},
        Way{"--tolerance", "use a larger --tolerance"}, Way{"--error", "allow a larger --error"}}) {
    if (has_option(app, option)) return way;
  }
  return {};
}

std::string message_of(const CLI::App& app, const NotConverged& failure) {
  if (failure.input().empty() || has_option(app, "--" + option_of(failure.input()))) return failure.what();
  return failure.failure();
}

std::string message_of(const CLI::App& app, const InvalidInput& refusal) {
  std::string message = refusal.what();
  const std::string way = refusal.way() == "rigid"           ? "--rigid-body"
                          : refusal.way() == "against rigid" ? "--against ...,rigid=1"
                          : refusal.way() == "against"       ? "--against wall"
                                                             : "";
  if (way.empty() || !has_option(app, way.substr(0, way.find(' ')))) return message;
  return message.insert(message.size() - 1, " (" + way + ")");  // behind the hint, which ends the line
}

std::string unknown_words(const CLI::App& app) {
  const auto left = app.remaining(true);
  if (left.empty()) return {};
  const std::string word = left.front().substr(0, left.front().find('='));
  const std::string similar = nearest(word, candidates(app));
  std::string line = "unknown argument: " + shortened(word);
  if (!similar.empty()) return line + fmt::format(", did you mean {}?", similar);
  if (!app.get_subcommands().empty()) return line;
  std::vector<std::string> names;
  for (const CLI::App* command : subcommands(app)) names.push_back(command->get_name());
  return line + fmt::format(", allowed {}", fmt::join(names, ", "));
}

}  // namespace stoss::cli
