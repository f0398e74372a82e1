// POSIX record locks: they alone tell which process holds them. This process loses one by closing any descriptor of
// the file, so an output is opened only once.
#include "lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "text.hpp"

namespace stoss::cli {
namespace {

/// The number of a process and, where the system tells it, its command.
std::string described(pid_t process) {
  if (process <= 0) return "another process";  // on another machine, or in another container
  std::ifstream file(fmt::format("/proc/{}/cmdline", process), std::ios::binary);
  const std::string words{std::istreambuf_iterator<char>(file), {}};
  std::string command;
  for (const std::string& word : split(words.substr(0, words.find_last_not_of('\0') + 1), '\0')) {
    if (command.empty()) {
      command = std::filesystem::path(word).filename().string();
    } else {
      command += ' ';
      command += shell_quoted(word);
    }
  }
  return fmt::format("process {}{}", process, command.empty() ? "" : fmt::format(" ({})", shortened(command, 120)));
}

}  // namespace

std::optional<std::string> lock(int descriptor) {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  while (true) {
    if (fcntl(descriptor, F_SETLK, &whole) == 0) return std::nullopt;
    if (errno != EACCES && errno != EAGAIN) return std::nullopt;
    struct flock held = whole;
    if (fcntl(descriptor, F_GETLK, &held) != 0) return described(0);
    if (held.l_type != F_UNLCK) return described(held.l_pid);  // otherwise it has just been released
  }
}

}  // namespace stoss::cli
