#include "process/text.hpp"

#include <fmt/format.h>

#include "process/system.hpp"

namespace stoss::cli {
namespace {

unsigned byte(char c) { return static_cast<unsigned char>(c); }

bool continues(char c) { return (byte(c) & 0xC0U) == 0x80U; }

/// Bytes of the printable character that `text` begins with; 0: it begins with none.
std::size_t printable(std::string_view text) {
  const unsigned first = byte(text.front());
  if (first < 0x80U) return first >= 0x20U && first != 0x7FU ? 1 : 0;
  if (first < 0xC2U || first > 0xF4U) return 0;
  const std::size_t length = first < 0xE0U ? 2 : first < 0xF0U ? 3 : 4;
  if (text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!continues(text[i])) return 0;
  }
  const bool control = first == 0xC2U && byte(text[1]) < 0xA0U;
  return control ? 0 : length;
}

std::string escaped(char c, fmt::format_string<unsigned> code) {
  if (c == '\n') return "\\n";
  if (c == '\r') return "\\r";
  if (c == '\t') return "\\t";
  return fmt::format(code, byte(c));
}

/// The text with whatever is not printable as `code` says.
std::string escaped(std::string_view text, fmt::format_string<unsigned> code) {
  std::string line;
  while (!text.empty()) {
    const std::size_t length = printable(text);
    line += length == 0 ? escaped(text.front(), code) : std::string(text.substr(0, length));
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return line;
}

std::string replaced(std::string_view text, char what, std::string_view by) {
  std::string result;
  for (const char c : text) result += c == what ? std::string(by) : std::string(1, c);
  return result;
}

}  // namespace

std::string visible(std::string_view text) { return escaped(text, "\\x{:02x}"); }

std::string shell_quoted(std::string_view word) {
  constexpr std::string_view bare = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+:,./-=";
  if (!word.empty() && word.front() != '=' && word.find_first_not_of(bare) == std::string_view::npos) {
    return std::string(word);
  }
  if (visible(word) == word) return fmt::format("'{}'", replaced(word, '\'', "'\\''"));
  return fmt::format("$'{}'", escaped(replaced(replaced(word, '\\', "\\\\"), '\'', "\\'"), "\\{:03o}"));
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
