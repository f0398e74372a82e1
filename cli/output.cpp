#include "output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "interrupt.hpp"
#include "lock.hpp"
#include "text.hpp"

namespace stoss::cli {
Output::Output(const std::string& path, Use use) : path_(path == "-" ? "" : path), file_(stdout, std::fflush) {
  if (!path_.empty()) open(use);
}

void Output::open(Use use) {
  const bool resume = use == Use::resume;
  const int descriptor = ::open(path_.c_str(), (resume ? O_RDWR : O_WRONLY) | O_CREAT | O_CLOEXEC | O_NOCTTY, 0666);
  if (descriptor < 0) fail();
  file_ = {fdopen(descriptor, resume ? "r+" : "w"), std::fclose};
  if (!file_) fail();
  struct stat status {};
  regular_ = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
  const std::string shown = shortened(path_, longest_path);
  if (!regular_) {
    if (resume) throw OutputError(fmt::format("resume: cannot continue '{}': it is not a regular file", shown));
    return;
  }
  if (const auto holder = lock(descriptor)) {
    throw OutputError(fmt::format("output: cannot write '{}': {} is writing it", shown, *holder));
  }
}

void Output::keep(std::uintmax_t size) {
  if (!regular_) return;
  const auto kept = static_cast<off_t>(size);
  if (ftruncate(fileno(file_.get()), kept) != 0 || fseeko(file_.get(), kept, SEEK_SET) != 0) fail();
}

void Output::fail() const {
  const int reason = errno;
  if (reason == EINTR) heed_interrupts();
  const std::string place =
      path_.empty() ? std::string("to stdout") : fmt::format("'{}'", shortened(path_, longest_path));
  const std::string text = fmt::format("output: cannot write {}: {}", place, std::strerror(reason));
  errno = reason;
  throw OutputError(text);
}

void Output::write(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail();
}

void Output::flush() {
  if (std::fflush(file_.get()) != 0) fail();
}

void Output::close() {
  flush();
  if (!path_.empty() && std::fclose(file_.release()) != 0) fail();
}

bool same_output(const std::string& a, const std::string& b) {
  const auto resolved = [](const std::string& path) {
    return path.empty() || path == "-" ? std::filesystem::path("/dev/stdout") : std::filesystem::path(path);
  };
  const auto first = resolved(a), second = resolved(b);
  std::error_code ignored;  // what cannot be looked at cannot be opened either, which is reported then
  if (std::filesystem::is_regular_file(first, ignored)) return std::filesystem::equivalent(first, second, ignored);
  const auto place = std::filesystem::weakly_canonical(first, ignored);
  return place == std::filesystem::weakly_canonical(second, ignored) && place != "/dev/null";
}

}  // namespace stoss::cli
