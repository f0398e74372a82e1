#include "process/process.hpp"

#include <fmt/format.h>

#include "stoss/version.hpp"

namespace stoss::cli {
namespace {

/// What Python runs.
std::string program() {
  return fmt::format(
      "import os, signal, sys\n"
      "def end(*_):\n"
      "    try: os.write(2, b'stoss: error: interrupted\\n')\n"
      "    finally: os._exit(130)\n"
      "if signal.getsignal(signal.SIGINT) is signal.default_int_handler: signal.signal(signal.SIGINT, end)\n"
      "signal.pthread_sigmask(signal.SIG_UNBLOCK, [signal.SIGINT])\n"
      "sys.path = [each for each in sys.path if each]\n"
      "try:\n"
      "    import stoss\n"
      "    got, allowed = stoss.__version__, '{0}'\n"
      "    if got == allowed: from stoss import _commands as command\n"
      "except ImportError as error:\n"
      "    got, allowed = 'none', 'the package stoss for python3 (make python, or pip install . and its bin in PATH): "
      "' + str(error)\n"
      "else:\n"
      "    if got == allowed: sys.exit(command.run_alone(sys.argv[1:], {1}))\n"
      "try: os.write(2, f'stoss: error: Python package: got {{got}}, allowed {{allowed}}\\n'.encode('utf-8', "
      "'replace'))\n"
      "finally: os._exit(4)\n",
      version(), pipe_ends() ? "True" : "False");
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
