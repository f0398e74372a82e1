#include "stoss/encounter/visible.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace stoss {
namespace {

unsigned byte(char c) { return static_cast<unsigned char>(c); }

bool continues(char c) { return (byte(c) & 0xC0U) == 0x80U; }

/// Whether UTF-8 has the second byte after this first one: no longer form than needed, no surrogate, nothing beyond
/// U+10FFFF.
bool goes_on(unsigned first, unsigned second) {
  if (first == 0xE0U) return second >= 0xA0U;
  if (first == 0xEDU) return second < 0xA0U;
  if (first == 0xF0U) return second >= 0x90U;
  if (first == 0xF4U) return second < 0x90U;
  return true;
}

/// Bytes of the printable character that `text` begins with; 0: it begins with none.
std::size_t printable(std::string_view text) {
  const unsigned first = byte(text.front());
  if (first < 0x80U) return first >= 0x20U && first != 0x7FU ? 1 : 0;
  if (first < 0xC2U || first > 0xF4U) return 0;
  const std::size_t length = first < 0xE0U ? 2 : first < 0xF0U ? 3 : 4;
  if (text.size() < length || !goes_on(first, byte(text[1]))) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!continues(text[i])) return 0;
  }
  const bool control = first == 0xC2U && byte(text[1]) < 0xA0U;
  const bool line_end = first == 0xE2U && byte(text[1]) == 0x80U && (byte(text[2]) == 0xA8U || byte(text[2]) == 0xA9U);
  return control || line_end ? 0 : length;
}

std::string hexadecimal(unsigned char byte) {
  constexpr std::string_view digits = "0123456789abcdef";
  return {'\\', 'x', digits[byte / 16U], digits[byte % 16U]};
}

std::string_view without_dashes(std::string_view word) {
  return word.substr(std::min(word.find_first_not_of('-'), word.size()));
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Letters to insert, remove or replace, and neighbours to swap. Capitals are as good as small letters.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last, row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  const auto same = [&](std::size_t i, std::size_t j) { return lower(a[i]) == lower(b[j]); };
  for (std::size_t i = 0; i < a.size(); ++i) {
    before = std::move(last), last = row;
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      row[j + 1] = std::min({last[j] + (same(i, j) ? 0 : 1), row[j] + 1, last[j + 1] + 1});
      const bool swapped = i > 0 && j > 0 && same(i, j - 1) && same(i - 1, j);
      if (swapped) row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
    }
  }
  return row.back();
}

}  // namespace

std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  std::size_t end = most;
  while (end > 0 && continues(text[end])) --end;
  return std::string(text.substr(0, end)) + "... (" + std::to_string(text.size()) + " bytes)";
}

std::string visible(std::string_view text) { return visible(text, hexadecimal); }

std::string visible(std::string_view text, const std::function<std::string(unsigned char byte)>& code) {
  std::string line;
  while (!text.empty()) {
    const char c = text.front();
    const std::size_t length = printable(text);
    if (length > 0) {
      line += text.substr(0, length);
    } else if (c == '\n' || c == '\r' || c == '\t') {
      line += c == '\n' ? "\\n" : c == '\r' ? "\\r" : "\\t";
    } else {
      line += code(static_cast<unsigned char>(c));
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return line;
}

std::string in_quotes(std::string_view text) {
  std::string quoted(1, '\'');
  quoted += visible(shortened(text));
  return quoted += '\'';
}

namespace {

/// Whether three letters and three quarters of the word begin the name, as of ruby and rubber.
bool begin_alike(std::string_view word, std::string_view name) {
  const auto end = std::mismatch(word.begin(), word.end(), name.begin(), name.end()).first;
  const auto alike = static_cast<std::size_t>(end - word.begin());
  return alike >= 3 && 4 * alike >= 3 * word.size();
}

}  // namespace

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  word = without_dashes(word);
  constexpr std::size_t longest = 30;  // of what could be a misspelt option
  if (word.size() > longest) return {};
  std::size_t least = word.size() / 3 + 1;
  std::string best;
  for (const std::string& candidate : candidates) {
    const std::string_view name = without_dashes(candidate);
    const bool begins = word.size() >= 3 && name.substr(0, word.size()) == word;
    const std::size_t difference = begins ? 0 : begin_alike(word, name) ? 1 : distance(word, name);
    if (difference >= least) continue;
    least = difference;
    best = candidate;
  }
  return best;
}

}  // namespace stoss
