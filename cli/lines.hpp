#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

#include "output.hpp"

namespace stoss::cli {

/// The complete lines of an earlier output, one by one.
class Lines {
 public:
  explicit Lines(const Output& output);

  /// The next line without its end; nothing where no complete line follows. @throws OutputError, InvalidInput for CRLF
  std::optional<std::string> next();

  [[nodiscard]] std::uintmax_t size() const { return size_; }      ///< of the lines read so far
  [[nodiscard]] long count() const { return count_; }              ///< their number
  [[nodiscard]] const std::string& rest() const { return rest_; }  ///< the incomplete last line
  [[nodiscard]] const std::string& path() const { return path_; }  ///< for messages

 private:
  std::string path_;
  std::FILE* stream_;
  std::uintmax_t size_ = 0;
  long count_ = 0;
  std::string rest_;
};

}  // namespace stoss::cli
