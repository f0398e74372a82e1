#include "messages.hpp"

#include <csignal>
#include <cstdio>

#include "text.hpp"

namespace stoss::cli {

void show(std::string_view text) noexcept {
  // A reader of stderr that has gone must not end the computation.
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  (void)std::fwrite(text.data(), 1, text.size(), stderr);
  (void)std::signal(SIGPIPE, before);
}

void say(std::string_view line) noexcept {
  try {
    show(visible(line) + "\n");
  } catch (...) {
    show("stoss: error: out of memory\n");
  }
}

}  // namespace stoss::cli
