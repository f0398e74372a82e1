#include "process/interrupt.hpp"

#include <atomic>
#include <csignal>

namespace stoss::cli {
namespace {

std::atomic<int> noted = 0;
static_assert(std::atomic<int>::is_always_lock_free);  // so that a signal handler may write it

void note(int number) { noted = number; }

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

int interrupted() { return noted; }

void heed_interrupts() {
  if (interrupted() != 0) throw Interrupted{};
}

}  // namespace stoss::cli
