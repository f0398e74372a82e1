#pragma once

#include <sys/types.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// Files beside the one that is to be written.
namespace stoss::cli {

[[nodiscard]] std::filesystem::path folder_of(const std::filesystem::path& file);

/// Writes the text without a buffer of which a part could come later: at the end of a file opened to be appended to.
[[nodiscard]] bool put(int descriptor, std::string_view text);

/// All that is to be read from the open file.
[[nodiscard]] std::string content(int descriptor);

/// A new file for what the given one would have got, of the first of the names FILE.kept, FILE.kept-2, … that is free.
/// @return its name; nothing where none can be written
[[nodiscard]] std::optional<std::string> keep(const std::string& path, const std::string& text);

/// A file beside another one, removed unless it takes its place.
class Beside {
 public:
  /// @throws OutputError that says `path`
  Beside(std::string path, const std::filesystem::path& file);
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;
  ~Beside();

  /// Adds the text at its end. @throws OutputError
  void write(const std::string& text);

  /// Waits until the disk has it. @throws OutputError
  void finish() const;

  /// Becomes the file, with the rights of the one that was open there. @return its stream. @throws OutputError
  [[nodiscard]] std::FILE* take_place_of(const std::filesystem::path& file, int old);

  [[nodiscard]] std::uintmax_t size() const { return size_; }
  [[nodiscard]] std::FILE* stream() const { return stream_; }

 private:
  std::string path_;
  std::string name_;
  std::FILE* stream_ = nullptr;
  std::uintmax_t size_ = 0;
};

}  // namespace stoss::cli
