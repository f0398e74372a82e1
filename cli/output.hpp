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

/// A file, or stdout when the path is empty or "-". Every write is checked.
class Output {
 public:
  explicit Output(const std::string& path);

  /// Continues a file after its first `size` bytes; what is behind them goes. @throws OutputError also while another
  /// stoss writes it
  Output(const std::string& path, std::uintmax_t size);

  void write(const std::string& text);
  void flush();
  void close();

 private:
  [[noreturn]] void fail() const;
  [[nodiscard]] bool lock();
  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

/// Whether two outputs would go to the same place.
[[nodiscard]] bool same_output(const std::string& a, const std::string& b);

}  // namespace stoss::cli
