#include "lines.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

#include "stoss/errors.hpp"
#include "text.hpp"

namespace stoss::cli {

Lines::Lines(const Output& output) : path_(shortened(output.path(), longest_path)), stream_(output.stream()) {}

std::optional<std::string> Lines::next() {
  std::string line;
  for (int c = std::getc(stream_); c != EOF; c = std::getc(stream_)) {
    if (c != '\n') {
      line += static_cast<char>(c);
      continue;
    }
    if (!line.empty() && line.back() == '\r') {
      throw InvalidInput(fmt::format(
          "resume: got line ends CRLF in '{}', allowed LF, as stoss writes them (dos2unix converts a file)", path_));
    }
    size_ += line.size() + 1;
    ++count_;
    return line;
  }
  if (std::ferror(stream_) != 0) {
    throw OutputError(fmt::format("resume: cannot read '{}': {}", path_, std::strerror(errno)));
  }
  rest_ = line;
  return std::nullopt;
}

}  // namespace stoss::cli
