// The stoss command. Exit codes: 0 ok, 1 not converged, 2 usage, 3 bad input, 4 input/output, 130 interrupted.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <exception>
#include <iostream>
#include <new>
#include <system_error>

#include "app.hpp"
#include "commit.hpp"
#include "output/output.hpp"
#include "process/process.hpp"
#include "stoss/errors.hpp"

namespace {

enum ExitCode { ok = 0, not_converged = 1, usage = 2, bad_input = 3, input_output = 4, signalled = 128 };

int complain(int code, const std::string& text) {
  stoss::cli::say("stoss: error: " + text);
  return code;
}

/// The arguments from last to first, as CLI11 takes them; an empty value behind = as a word of its own.
std::vector<std::string> words(int argc, char** argv) {
  std::vector<std::string> list;
  for (int i = argc - 1; i > 0; --i) {
    std::string word = argv[i];
    if (word.rfind("--", 0) == 0 && word.find('=') == word.size() - 1) {
      list.emplace_back();
      word.pop_back();
    }
    list.push_back(std::move(word));
  }
  return list;
}

int run(int argc, char** argv) {
  CLI::App app;
  stoss::cli::declare(app, stoss::cli::commit());
  try {
    app.parse(words(argc, argv));
    return ok;
  } catch (const stoss::cli::NotAsAsked&) {
    return not_converged;
  } catch (const CLI::Success& request) {  // --help and --version
    const int code = app.exit(request);
    std::cout.flush();
    return std::cout ? code : complain(input_output, "output: cannot write to stdout");
  } catch (const CLI::ParseError& error) {
    // A misspelt word matters more than what is missing because of it.
    std::string text = stoss::cli::unknown_words(app);
    if (text.empty()) text = stoss::shortened(error.what(), 160);
    return complain(usage, text + " (see stoss --help or stoss SUBCOMMAND --help)");
  } catch (const stoss::InvalidInput& error) {
    return complain(bad_input, stoss::cli::message_of(app, error));
  } catch (const stoss::NotConverged& error) {
    return complain(not_converged, stoss::cli::message_of(app, error));
  } catch (const stoss::cli::OutputError& error) {
    // Whoever closed the pipe knows.
    return error.reason() == EPIPE ? input_output : complain(input_output, error.what());
  } catch (const stoss::cli::Interrupted&) {
    return complain(signalled + stoss::cli::interrupted(), "interrupted");
  } catch (const std::bad_alloc&) {
    const std::string way = stoss::cli::way_to_less_memory(app);
    return complain(bad_input, "memory: this needs more than the machine has" + (way.empty() ? "" : " (" + way + ")"));
  } catch (const std::system_error& error) {
    const bool thread = error.code() == std::errc::resource_unavailable_try_again;
    return complain(input_output, thread ? "threads: cannot start as many as asked for (use --threads 1)"
                                         : std::string("system: ") + error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  stoss::cli::prepare_streams();
  try {
    stoss::cli::set_command_line(argc, argv);
    return run(argc, argv);
  } catch (...) {
    stoss::cli::say("stoss: error: out of memory, or a defect of stoss");
    return bad_input;
  }
}
