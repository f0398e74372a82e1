#pragma once

#include <cstddef>
#include <string>

#include "arguments.hpp"

namespace stoss::cli {

/// A bar on a terminal while rows go to a file; nothing elsewhere.
class Progress {
 public:
  Progress(const OutputArguments& output, std::size_t total);
  void show(std::size_t done);

  /// Makes place for a line of its own on stderr.
  void hide() const;

 private:
  bool visible_;
  std::size_t total_;
};

}  // namespace stoss::cli
