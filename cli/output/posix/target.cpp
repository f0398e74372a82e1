#include "output/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

#include "process/text.hpp"

namespace stoss::cli {
namespace {

namespace fs = std::filesystem;

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

/// Locks the open file against other processes until it is closed or this process ends, however it ends. POSIX record
/// locks alone tell which process holds them. This process loses one by closing any descriptor of the file, so an
/// output is opened only once.
/// @return the process that has locked it already, as words; nothing once it is locked, and where files cannot be
/// locked
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

bool same_file(const struct stat& a, const struct stat& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

/// Whether the name still leads to the open file, which another process may have replaced.
bool leads_to(const fs::path& file, int descriptor) {
  struct stat named {
  }, open{};
  return stat(file.c_str(), &named) == 0 && fstat(descriptor, &open) == 0 && same_file(named, open);
}

void require_file(const std::string& path, const struct stat& status) {
  if (S_ISDIR(status.st_mode)) cannot_write(path, EISDIR);
  if (!S_ISREG(status.st_mode)) {
    cannot_write(path, "it is not a regular file (for a pipe or a device leave the option out, and redirect stdout)");
  }
  for (const int standard : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat other {};
    if (fstat(standard, &other) == 0 && same_file(status, other)) {
      cannot_write(path, fmt::format("it is {} already (leave the option out, or redirect elsewhere)",
                                     standard == STDOUT_FILENO ? "stdout" : "stderr"));
    }
  }
}

/// Writes the text at this place, without a buffer of which a part could come later.
bool put(int descriptor, std::string_view text, off_t place) {
  while (!text.empty()) {
    const ssize_t done = pwrite(descriptor, text.data(), text.size(), place);
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(done));
    place += done;
  }
  return true;
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// A file beside another one, removed unless it takes its place.
class Beside {
 public:
  /// @throws OutputError that says `path`
  Beside(std::string path, const fs::path& file)
      : path_(std::move(path)),
        name_(folder_of(file) / (".stoss-" + std::string(6, 'X'))) {  // short: `file` may be as long as names can
    const int descriptor = mkstemp(name_.data());
    if (descriptor < 0) cannot_write(path_, errno);
    stream_ = fdopen(descriptor, "r+");
    if (stream_ != nullptr) return;
    const int reason = errno;
    unlink(name_.c_str());
    cannot_write(path_, reason);
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;
  ~Beside() {
    if (stream_ == nullptr) return;
    (void)std::fclose(stream_);
    unlink(name_.c_str());
  }

  /// Until the disk has it.
  void write(const std::string& text) const {
    if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size() || std::fflush(stream_) != 0 ||
        fsync(fileno(stream_)) != 0) {
      cannot_write(path_, errno);
    }
  }

  /// Becomes the file, with the rights of the one that was open there, and locked. @return its stream
  std::FILE* take_place_of(const fs::path& file, int old) {
    struct stat status {};
    if (fstat(old, &status) != 0 || fchmod(fileno(stream_), status.st_mode & 07777) != 0) cannot_write(path_, errno);
    (void)lock(fileno(stream_));
    if (std::rename(name_.c_str(), file.c_str()) != 0) cannot_write(path_, errno);
    return std::exchange(stream_, nullptr);
  }

 private:
  std::string path_;
  std::string name_;
  std::FILE* stream_ = nullptr;
};

constexpr int flags = O_RDWR | O_CLOEXEC | O_NOCTTY | O_NONBLOCK;

}  // namespace

Target::Target(const std::string& path) : path_(path), file_(behind_links(path)) {
  struct stat status {};
  if (stat(path.c_str(), &status) == 0) {
    require_file(path, status);
  } else if (errno != ENOENT || access(folder_of(file_).c_str(), W_OK | X_OK) != 0) {
    cannot_write(path, errno);
  }
  while (!stream_) {
    const int descriptor = open(file_.c_str(), flags);
    if (descriptor < 0 && errno == ENOENT) return;
    hold(descriptor);
  }
}

Target::~Target() {
  if (stream_ && made_) unlink(file_.c_str());
}

void Target::hold(int descriptor) {
  if (descriptor < 0) cannot_write(path_, errno);
  stream_.reset(fdopen(descriptor, "r+"));
  if (!stream_) cannot_write(path_, errno);
  if (const auto holder = lock(descriptor)) {
    made_ = false;
    cannot_write(path_, *holder + " is writing it");
  }
  if (!leads_to(file_, descriptor)) stream_.reset();
}

void Target::make() {
  while (!stream_) {
    int descriptor = open(file_.c_str(), flags | O_CREAT | O_EXCL, 0666);
    made_ = descriptor >= 0;
    if (!made_ && errno == EEXIST) descriptor = open(file_.c_str(), flags);
    if (descriptor < 0 && errno == ENOENT && access(folder_of(file_).c_str(), X_OK) == 0) continue;
    hold(descriptor);
  }
}

void Target::replace(const std::string& text) {
  Beside beside(path_, file_);
  beside.write(text);
  make();
  stream_.reset(beside.take_place_of(file_, fileno(stream_.get())));
  size_ = text.size();
  made_ = false;
}

bool Target::is_empty() const {
  struct stat status {};
  return stream_ && fstat(fileno(stream()), &status) == 0 && status.st_size == 0;
}

void Target::extend(std::uintmax_t size, const std::string& text) {
  const int descriptor = fileno(stream());
  const auto kept = static_cast<off_t>(size);
  if (ftruncate(descriptor, kept) != 0) cannot_write(path_, errno);
  if (!put(descriptor, text, kept)) {
    const int reason = errno;
    if (ftruncate(descriptor, kept) != 0) cannot_write(path_, errno);
    cannot_write(path_, reason);
  }
  size_ = size + text.size();
  made_ = false;
}

void Target::close() {
  if (std::fclose(stream_.release()) != 0) cannot_write(path_, errno);
}

}  // namespace stoss::cli
