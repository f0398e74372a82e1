#pragma once

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstddef>
#include <string>

#include "output/writer.hpp"
#include "stoss/poll.hpp"

namespace stoss::cli {

/// How the result is written: --format, -o, --quiet.
struct OutputOptions {
  std::string format = "table";
  std::string path;
  bool quiet = false;

  void add_to(CLI::App& command);

  /// All but --format.
  void add_place_to(CLI::App& command);

  [[nodiscard]] Format chosen_format() const;

  /// A writer of rows. @param use of the output
  [[nodiscard]] Writer writer(const Provenance& provenance, const Columns& columns,
                              Output::Use use = Output::Use::rows) const;

  /// A line on stderr, unless --quiet.
  void warn(const std::string& text) const;

  /// The warning that linear elasticity has ended. @param where as in "here" or "there"
  void warn_of_strain(double strain, const std::string& where = "there") const;

  /// The warning that bodies turn too far for linear kinematics. @param turned angle
  void warn_of_turning(double turned) const;
};

/// On a terminal: a bar while rows go elsewhere, and what is being done while a row takes longer than a second.
/// Nothing elsewhere.
class Progress {
 public:
  Progress(const OutputOptions& output, std::size_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() {
    if (waiting_) hide();
  }

  void show(std::size_t done);

  /// Says what the row under way has come to, if it takes long. May be called often.
  void wait(const std::string& state);

  /// Makes place for a line of its own on stderr.
  void hide();

 private:
  using Clock = std::chrono::steady_clock;

  bool terminal_;
  bool visible_;
  std::size_t total_;
  bool waiting_ = false;
  Clock::time_point begun_ = Clock::now();  ///< of the row under way
  Clock::time_point shown_ = begun_;
};

/// A poll that leaves at Ctrl-C, and meanwhile says on a terminal for how long what is being done.
[[nodiscard]] Poll waiting(const OutputOptions& output, const std::string& state);

/// How rows are written of which an interrupted run is continued: also --resume.
struct RowOptions {
  OutputOptions output;
  std::string resume;
  CLI::App* command = nullptr;

  void add_to(CLI::App& to);

  /// Lets the rows go to the file of --resume, as CSV. @throws InvalidInput for other options that do not go with it
  void redirect();
};

}  // namespace stoss::cli
