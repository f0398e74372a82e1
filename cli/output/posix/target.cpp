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

#include "output/posix/beside.hpp"
#include "process/process.hpp"

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

/// Whether the folder has been removed while something, as this process by its working directory, still holds it.
bool is_removed(const fs::path& folder) {
  struct stat status {};
  return stat(folder.c_str(), &status) == 0 && status.st_nlink == 0;
}

constexpr int flags = O_RDWR | O_APPEND | O_CLOEXEC | O_NOCTTY | O_NONBLOCK;
constexpr int most_trials = 100;  // to open a file that others make and remove

}  // namespace

Target::Target(const std::string& path) : path_(path), file_(behind_links(path)) {
  struct stat status {};
  if (stat(path.c_str(), &status) == 0) {
    require_file(path, status);
  } else if (errno != ENOENT || access(folder_of(file_).c_str(), W_OK | X_OK) != 0) {
    cannot_write(path, errno);
  }
  if (is_removed(folder_of(file_))) cannot_write(path, "its folder has been removed");
  for (int trial = 0; !stream_; ++trial) {
    const int descriptor = open(file_.c_str(), flags);
    if (descriptor < 0 && errno == ENOENT) return;
    hold(descriptor, trial);
  }
}

Target::~Target() {
  if (stream_ && made_) unlink(file_.c_str());
}

void Target::hold(int descriptor, int trial) {
  if (descriptor < 0) cannot_write(path_, errno);
  stream_.reset(fdopen(descriptor, "r+"));
  if (!stream_) cannot_write(path_, errno);
  if (const auto holder = lock(descriptor)) {
    made_ = false;
    cannot_write(path_, *holder + " is writing it");
  }
  struct stat status {};
  if (fstat(descriptor, &status) == 0) size_ = static_cast<std::uintmax_t>(status.st_size);
  if (leads_to(file_, descriptor)) return;
  stream_.reset();
  if (trial >= most_trials) cannot_write(path_, "another process removes it again and again");
}

void Target::make() {
  for (int trial = 0; !stream_; ++trial) {
    int descriptor = open(file_.c_str(), flags | O_CREAT | O_EXCL, 0666);  // ENOENT: the folder is gone
    made_ = descriptor >= 0;
    if (!made_ && errno == EEXIST) {
      descriptor = open(file_.c_str(), flags);
      if (descriptor < 0 && errno == ENOENT && trial < most_trials) continue;  // removed in between
    }
    hold(descriptor, trial);
  }
}

void Target::require_room() const { const Beside probe(path_, file_); }

void Target::prepare(const std::string& text) {
  if (!beside_) beside_ = std::make_unique<Beside>(path_, file_);
  beside_->write(text);
}

void Target::replace(const std::string& text) {
  prepare(text);
  beside_->finish();
  make();
  (void)lock(fileno(beside_->stream()));
  stream_.reset(beside_->take_place_of(file_, fileno(stream_.get())));
  size_ = beside_->size();
  beside_.reset();
  made_ = false;
}

void Target::require_unchanged(std::uintmax_t size, const std::string& more) {
  const int descriptor = fileno(stream());
  if (!leads_to(file_, descriptor)) {
    made_ = false;
    std::string why = "another process has removed or replaced it";
    const std::string all = content(descriptor).substr(0, static_cast<std::size_t>(size)) + more;
    if (!all.empty()) {
      const auto name = keep(path_, all);
      why += name ? fmt::format(" (what was in it, and is new, is in '{}')", shortened(*name, longest_path))
                  : " (what was in it is lost: no file can be written beside it)";
    }
    cannot_write(path_, why);
  }
  require_alone({});
}

void Target::require_alone(const std::string& added) {
  const int descriptor = fileno(stream());
  struct stat status {};
  if (fstat(descriptor, &status) != 0) cannot_write(path_, errno);
  auto now = static_cast<std::uintmax_t>(status.st_size);
  if (now == size_ + added.size()) {
    size_ = now;
    return;
  }
  made_ = false;
  // What is added stands behind the other's change, or before it, where it stays.
  if (!added.empty() && content(descriptor).ends_with(added)) {
    now -= added.size();
    if (ftruncate(descriptor, static_cast<off_t>(now)) != 0) cannot_write(path_, errno);
  }
  cannot_write(
      path_, fmt::format("another process has changed it, from {} to {} bytes (it is left as it is now)", size_, now));
}

bool Target::is_empty() const {
  struct stat status {};
  return stream_ && fstat(fileno(stream()), &status) == 0 && status.st_size == 0;
}

void Target::extend(std::uintmax_t size, const std::string& text) {
  require_unchanged(size, text);
  const int descriptor = fileno(stream());
  const auto kept = static_cast<off_t>(size);
  if (size < size_ && ftruncate(descriptor, kept) != 0) cannot_write(path_, errno);
  size_ = size;
  if (!put(descriptor, text)) {
    const int reason = errno;
    if (ftruncate(descriptor, kept) != 0) cannot_write(path_, errno);
    cannot_write(path_, reason);
  }
  made_ = false;
  require_alone(text);
}

void Target::close() {
  require_unchanged(size_, "");
  if (std::fclose(stream_.release()) != 0) cannot_write(path_, errno);
}

}  // namespace stoss::cli
