#include "process/process.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "output/output.hpp"
#include "stoss/version.hpp"

namespace stoss::cli {
namespace {

std::atomic<int> noted = 0;
static_assert(std::atomic<int>::is_always_lock_free);  // so that a signal handler may write it

void note(int number) { noted = number; }

/// What Python runs.
std::string program() {
  return fmt::format(
      "import sys\n"
      "sys.path = [each for each in sys.path if each]\n"
      "try:\n"
      "    import stoss\n"
      "    got, allowed = stoss.__version__, '{0}'\n"
      "    if got == allowed: from stoss import _commands as command\n"
      "except ImportError as error:\n"
      "    got, allowed = 'none', 'the package stoss for python3 (make python; put its bin into PATH): ' + str(error)\n"
      "else:\n"
      "    if got == allowed: sys.exit(command.main(sys.argv[1:]))\n"
      "print(f'stoss: error: Python package: got {{got}}, allowed {{allowed}}', file=sys.stderr)\n"
      "sys.exit(4)\n",
      version());
}

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

void become_python(const std::vector<std::string>& words) {
  std::vector<std::string> all{"python3", "-c", program()};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> pointers;
  pointers.reserve(all.size() + 1);
  for (std::string& word : all) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execvp(pointers.front(), pointers.data());
  throw OutputError(fmt::format("Python: cannot run python3, whose package stoss does this: {}", std::strerror(errno)));
}

}  // namespace stoss::cli
