#include "process/process.hpp"

#include <fmt/format.h>

namespace stoss::cli {
namespace {

std::string replaced(std::string_view text, char what, std::string_view by) {
  std::string result;
  for (const char c : text) result += c == what ? std::string(by) : std::string(1, c);
  return result;
}

}  // namespace

std::string shell_quoted(std::string_view word) {
  constexpr std::string_view bare = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+:,./-=";
  if (!word.empty() && word.front() != '=' && word.find_first_not_of(bare) == std::string_view::npos) {
    return std::string(word);
  }
  if (visible(word) == word) return fmt::format("'{}'", replaced(word, '\'', "'\\''"));
  const auto octal = [](unsigned char byte) { return fmt::format("\\{:03o}", byte); };
  return fmt::format("$'{}'", visible(replaced(replaced(word, '\\', "\\\\"), '\'', "\\'"), octal));
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::string without_spaces(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

void say(std::string_view line) noexcept {
  try {
    show(visible(line) + "\n");
  } catch (...) {
    show("stoss: error: out of memory\n");
  }
}

}  // namespace stoss::cli
