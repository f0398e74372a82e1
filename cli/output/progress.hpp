#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "output/output_options.hpp"
#include "stoss/poll.hpp"

namespace stoss::cli {

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

}  // namespace stoss::cli
