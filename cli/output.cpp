#include "output.hpp"

#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace stoss::cli {

Output::Output(const std::string& path)
    : path_(path == "-" ? "" : path),
      file_(path_.empty() ? stdout : std::fopen(path.c_str(), "w"), path_.empty() ? std::fflush : std::fclose) {
  if (!file_) throw OutputError(fmt::format("output: cannot write '{}': {}", path, std::strerror(errno)));
  (void)lock();
}

Output::Output(const std::string& path, std::uintmax_t size)
    : path_(path), file_(std::fopen(path.c_str(), "r+"), std::fclose) {
  if (!file_) throw OutputError(fmt::format("output: cannot write '{}': {}", path, std::strerror(errno)));
  if (!lock()) throw OutputError(fmt::format("output: cannot write '{}': another stoss is writing it", path));
  const auto kept = static_cast<off_t>(size);
  if (ftruncate(fileno(file_.get()), kept) != 0 || fseeko(file_.get(), kept, SEEK_SET) != 0) fail();
}

bool Output::lock() {
  // Where files cannot be locked, they are written unlocked.
  return path_.empty() || flock(fileno(file_.get()), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

void Output::fail() const {
  throw OutputError(fmt::format("output: cannot write {}: {}", path_.empty() ? "to stdout" : "'" + path_ + "'",
                                std::strerror(errno)));
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
    return path.empty() || path == "-" ? std::filesystem::path("-") : std::filesystem::weakly_canonical(path);
  };
  return resolved(a) == resolved(b);
}

}  // namespace stoss::cli
