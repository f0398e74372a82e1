#include "process/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <io.h>
#include <windows.h>

#include <atomic>
#include <csignal>
#include <cstdio>

#include "output/output.hpp"

namespace stoss::cli {
namespace {

std::atomic<int> noted = 0;
static_assert(std::atomic<int>::is_always_lock_free);  // so that a signal handler may write it

void note(int number) { noted = number; }  // Windows has reset the handler: a second signal ends the program

}  // namespace

void prepare_streams() {
  for (std::FILE* stream : {stdout, stderr}) (void)_setmode(_fileno(stream), _O_BINARY);  // lines end with LF
  (void)SetConsoleOutputCP(CP_UTF8);
}

bool stderr_is_terminal() { return _isatty(_fileno(stderr)) != 0; }

bool stdout_is_terminal() { return _isatty(_fileno(stdout)) != 0; }

std::size_t terminal_width() {
  CONSOLE_SCREEN_BUFFER_INFO its{};
  if (GetConsoleScreenBufferInfo(GetStdHandle(STD_OUTPUT_HANDLE), &its) == 0) return usual_width;
  return static_cast<std::size_t>(its.srWindow.Right - its.srWindow.Left + 1);
}

void show(std::string_view text) noexcept { (void)std::fwrite(text.data(), 1, text.size(), stderr); }

void catch_interrupts() { (void)std::signal(SIGINT, note); }

int interrupted() { return noted; }

bool pipe_ends() { return false; }

void become(const std::vector<std::string>& words) {
  throw OutputError(fmt::format("Python: cannot run {} from here on Windows, where its package stoss does this alone",
                                words.front()));
}

}  // namespace stoss::cli
