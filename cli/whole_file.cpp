#include "whole_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "output.hpp"
#include "text.hpp"

namespace stoss::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path) {
  const int reason = errno;
  const std::string text =
      fmt::format("output: cannot write '{}': {}", shortened(path, longest_path), std::strerror(reason));
  errno = reason;
  throw OutputError(text);
}

/// Whether the text goes to the path itself: to what exists and is no regular file.
bool is_written_directly(const std::string& path) {
  struct stat status {};
  return path.empty() || path == "-" || (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode));
}

/// A file next to the one that it is to become, removed unless it did.
class Beside {
 public:
  explicit Beside(const std::string& path) : path_(path) {
    std::error_code none;
    const fs::path behind_links = fs::canonical(path, none);
    target_ = none ? path : behind_links.string();
    struct stat status {};
    const bool exists = stat(target_.c_str(), &status) == 0;
    if (exists && access(target_.c_str(), W_OK) != 0) fail(path_);
    // The name is short, as that of the file may be as long as names can be.
    const fs::path name = fmt::format(".stoss-{}", getpid());
    temporary_ = (fs::path(target_).parent_path() / name).string();
    unlink(temporary_.c_str());  // of an earlier process of this number
    const int descriptor = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) fail(path_);
    file_ = fdopen(descriptor, "w");
    if (file_ == nullptr || (exists && fchmod(descriptor, status.st_mode & 07777) != 0)) {
      const int reason = errno;
      unlink(temporary_.c_str());
      errno = reason;
      fail(path_);
    }
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;
  ~Beside() {
    if (file_ != nullptr) (void)std::fclose(file_);
    if (!temporary_.empty()) unlink(temporary_.c_str());
  }

  void become(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), file_) != text.size() || std::fflush(file_) != 0) fail(path_);
    if (fsync(fileno(file_)) != 0) fail(path_);
    std::FILE* file = std::exchange(file_, nullptr);
    if (std::fclose(file) != 0 || std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(path_);
    temporary_.clear();
  }

 private:
  std::string path_;
  std::string target_;
  std::string temporary_;
  std::FILE* file_ = nullptr;
};

}  // namespace

void write_whole(const std::string& path, const std::string& text) {
  if (!is_written_directly(path)) return Beside(path).become(text);
  Output output(path);
  output.keep(0);
  output.write(text);
  output.close();
}

void require_writable(const std::string& path) {
  if (!is_written_directly(path)) Beside{path};
}

}  // namespace stoss::cli
