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

/// Without what ends a comment, begins another one, or is a trigraph, and without control characters.
std::string harmless(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const char before = out.empty() ? ' ' : out.back();
    if ((before == '*' && c == '/') || (before == '/' && c == '*') || (before == '?' && c == '?')) out += ' ';
    const bool control = static_cast<unsigned char>(c) < ' ' || c == '\x7f';
    out += control ? ' ' : c;
  }
  return out;
}

constexpr std::string_view begin = R"(#ifndef @NAME@_RESTITUTION_TABLE
#define @NAME@_RESTITUTION_TABLE

#include <math.h>

#if defined(__GNUC__)
#define @NAME@_FUNCTION static __inline__ __attribute__((unused))
#elif defined(__cplusplus) || (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 199901L)
#define @NAME@_FUNCTION static inline
#else
#define @NAME@_FUNCTION static
#endif
#ifdef __cplusplus
#define @NAME@_INDEX(x) static_cast<int>(x)
#else
#define @NAME@_INDEX(x) ((int)(x))
#endif

)";

constexpr std::string_view end = R"(
#undef @NAME@_FUNCTION
#undef @NAME@_INDEX

#endif
)";

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

std::string c_array(const std::string& type, const std::string& name, const std::string& comment,
                    const std::vector<std::string>& cells) {
  std::string text =
      "/* " + comment + " */\nstatic const " + type + " " + name + "[" + std::to_string(cells.size()) + "] = {\n";
  std::string line = " ";
  for (const std::string& cell : cells) {
    if (line.size() + cell.size() + 2 > width) {
      text.append(line).append("\n");
      line.resize(1);
    }
    line.append(" ").append(cell).append(&cell == &cells.back() ? "" : ",");
  }
  return text.append(line).append("\n};\n");
}

std::string c_comment(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) {
    text.append(text.empty() ? "/*" : " *").append(line.empty() ? "" : " ").append(harmless(line)).append("\n");
  }
  return text.append(" */\n");
}

void require_c_name(const std::string& name) {
  constexpr std::size_t longest = 40;
  bool allowed = !name.empty() && name.size() <= longest && (is_lower(name.front()) || is_upper(name.front()));
  for (const char c : name) allowed = allowed && (is_lower(c) || is_upper(c) || is_digit(c) || c == '_');
  if (allowed) return;
  throw InvalidInput::out_of_range("name", "'" + harmless(name.substr(0, longest)) + "'",
                                   "up to 40 letters, digits and _, a letter first", "names in C begin with it");
}

std::string filled(std::string text, const std::string& name,
                   const std::vector<std::pair<std::string, std::string>>& fillings) {
  for (const auto& [place, filling] : fillings) replace(text, "@" + place + "@", filling);
  replace(text, "@name@", name);
  replace(text, "@NAME@", upper(name));
  return text;
}

std::string c_file(const std::string& name, const std::vector<std::string>& comment, const std::string& body) {
  require_c_name(name);
  std::string text = c_comment(comment);
  text += filled(std::string(begin), name);
  text += body;
  return text + filled(std::string(end), name);
}

}  // namespace stoss::table
