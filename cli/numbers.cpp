#include "numbers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "stoss/errors.hpp"
#include "text.hpp"

namespace stoss::cli {
namespace {

/// What is typed for one option, and what may be.
struct Typed {
  std::string_view name;
  const std::string& text;
  std::string_view allowed;

  [[noreturn]] void refuse(const std::string& reason) const {
    throw InvalidInput(fmt::format("{}: got '{}', {} (allowed: {})", name, shortened(text), reason, allowed));
  }
};

constexpr std::string_view one_number = "one decimal number, as in 0.33 or 1e-4";
constexpr std::string_view one_integer = "one whole number, as in 64 or 1e3";
constexpr std::string_view many_numbers = "a number, a list a,b,c, log:a:b:n or lin:a:b:n";

double number(const Typed& typed, std::string part) {
  part.erase(0, part.find_first_not_of(' '));
  part.erase(part.find_last_not_of(' ') + 1);
  if (part.empty()) typed.refuse("a number is missing");
  const std::string unsigned_part = part.substr(part[0] == '+' || part[0] == '-' ? 1 : 0);
  const std::string which = part == typed.text ? "it" : fmt::format("'{}'", shortened(part));
  const char* const last = unsigned_part.data() + unsigned_part.size();
  double value = 0.0;
  const auto [end, error] = std::from_chars(unsigned_part.data(), last, value);
  // from_chars also reads a second sign, nan and inf.
  const bool decimal = end == last && unsigned_part.find_first_of("0123456789.") == 0;
  if (!decimal || error == std::errc::invalid_argument) {
    typed.refuse(which + " is not a decimal number");
  }
  const bool zero =
      unsigned_part.substr(0, unsigned_part.find_first_of("eE")).find_first_of("123456789") == std::string::npos;
  if (error != std::errc{} || (value == 0.0 && !zero)) {
    typed.refuse(which + " is beyond double precision, about 1e-308 to 1e308");
  }
  return part[0] == '-' ? -value : value;
}

std::vector<double> series(const Typed& typed, bool logarithmic) {
  const auto parts = split(typed.text, ':');
  if (parts.size() != 4) typed.refuse("it needs three parts after the first colon");
  const double first = number(typed, parts[1]);
  const double last = number(typed, parts[2]);
  const double count = number(typed, parts[3]);
  if (count != std::floor(count) || count < 2 || count > most_numbers) {
    typed.refuse(fmt::format("n is {}, not a whole number from 2 to {}", shortened(parts[3]), most_numbers));
  }
  if (logarithmic && (first <= 0.0 || last <= 0.0)) typed.refuse("a logarithmic series needs ends above 0");
  std::vector<double> values;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double t = i / (count - 1.0);
    values.push_back(logarithmic ? first * std::pow(last / first, t) : first + (last - first) * t);
  }
  values.back() = last;
  return values;
}

/// To six digits, and by one in the last of them to the given side if they lie on the other.
std::string rounded(double value, double side) {
  std::string text = fmt::format("{:.6g}", value);
  if ((std::stod(text) - value) * side >= 0.0) return text;
  const double digit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 5.0);
  return fmt::format("{:.6g}", value + side * digit);
}

}  // namespace

double parse_number(std::string_view name, const std::string& text) { return number({name, text, one_number}, text); }

int parse_integer(std::string_view name, const std::string& text) {
  const Typed typed{name, text, one_integer};
  const double value = number(typed, text);
  if (value != std::floor(value)) typed.refuse("it is not a whole number");
  if (std::abs(value) > std::numeric_limits<int>::max()) typed.refuse("it is too large");
  return static_cast<int>(value);
}

std::vector<double> parse_series(std::string_view name, const std::string& text) {
  const Typed typed{name, text, many_numbers};
  if (text.rfind("log:", 0) == 0) return series(typed, true);
  if (text.rfind("lin:", 0) == 0) return series(typed, false);
  std::vector<double> values;
  for (const std::string& part : split(text, ',')) values.push_back(number(typed, part));
  return values;
}

std::string lower_end(double value) { return rounded(value, 1.0); }

std::string upper_end(double value) { return rounded(value, -1.0); }

}  // namespace stoss::cli
