#include "table/c_text.hpp"

#include <cmath>
#include <string_view>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss::table {
namespace {

constexpr std::size_t width = 100;

// ASCII whatever the locale is.
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string upper(std::string text) {
  for (char& c : text) {
    if (is_lower(c)) c = static_cast<char>(c - 'a' + 'A');
  }
  return text;
}

void replace(std::string& text, std::string_view place, std::string_view filling) {
  for (auto at = text.find(place); at != std::string::npos; at = text.find(place, at + filling.size())) {
    text.replace(at, place.size(), filling);
  }
}

/// Characters of Unicode that end a line (U+2028, U+2029) or turn its direction (U+202A to U+202E, U+2066 to U+2069).
bool turns_line(std::string_view three) {
  const auto third = static_cast<unsigned char>(three.back());
  const std::string_view two = three.substr(0, 2);
  return (two == "\xe2\x80" && third >= 0xa8 && third <= 0xae) || (two == "\xe2\x81" && third >= 0xa6 && third <= 0xa9);
}

/// Without what ends a comment, begins another one, or is a trigraph, and without control characters.
std::string harmless(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.size() - i >= 3 && turns_line(text.substr(i, 3))) {
      out += ' ';
      i += 2;
      continue;
    }
    const char c = text[i], before = out.empty() ? ' ' : out.back();
    if ((before == '*' && c == '/') || (before == '/' && c == '*') || (before == '?' && c == '?')) out += ' ';
    const bool control = static_cast<unsigned char>(c) < ' ' || c == '\x7f';
    out += control ? ' ' : c;
  }
  return out;
}

}  // namespace

std::string c_number(double value) {
  std::string text = shown(value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::vector<std::string> c_numbers(const std::vector<double>& values) {
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const double each : values) texts.push_back(c_number(each));
  return texts;
}

std::vector<std::string> c_numbers(const std::vector<std::size_t>& values) {
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const std::size_t each : values) texts.push_back(std::to_string(each));
  return texts;
}

std::string at_most(double error) {
  if (!(error > 0.0)) return shown(error);
  const double unit = std::pow(10.0, std::floor(std::log10(error)) - 1.0);
  const double digits = std::ceil(error / unit);
  // 41 · 10⁻⁵ is not the nearest number to 0.00041.
  return shown(unit < 1.0 ? digits / std::round(1.0 / unit) : digits * unit);
}

std::string c_array(const Language& language, std::string_view type, const std::string& name,
                    const std::string& comment, const std::vector<std::string>& cells) {
  std::string text = worded("@comment@" + comment + "@done@\n", language);
  text += filled(std::string(language.array), name,
                 {{"array", name}, {"type", std::string(type)}, {"size", std::to_string(cells.size())}});
  text += "\n";
  std::string line = " ";
  for (const std::string& cell : cells) {
    if (line.size() + cell.size() + 2 > width) {
      text.append(line).append("\n");
      line.resize(1);
    }
    line.append(" ").append(cell).append(&cell == &cells.back() ? "" : ",");
  }
  return text.append(line).append("\n").append(language.array_end).append("\n");
}

std::string c_comment(const std::vector<std::string>& lines, const Language& language) {
  std::string text;
  for (const std::string& line : lines) {
    text.append(text.empty() ? language.comment : language.line)
        .append(line.empty() ? "" : " ")
        .append(harmless(line))
        .append("\n");
  }
  return text.append(language.comment_end);
}

void require_c_name(const std::string& name) {
  constexpr std::size_t longest = 40;
  bool allowed = !name.empty() && name.size() <= longest && (is_lower(name.front()) || is_upper(name.front()));
  for (const char c : name) allowed = allowed && (is_lower(c) || is_upper(c) || is_digit(c) || c == '_');
  if (allowed) return;
  throw InvalidInput::out_of_range("name", "'" + harmless(name.substr(0, longest)) + "'",
                                   "up to 40 letters, digits and _, a letter first", "names in the code begin with it");
}

std::string filled(std::string text, const std::string& name,
                   const std::vector<std::pair<std::string, std::string>>& fillings) {
  for (const auto& [place, filling] : fillings) replace(text, "@" + place + "@", filling);
  replace(text, "@name@", name);
  replace(text, "@NAME@", upper(name));
  return text;
}

std::string c_file(const std::string& name, const std::vector<std::string>& comment, const std::string& body,
                   const Language& language) {
  require_c_name(name);
  return c_comment(comment, language) + filled(std::string(language.begin), name) + body +
         filled(std::string(language.end), name);
}

}  // namespace stoss::table
