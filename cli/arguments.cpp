#include "arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "messages.hpp"
#include "numbers.hpp"
#include "stoss/errors.hpp"
#include "text.hpp"

namespace stoss::cli {
namespace {

std::string& stored_command_line() {
  static std::string line;
  return line;
}

}  // namespace

void OutputArguments::add_to(CLI::App& command) {
  command.add_option("--format", format, "Output format (default: table)")
      ->check(CLI::IsMember({"table", "csv", "json"}))
      ->type_name("FORMAT")
      ->group("Output");
  add_place_to(command);
}

void OutputArguments::add_place_to(CLI::App& command) {
  command.add_option("-o,--output", path, "Write to FILE instead of stdout")->type_name("FILE")->group("Output");
  command.add_flag("--quiet", quiet, "No warnings and no progress on stderr")->group("Output");
}

Format OutputArguments::chosen_format() const {
  if (format == "csv") return Format::csv;
  return format == "json" ? Format::json : Format::table;
}

void OutputArguments::warn(const std::string& text) const {
  if (!quiet) say("stoss: warning: " + text);
}

std::vector<double> parse_speeds(const std::string& text, const std::optional<Scales>& si, const SpeedRange& range) {
  std::vector<double> speeds = parse_series("speed", text);
  const double unit = si ? si->speed : 1.0;
  for (double& speed : speeds) {
    const double slowest = range.slowest * unit, fastest = range.fastest * unit;
    if (!(speed >= slowest && speed <= fastest)) {
      throw InvalidInput(fmt::format("speed: got {}, allowed {} to {} {} ({})", speed, lower_end(slowest),
                                     upper_end(fastest), si ? "m/s" : "c", range.hint));
    }
    // The division may round beyond an end.
    speed = std::clamp(speed / unit, range.slowest, range.fastest);
  }
  return speeds;
}

std::string command_line() { return stored_command_line(); }

void set_command_line(int argc, char** argv) {
  std::string line = "stoss";
  for (int i = 1; i < argc; ++i) line += " " + shell_quoted(argv[i]);
  stored_command_line() = line;
}

}  // namespace stoss::cli
