#include "output/output.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "process/process.hpp"

namespace stoss::cli {
namespace {

namespace fs = std::filesystem;

std::string sentence(const std::string& path, std::string_view why) {
  const std::string place = path.empty() ? "to stdout" : fmt::format("'{}'", shortened(path, longest_path));
  return fmt::format("output: cannot write {}: {}", place, why);
}

[[noreturn]] void fail(const std::string& path) {
  const int reason = errno;
  if (reason == EINTR) heed_interrupts();  // while a pipe waited for its reader
  cannot_write(path, reason);
}

}  // namespace

void cannot_write(const std::string& path, std::string_view why) { throw OutputError(sentence(path, why)); }

void cannot_write(const std::string& path, int reason) {
  throw OutputError(sentence(path, std::strerror(reason)), reason);
}

fs::path behind_links(fs::path path) {
  constexpr int most = 40;  // of a loop
  std::error_code none;
  for (int i = 0; i < most && fs::is_symlink(path, none); ++i) path = path.parent_path() / fs::read_symlink(path, none);
  return path;
}

Output::Output(const std::string& path, Use use) : path_(path == "-" ? "" : path), use_(use) {
  if (path_.empty()) return;
  target_ = std::make_unique<Target>(path_);
  if (use != Use::whole) target_->make();
  // Judged before anything is computed: root may write into /proc by its modes, and a full or read-only disk says so
  // only when asked for a file.
  if (use == Use::whole || (use == Use::rows && !target_->is_empty())) target_->require_room();
}

void Output::put(bool grows) {
  const std::string text = std::exchange(pending_, {});
  const bool begun = std::exchange(begun_, true);
  if (!target_) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) fail(path_);
  } else if (begun) {
    target_->add(text);
  } else if (use_ == Use::resume || (grows && target_->is_empty())) {
    target_->extend(kept_, text);
  } else {
    target_->replace(text);
  }
}

void Output::end_row() {
  if (use_ != Use::whole || !target_) return put(true);
  constexpr std::size_t most = 1 << 24;  // of what is kept in memory
  if (pending_.size() > most) target_->prepare(std::exchange(pending_, {}));
}

void Output::close() {
  if (!begun_ || !pending_.empty()) put(false);
  if (target_) target_->close();
}

bool same_output(const std::string& a, const std::string& b) {
  const auto resolved = [](const std::string& path) {
    return behind_links(path.empty() || path == "-" ? "/dev/stdout" : path);
  };
  const auto first = resolved(a), second = resolved(b);
  std::error_code ignored;  // what cannot be looked at cannot be opened either, which is reported then
  if (fs::exists(first, ignored) && fs::exists(second, ignored)) return fs::equivalent(first, second, ignored);
  const auto folder = [](const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); };
  return first.filename() == second.filename() &&
         (folder(first) == folder(second) || fs::equivalent(folder(first), folder(second), ignored));
}

}  // namespace stoss::cli
