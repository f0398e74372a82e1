#include "output/output_options.hpp"

#include <fmt/format.h>

#include <memory>

#include "process/process.hpp"

namespace stoss::cli {

Progress::Progress(const OutputOptions& output, std::size_t total)
    : terminal_(!output.quiet && stderr_is_terminal()),
      visible_(terminal_ && ((!output.path.empty() && output.path != "-") || !stdout_is_terminal())),
      total_(total) {}

void Progress::show(std::size_t done) {
  begun_ = Clock::now();
  if (!visible_) return;
  constexpr std::size_t width = 40;
  const std::size_t full = width * done / total_;
  stoss::cli::show(
      fmt::format("\r[{:#<{}}{:.<{}}] {}/{}{}", "", full, "", width - full, done, total_, done == total_ ? "\n" : ""));
}

void Progress::wait(const std::string& state) {
  constexpr std::chrono::milliseconds patience{1000}, pause{200};
  const auto now = Clock::now();
  if (!terminal_ || now - begun_ < patience || now - shown_ < pause) return;
  shown_ = now;
  waiting_ = true;
  const std::chrono::duration<double> elapsed = now - begun_;
  stoss::cli::show(fmt::format("\r{:79.79}", fmt::format("{:.1f} s, {}", elapsed.count(), state)));
}

void Progress::hide() {
  if (visible_ || waiting_) stoss::cli::show(fmt::format("\r{:80}\r", ""));
  waiting_ = false;
}

Poll waiting(const OutputOptions& output, const std::string& state) {
  return [progress = std::make_shared<Progress>(output, 1), state] {
    heed_interrupts();
    progress->wait(state);
  };
}

}  // namespace stoss::cli
