#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "messages.hpp"

namespace stoss::cli {

Progress::Progress(const OutputArguments& output, std::size_t total)
    : visible_(!output.quiet && !output.path.empty() && output.path != "-" && isatty(STDERR_FILENO) != 0),
      total_(total) {}

void Progress::show(std::size_t done) {
  if (!visible_) return;
  constexpr std::size_t width = 40;
  const std::size_t full = width * done / total_;
  stoss::cli::show(
      fmt::format("\r[{:#<{}}{:.<{}}] {}/{}{}", "", full, "", width - full, done, total_, done == total_ ? "\n" : ""));
}

void Progress::hide() const {
  if (visible_) stoss::cli::show(fmt::format("\r{:80}\r", ""));
}

}  // namespace stoss::cli
