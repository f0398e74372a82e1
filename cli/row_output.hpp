#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "arguments.hpp"
#include "sweep.hpp"

namespace stoss::cli {

/// How rows are written that come one by one: --format, -o, --quiet and --resume.
struct RowOutput {
  OutputArguments output;
  std::string resume;
  CLI::App* command = nullptr;

  void add_to(CLI::App& to);

  /// Lets the rows go to the file of --resume, as CSV. @throws InvalidInput for other options that do not go with it
  void redirect();

  /// Writes the rows that `compute` adds, after those that an earlier run has left, and closes the output, complete or
  /// not.
  /// @throws Interrupted, OutputError, InvalidInput for a file of another job, and what `compute` throws
  void write(const Provenance& provenance, Sweep& sweep, const std::function<void(Report&)>& compute) const;

 private:
  [[nodiscard]] Report open(const Provenance& provenance, Sweep& sweep) const;
};

}  // namespace stoss::cli
