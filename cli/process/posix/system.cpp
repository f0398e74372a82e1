#include "process/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "output/output.hpp"

namespace stoss::cli {
namespace {

std::atomic<int> noted = 0;
static_assert(std::atomic<int>::is_always_lock_free);  // so that a signal handler may write it

void note(int number) { noted = number; }

namespace fs = std::filesystem;

/// Folder of this program.
fs::path own_folder() {
  std::error_code none;
  return fs::read_symlink("/proc/self/exe", none).parent_path();
}

/// Whether Python's packages below a prefix have this project's.
bool has_package(const fs::path& prefix) {
  std::error_code none;
  for (const fs::directory_entry& each : fs::directory_iterator(prefix / "lib", none)) {
    if (each.path().filename().string().rfind("python3", 0) != 0) continue;
    for (const char* packages : {"site-packages", "dist-packages"}) {
      if (fs::exists(each.path() / packages / "stoss" / "__init__.py", none)) return true;
    }
  }
  return false;
}

/// Becomes the program of an environment that has the package: of the build tree that this program is in, or the one
/// in whose `bin` it is. Returns where there is none.
void become_beside(const std::string& name, std::vector<char*> words) {
  const fs::path own = own_folder();
  if (own.empty()) return;
  for (const fs::path& prefix : {own / ".." / ".." / "venv", own / ".." / "venv", own / ".."}) {
    if (!has_package(prefix)) continue;
    std::string program = (prefix / "bin" / name).lexically_normal().string();
    words.front() = program.data();  // by which Python finds its environment
    execv(program.c_str(), words.data());
  }
}

}  // namespace

void prepare_streams() {
  // A closed descriptor 0, 1 or 2 would become that of the next file that is opened. On 1 and 2, writing fails as it
  // did.
  for (int descriptor = 0; descriptor <= 2; ++descriptor) {
    if (fcntl(descriptor, F_GETFD) == -1) (void)open("/dev/null", O_RDONLY);
  }
  (void)std::signal(SIGXFSZ, SIG_IGN);  // a file that must not grow is then an error of writing
}

bool stderr_is_terminal() { return isatty(STDERR_FILENO) != 0; }

bool stdout_is_terminal() { return isatty(STDOUT_FILENO) != 0; }

std::size_t terminal_width() {
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual_width;
}

void show(std::string_view text) noexcept {
  // A reader of stderr that has gone must not end the computation.
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  (void)std::fwrite(text.data(), 1, text.size(), stderr);
  (void)std::signal(SIGPIPE, before);
}

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

int interrupted() { return noted; }

bool pipe_ends() {
  struct sigaction action {};
  return sigaction(SIGPIPE, nullptr, &action) == 0 && action.sa_handler != SIG_IGN;
}

void become(const std::vector<std::string>& words) {
  std::vector<std::string> all = words;
  std::vector<char*> pointers;
  pointers.reserve(all.size() + 1);
  for (std::string& word : all) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  sigset_t held, before;
  sigemptyset(&held);
  sigaddset(&held, SIGINT);
  (void)sigprocmask(SIG_BLOCK, &held, &before);
  become_beside(words.front(), pointers);
  execvp(pointers.front(), pointers.data());
  const int reason = errno;
  for (const fs::path& folder : {own_folder(), fs::path("/usr/local/bin"), fs::path("/usr/bin")}) {
    if (!folder.empty()) execv((folder / words.front()).c_str(), pointers.data());
  }
  (void)sigprocmask(SIG_SETMASK, &before, nullptr);
  throw OutputError(
      fmt::format("Python: cannot run {}, whose package stoss does this: {}", words.front(), std::strerror(reason)));
}

}  // namespace stoss::cli
