#pragma once

#include <cstddef>
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

}  // namespace stoss::cli
