#include "numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

constexpr long max_length = 1'000'000;

[[noreturn]] void refuse(std::string_view name, const std::string& text, std::string_view reason) {
  throw InvalidInput(
      fmt::format("{}: got '{}', {} (allowed: a number, a list a,b,c, log:a:b:n or lin:a:b:n)", name, text, reason));
}

double parse_number(std::string_view name, const std::string& text, std::string part) {
  part.erase(0, part.find_first_not_of(' '));
  part.erase(part.find_last_not_of(' ') + 1);
  if (part.empty()) refuse(name, text, "a number is missing");
  const char* begin = part.data() + (part.size() > 1 && part[0] == '+' ? 1 : 0);
  double value = 0.0;
  const auto [end, error] = std::from_chars(begin, part.data() + part.size(), value);
  if (error != std::errc{} || end != part.data() + part.size()) {
    refuse(name, text, fmt::format("'{}' is not a number", part));
  }
  return value;
}

std::vector<double> series(std::string_view name, const std::string& text, bool logarithmic) {
  const auto parts = split(text, ':');
  if (parts.size() != 4) refuse(name, text, "it has not three parts after the first colon");
  const double first = parse_number(name, text, parts[1]);
  const double last = parse_number(name, text, parts[2]);
  const double count = parse_number(name, text, parts[3]);
  if (!std::isfinite(first) || !std::isfinite(last)) refuse(name, text, "its ends are not finite");
  if (count != std::floor(count) || count < 2 || count > max_length) refuse(name, text, "n is not from 2 to 1000000");
  if (logarithmic && (first <= 0.0 || last <= 0.0)) refuse(name, text, "a logarithmic series needs ends above 0");
  std::vector<double> values;
  for (long i = 0; i < static_cast<long>(count); ++i) {
    const double t = static_cast<double>(i) / (count - 1.0);
    values.push_back(logarithmic ? first * std::pow(last / first, t) : first + (last - first) * t);
  }
  values.back() = last;
  return values;
}

}  // namespace

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

std::vector<double> parse_series(std::string_view name, const std::string& text) {
  if (text.rfind("log:", 0) == 0) return series(name, text, true);
  if (text.rfind("lin:", 0) == 0) return series(name, text, false);
  std::vector<double> values;
  for (const std::string& part : split(text, ',')) values.push_back(parse_number(name, text, part));
  return values;
}

std::string with_error(double value, double error) {
  int decimals = 12;
  if (error > 0.0) decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 12);
  if (decimals < 8 || !std::isfinite(error)) return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, error, decimals);
  return fmt::format("{:.{}f}({:.0f})", value, decimals, error * std::pow(10.0, decimals));
}

}  // namespace stoss::cli
