// The stoss command. Exit codes: 0 ok, 1 not converged, 2 usage, 3 bad input, 4 input/output, 130 interrupted.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <exception>
#include <iostream>
#include <new>
#include <system_error>

#include "arguments.hpp"
#include "interrupt.hpp"
#include "report.hpp"
#include "stoss/errors.hpp"
#include "stoss/version.hpp"

namespace {

enum ExitCode { ok = 0, not_converged = 1, usage = 2, bad_input = 3, input_output = 4, signalled = 128 };

int complain(int code, const std::string& text) {
  fmt::print(stderr, "stoss: error: {}\n", text);
  return code;
}

int run(int argc, char** argv) {
  CLI::App app{"Coefficient of restitution of elastic bodies from first principles", "stoss"};
  app.set_version_flag("--version", fmt::format("stoss {}", stoss::version()), "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  app.footer(
      "Lengths are in R, speeds in c = sqrt(E/rho), times in R/c, forces in pi R E, frequencies in c/R.\n"
      "Exit codes: 0 ok, 1 not converged, 2 usage, 3 bad input, 4 input/output, 130 interrupted.");
  int exit_code = ok;
  stoss::cli::add_modes(app);
  stoss::cli::add_impact(app);
  stoss::cli::add_restitution(app, exit_code);
  stoss::cli::add_quasistatic(app);
  try {
    app.parse(argc, argv);
    return exit_code;
  } catch (const CLI::Success& request) {  // --help and --version
    const int code = app.exit(request);
    std::cout.flush();
    return std::cout ? code : complain(input_output, "output: cannot write to stdout");
  } catch (const CLI::ParseError& error) {
    std::string text = error.what();
    if (const auto end = text.find('\n'); end != std::string::npos) text.resize(end);
    // A misspelt word matters more than what is missing because of it.
    const auto unknown = app.remaining(true);
    if (!unknown.empty()) text = "unknown argument: " + unknown.front();
    return complain(usage, text + " (see stoss --help or stoss SUBCOMMAND --help)");
  } catch (const stoss::InvalidInput& error) {
    return complain(bad_input, error.what());
  } catch (const stoss::NotConverged& error) {
    return complain(not_converged, error.what());
  } catch (const stoss::cli::OutputError& error) {
    // Whoever closed the pipe knows.
    return errno == EPIPE ? input_output : complain(input_output, error.what());
  } catch (const stoss::cli::Interrupted&) {
    return complain(signalled + stoss::cli::interrupted(), "interrupted");
  } catch (const std::bad_alloc&) {
    return complain(bad_input, "memory: this needs more than the machine has (use a smaller cutoff or fewer nodes)");
  } catch (const std::system_error& error) {
    return complain(input_output, std::string("system: ") + error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    stoss::cli::set_command_line(argc, argv);
    return run(argc, argv);
  } catch (...) {
    (void)std::fputs("stoss: error: out of memory, or a defect of stoss\n", stderr);
    return bad_input;
  }
}
