#include "app.hpp"

#include <fmt/format.h>

#include "input/options.hpp"
#include "process/text.hpp"
#include "stoss/version.hpp"

namespace stoss::cli {
namespace {

std::string& stored_command_line() {
  static std::string line;
  return line;
}

}  // namespace

void declare(CLI::App& app, int& exit_code) {
  app.description("Coefficient of restitution of elastic bodies from first principles");
  app.name("stoss");
  app.set_version_flag("--version", fmt::format("stoss {}", stoss::version()), "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  app.footer(
      "Lengths are in R, speeds in c = sqrt(E/rho), times in R/c, forces in pi R E, frequencies in c/R\n"
      "of the first body (of a sphere: forces in m c^2/R = (4 pi/3) R^2 E; of a rod: L, c, L/c, E A,\n"
      "c/L).\n"
      "Exit codes: 0 ok, 1 not converged, 2 usage, 3 bad input, 4 input/output, 130 interrupted.");
  add_modes(app);
  add_impact(app);
  add_bounce(app);
  add_restitution(app, exit_code);
  add_distribution(app, exit_code);
  add_quasistatic(app);
  add_table(app);
  add_materials(app);
  add_schema(app);
  add_sweep(app);
  add_merge(app);
  refuse_empty_values(app);
}

std::string command_line() { return stored_command_line(); }

void set_command_line(int argc, char** argv) {
  std::string line = "stoss";
  for (int i = 1; i < argc; ++i) line += " " + shell_quoted(argv[i]);
  stored_command_line() = line;
}

}  // namespace stoss::cli
