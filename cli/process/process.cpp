#include "process/process.hpp"

#include <fmt/format.h>

#include "process/system.hpp"
#include "stoss/version.hpp"

namespace stoss::cli {
namespace {

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

void heed_interrupts() {
  if (interrupted() != 0) throw Interrupted{};
}

void become_python(const std::vector<std::string>& words) {
  std::vector<std::string> all{"python3", "-c", program()};
  all.insert(all.end(), words.begin(), words.end());
  become(all);
}

}  // namespace stoss::cli
