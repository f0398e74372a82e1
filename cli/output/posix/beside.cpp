#include "output/posix/beside.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <utility>

#include "output/output.hpp"

namespace stoss::cli {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

bool put(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t done = write(descriptor, text.data(), text.size());
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(done));
  }
  return true;
}

std::string content(int descriptor) {
  std::string text(1 << 16, '\0');
  std::size_t size = 0;
  while (true) {
    const ssize_t done = pread(descriptor, text.data() + size, text.size() - size, static_cast<off_t>(size));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) break;
    size += static_cast<std::size_t>(done);
    if (size == text.size()) text.resize(2 * size);
  }
  text.resize(size);
  return text;
}

std::optional<std::string> keep(const std::string& path, const std::string& text) {
  constexpr int most = 100;  // of names
  for (int i = 1; i <= most; ++i) {
    const std::string name = path + (i == 1 ? ".kept" : fmt::format(".kept-{}", i));
    const int descriptor = open(name.c_str(), O_WRONLY | O_CLOEXEC | O_CREAT | O_EXCL, 0666);
    if (descriptor < 0 && errno == EEXIST) continue;
    if (descriptor < 0) return std::nullopt;
    const bool written = put(descriptor, text) && fsync(descriptor) == 0;
    if (close(descriptor) == 0 && written) return name;
    unlink(name.c_str());
    return std::nullopt;
  }
  return std::nullopt;
}

Beside::Beside(std::string path, const fs::path& file)
    : path_(std::move(path)),
      name_(folder_of(file) / (".stoss-" + std::string(6, 'X'))) {  // short: `file` may be as long as names can
  const int descriptor = mkostemp(name_.data(), O_APPEND | O_CLOEXEC);
  if (descriptor < 0) cannot_write(path_, errno);
  stream_ = fdopen(descriptor, "r+");
  if (stream_ != nullptr) return;
  const int reason = errno;
  unlink(name_.c_str());
  cannot_write(path_, reason);
}

Beside::~Beside() {
  if (stream_ == nullptr) return;
  (void)std::fclose(stream_);
  unlink(name_.c_str());
}

void Beside::write(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size()) cannot_write(path_, errno);
  size_ += text.size();
}

void Beside::finish() const {
  if (std::fflush(stream_) != 0 || fsync(fileno(stream_)) != 0) cannot_write(path_, errno);
}

std::FILE* Beside::take_place_of(const fs::path& file, int old) {
  struct stat status {};
  if (fstat(old, &status) != 0 || fchmod(fileno(stream_), status.st_mode & 07777) != 0) cannot_write(path_, errno);
  if (std::rename(name_.c_str(), file.c_str()) != 0) cannot_write(path_, errno);
  return std::exchange(stream_, nullptr);
}

}  // namespace stoss::cli
