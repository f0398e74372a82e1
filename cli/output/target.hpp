#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stoss::cli {

/// A file that could not be written or read; the command exits with 4.
class OutputError : public std::runtime_error {
 public:
  /// @param reason errno, or 0 where the system has not refused
  explicit OutputError(const std::string& text, int reason = 0) : std::runtime_error(text), reason_(reason) {}

  [[nodiscard]] int reason() const { return reason_; }

 private:
  int reason_;
};

/// Bytes of a file name that a message repeats.
inline constexpr std::size_t longest_path = 240;

/// @param path "" for stdout
/// @throws OutputError
[[noreturn]] void cannot_write(const std::string& path, std::string_view why);
[[noreturn]] void cannot_write(const std::string& path, int reason);

/// What a name leads to, also where nothing is there yet.
[[nodiscard]] std::filesystem::path behind_links(std::filesystem::path path);

/// A regular file that is to be written, locked against other processes for as long as the target lives.
class Target {
 public:
  /// Locks the file, or finds that one can be made; changes nothing.
  /// @throws OutputError for what is no regular file or cannot be written, and while another process writes it
  explicit Target(const std::string& path);
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;
  ~Target();

  /// Makes the file and locks it where there is none. It goes again with the target unless something is written.
  void make();

  /// Puts a file with this text in its place as a whole, or leaves it as it was. @throws OutputError
  void replace(const std::string& text);

  /// Cuts the file off after `size` bytes and adds the text, or nothing of it. @throws OutputError
  void extend(std::uintmax_t size, const std::string& text);

  /// Adds the text at the end of what was written, or nothing of it. @throws OutputError
  void add(const std::string& text) { extend(size_, text); }

  /// Whether the file is there and has nothing to lose.
  [[nodiscard]] bool is_empty() const;

  void close();

  /// Of the file as it is now; nullptr where there is none.
  [[nodiscard]] std::FILE* stream() const { return stream_.get(); }

 private:
  struct Close {
    void operator()(std::FILE* file) const { (void)std::fclose(file); }
  };

  void hold(int descriptor);

  std::string path_;            // as the user wrote it
  std::filesystem::path file_;  // behind links
  std::unique_ptr<std::FILE, Close> stream_;
  std::uintmax_t size_ = 0;  // of what was written
  bool made_ = false;
};

}  // namespace stoss::cli
