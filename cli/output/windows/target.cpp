#include <fcntl.h>
#include <io.h>
#include <share.h>
#include <sys/stat.h>
#include <windows.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <optional>
#include <utility>

#include "output/output.hpp"

namespace stoss::cli {
namespace {

namespace fs = std::filesystem;

/// Opens a file to which no other program can write until it is closed, however this one ends. @return -1: errno says
/// why not
int open_alone(const fs::path& file, int how) {
  int descriptor = -1;
  const errno_t reason =
      _wsopen_s(&descriptor, file.c_str(), _O_RDWR | _O_BINARY | _O_NOINHERIT | how, _SH_DENYWR, _S_IREAD | _S_IWRITE);
  if (reason == 0) return descriptor;
  errno = reason;
  return -1;
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// Writes the text where the file is read and written next.
bool put(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const int done =
        _write(descriptor, text.data(), static_cast<unsigned>(std::min<std::size_t>(text.size(), INT_MAX)));
    if (done <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(done));
  }
  return true;
}

}  // namespace

/// A file beside another one, removed unless it takes its place.
class Beside {
 public:
  /// @throws OutputError that says `path`
  Beside(std::string path, const fs::path& file) : path_(std::move(path)) {
    std::wstring name(MAX_PATH, L'\0');
    if (GetTempFileNameW(folder_of(file).c_str(), L"sto", 0, name.data()) == 0) cannot_write(path_, EACCES);
    name_ = name.c_str();
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;
  ~Beside() { (void)DeleteFileW(name_.c_str()); }

  /// Adds the text at its end, until the disk has it.
  void write(const std::string& text) {
    const int descriptor = open_alone(name_, _O_APPEND);
    if (descriptor < 0) cannot_write(path_, errno);
    const bool written = put(descriptor, text) && _commit(descriptor) == 0;
    const int reason = errno;
    if (_close(descriptor) != 0 || !written) cannot_write(path_, written ? errno : reason);
    size_ += text.size();
  }

  [[nodiscard]] std::uintmax_t size() const { return size_; }

  [[nodiscard]] bool take_place_of(const fs::path& file) const {
    return MoveFileExW(name_.c_str(), file.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) != 0;
  }

 private:
  std::string path_;
  fs::path name_;
  std::uintmax_t size_ = 0;
};

Target::Target(const std::string& path) : path_(path), file_(behind_links(path)) {
  std::error_code none;
  const fs::file_status status = fs::status(file_, none);
  if (fs::is_directory(status)) cannot_write(path, EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    cannot_write(path, "it is not a regular file (for a device leave the option out, and redirect stdout)");
  }
  if (!fs::exists(status) && !fs::is_directory(folder_of(file_), none)) cannot_write(path, ENOENT);
  const int descriptor = open_alone(file_, 0);
  if (descriptor >= 0 || errno != ENOENT) hold(descriptor);
}

Target::~Target() {
  if (!stream_ || !made_) return;
  stream_.reset();  // what is open cannot be removed
  (void)DeleteFileW(file_.c_str());
}

void Target::hold(int descriptor, int /*trial*/) {
  if (descriptor < 0 && _doserrno == ERROR_SHARING_VIOLATION) {
    cannot_write(path_, "another process is writing it");
  }
  if (descriptor < 0) cannot_write(path_, errno);
  stream_.reset(_fdopen(descriptor, "r+b"));
  if (!stream_) cannot_write(path_, errno);
}

void Target::make() {
  while (!stream_) {
    int descriptor = open_alone(file_, _O_CREAT | _O_EXCL);
    made_ = descriptor >= 0;
    if (!made_ && errno == EEXIST) descriptor = open_alone(file_, 0);
    hold(descriptor);
  }
}

void Target::require_room() const { const Beside probe(path_, file_); }

void Target::prepare(const std::string& text) {
  if (!beside_) beside_ = std::make_unique<Beside>(path_, file_);
  beside_->write(text);
}

void Target::replace(const std::string& text) {
  prepare(text);
  make();
  stream_.reset();  // what is open cannot be replaced: another process may come between
  const bool replaced = beside_->take_place_of(file_);
  const DWORD reason = GetLastError();
  hold(open_alone(file_, 0));
  if (!replaced) cannot_write(path_, reason == ERROR_DISK_FULL ? ENOSPC : EACCES);
  size_ = beside_->size();
  beside_.reset();
  made_ = false;
}

bool Target::is_empty() const { return stream_ && _filelengthi64(_fileno(stream())) == 0; }

void Target::extend(std::uintmax_t size, const std::string& text) {
  const int descriptor = _fileno(stream());
  const auto kept = static_cast<std::int64_t>(size);
  const auto cut = [&] { return _chsize_s(descriptor, kept) == 0 && _lseeki64(descriptor, kept, SEEK_SET) == kept; };
  if (!cut()) cannot_write(path_, errno);
  if (!put(descriptor, text)) {
    const int reason = errno;
    (void)cut();
    cannot_write(path_, reason);
  }
  size_ = size + text.size();
  made_ = false;
}

// While the file is open here, the system lets no other process remove, replace or write it.
void Target::require_unchanged(std::uintmax_t /*size*/, const std::string& /*more*/) {}

void Target::close() {
  if (std::fclose(stream_.release()) != 0) cannot_write(path_, errno);
}

}  // namespace stoss::cli
