#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "output_error.hpp"

namespace stoss::cli {

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

  /// Cuts the file off after `size` bytes and adds the text. @throws OutputError
  void extend(std::uintmax_t size, const std::string& text);

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
  bool made_ = false;
};

}  // namespace stoss::cli
