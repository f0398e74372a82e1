// Makes the man page or the completion: copies a template and puts in what the command declares.
//
//   stoss_documents TEMPLATE OUTPUT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app.hpp"
#include "process/process.hpp"
#include "stoss/version.hpp"

namespace {

using stoss::cli::subcommands;

/// -o, --output
std::vector<std::string> names(const CLI::Option& option) {
  std::vector<std::string> all;
  for (const std::string& name : option.get_snames()) all.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) all.push_back("--" + name);
  return all;
}

/// Text for roff. A line that is indented by two stands by itself, as in the help; one indented by more goes on.
std::string roff(const std::string& text) {
  std::string out;
  for (const std::string& line : stoss::cli::split(text, '\n')) {
    const auto indent = line.find_first_not_of(' ');
    if (!out.empty()) out += indent == 2 ? "\n.br\n" : "\n";
    for (const char c : line.substr(indent)) {
      if (c == '-' || c == '\\') out += '\\';
      out += c == '\\' ? 'e' : c;
    }
  }
  return out;
}

std::string roff(const CLI::Option& option) {
  std::string head;
  for (const std::string& name : names(option)) head += (head.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
  if (option.get_expected_min() > 0) {
    const std::string type = roff(option.get_type_name());
    // A long list may be broken after a comma, but its lines have no spaces that could be stretched.
    head += fmt::format("{}\\fI{}\\fR", head.empty() ? "" : " ", fmt::join(stoss::cli::split(type, ','), ",\\:"));
  }
  constexpr std::size_t line = 100;
  if (head.size() > line) head = ".ad l\n" + head + "\n.ad b";
  return ".TP\n" + head + "\n" + roff(option.get_description()) + ".\n";
}

/// All options, at the end those that every subcommand has that prints results: not what is handed over to Python.
std::string roff_options(const CLI::App& app) {
  std::map<std::string, std::size_t> owners;
  std::size_t printing = 0;
  for (const CLI::App* command : subcommands(app)) {
    if (command->get_option_no_throw("--format") == nullptr) continue;
    ++printing;
    for (const CLI::Option* option : command->get_options()) ++owners[roff(*option)];
  }
  std::string text, shared;
  for (const CLI::App* command : subcommands(app)) {
    text += ".SS stoss " + command->get_name() + "\n";
    for (const CLI::Option* option : command->get_options()) {
      const std::string its = roff(*option);
      if (owners[its] < printing) text += its;
      if (owners[its] == printing && command == subcommands(app).front()) shared += its;
    }
  }
  return text + ".SS All subcommands\nThose of sweep and merge, which print no results, are above.\n" + shared;
}

/// What bash is to do behind an option: offer the words of {a,b}, or files, or nothing.
std::string action(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  if (type == "FILE" || type == "DIR" || type == "GRID") return "files=yes";
  const auto begin = type.find('{'), end = type.find('}');
  if (begin == std::string::npos || end == std::string::npos) return "return";
  const auto words = stoss::cli::split(type.substr(begin + 1, end - begin - 1), ',');
  return fmt::format("words=\"{}\"", fmt::join(words, " "));
}

/// The cases of subcommand and word before: what may follow an option.
std::string bash_values(const CLI::App& app) {
  std::map<std::string, std::set<std::string>> patterns;  // of what is to be done
  for (const CLI::App* command : subcommands(app)) {
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_expected_min() == 0) continue;  // a flag
      for (const std::string& name : names(*option)) {
        patterns[action(*option)].insert(fmt::format("\"{} {}\"", command->get_name(), name));
      }
    }
  }
  std::string text;
  for (const auto& [its, words] : patterns) {
    text += fmt::format("    {}) {} ;;\n", fmt::join(words, " | \\\n      "), its);
  }
  for (const CLI::App* command : subcommands(app)) {
    const auto all = command->get_options(&CLI::Option::get_positional);
    if (all.empty()) continue;
    text += fmt::format("    \"{} \"*) [ \"$COMP_CWORD\" -lt 2 ] || [[ \"$current\" == -* ]] || files=yes ;;\n",
                        command->get_name());
  }
  return text;
}

/// The cases of the subcommand: its options.
std::string bash_options(const CLI::App& app) {
  std::string text;
  for (const CLI::App* command : subcommands(app)) {
    std::string all;
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& name : names(*option)) all += (all.empty() ? "" : " ") + name;
    }
    text += fmt::format("    {}) words=\"{}\" ;;\n", command->get_name(), all);
  }
  return text;
}

std::string bash_commands(const CLI::App& app) {
  std::string all;
  for (const CLI::App* command : subcommands(app)) all += command->get_name() + " ";
  return all + "--help --version";
}

/// A line that is only a placeholder gives place to lines, another one to words.
std::string filled(std::string text, const CLI::App& app) {
  const std::vector<std::pair<std::string, std::string>> fillings{{"@OPTIONS@\n", roff_options(app)},
                                                                  {"@BASH_VALUES@\n", bash_values(app)},
                                                                  {"@BASH_OPTIONS@\n", bash_options(app)},
                                                                  {"@BASH_COMMANDS@", bash_commands(app)},
                                                                  {"@VERSION@", std::string(stoss::version())}};
  for (const auto& [place, filling] : fillings) {
    const auto at = text.find(place);
    if (at != std::string::npos) text.replace(at, place.size(), filling);
  }
  return text;
}

bool make(const char* source, const char* target) {
  CLI::App app;
  stoss::cli::declare(app);
  std::ifstream in(source);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::ofstream out(target);
  out << filled(text, app);
  out.close();
  return in && out;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 3 && make(argv[1], argv[2])) return 0;
    std::cerr << "stoss_documents: cannot make TEMPLATE into OUTPUT\n";
  } catch (const std::exception& error) {
    std::cerr << "stoss_documents: " << error.what() << '\n';
  }
  return 1;
}
