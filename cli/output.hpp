#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

namespace stoss::cli {

/// A file that could not be written or read; the command exits with 4.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Bytes of a file name that a message repeats.
inline constexpr std::size_t longest_path = 240;

/// A file, locked against other processes, or stdout when the path is empty or "-". Every write is checked.
class Output {
 public:
  enum class Use { replace, resume };  ///< whether the content may be read and continued

  /// Opens the file; its content stays until `keep`. @throws OutputError also while another process writes it;
  /// Interrupted
  explicit Output(const std::string& path, Use use = Use::replace);

  /// Keeps the first `size` bytes of a file and writes on behind them.
  void keep(std::uintmax_t size);

  void write(const std::string& text);
  void flush();
  void close();

  [[nodiscard]] const std::string& path() const { return path_; }

  /// For reading what is there, before `keep`.
  [[nodiscard]] std::FILE* stream() const { return file_.get(); }

 private:
  [[noreturn]] void fail() const;
  void open(Use use);
  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  bool regular_ = false;
};

/// Whether two outputs would go to the same place.
[[nodiscard]] bool same_output(const std::string& a, const std::string& b);

}  // namespace stoss::cli
