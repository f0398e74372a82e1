#include "stoss/encounter/series.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "stoss/encounter/visible.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<70>>;

/// An exact number: numerator/denominator, with a denominator above 0.
struct Fraction {
  Integer numerator;
  Integer denominator = 1;
};

/// The double nearest to a fraction, of two the even one; infinite beyond the largest double.
double nearest(const Fraction& exact) {
  const Integer size = abs(exact.numerator);
  if (size == 0) return 0.0;
  const auto bits = [](const Integer& number) { return static_cast<int>(msb(number)); };
  const auto shifted = [](const Integer& number, int places) {
    return places > 0 ? Integer(number << places) : number;
  };
  int exponent = bits(size) - bits(exact.denominator);  // 2^exponent <= size/denominator, or the one below
  if (shifted(size, -exponent) < shifted(exact.denominator, exponent)) --exponent;
  constexpr int digits = std::numeric_limits<double>::digits;
  constexpr int lowest = std::numeric_limits<double>::min_exponent - digits;  // exponent of the smallest double
  const int unit = std::max(exponent - (digits - 1), lowest);
  const Integer divisor = shifted(exact.denominator, unit);
  Integer quotient, remainder;
  divide_qr(shifted(size, -unit), divisor, quotient, remainder);
  remainder *= 2;
  if (remainder > divisor || (remainder == divisor && bit_test(quotient, 0))) ++quotient;
  const double value = std::ldexp(quotient.convert_to<double>(), unit);
  return exact.numerator < 0 ? -value : value;
}

/// The double nearest to a number above 0 of 70 digits.
double nearest(const Real& value) {
  int exponent = 0;
  constexpr int places = std::numeric_limits<Real>::digits;
  const Integer mantissa(ldexp(frexp(value, &exponent), places));
  const int shift = exponent - places;
  return shift < 0 ? nearest({mantissa, Integer(1) << -shift}) : nearest({Integer(mantissa << shift)});
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// What is typed for one option, and what may be.
struct Typed {
  std::string_view name;
  std::string_view text;
  const char* allowed;

  [[noreturn]] void refuse(const std::string& reason) const {
    throw InvalidInput::out_of_range(std::string(name), in_quotes(text), allowed, reason);
  }
};

constexpr const char* one_number = "one decimal number, as in 0.33 or 1e-4";
constexpr const char* one_integer = "one whole number, as in 64 or 1e3";
constexpr const char* many_numbers = "a number, a list a,b,c, log:a:b:n or lin:a:b:n";

/// A number as it was typed, and the double nearest to it.
struct Number {
  Fraction exact;
  double value;
};

/// Reads digits from the front of a text.
std::string take_digits(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  const auto count = static_cast<std::size_t>(end - text.begin());
  std::string digits(text.substr(0, count));
  text.remove_prefix(count);
  return digits;
}

/// Reads a sign from the front of a text; whether it is a minus.
bool take_sign(std::string_view& text) {
  const bool minus = !text.empty() && text.front() == '-';
  if (minus || (!text.empty() && text.front() == '+')) text.remove_prefix(1);
  return minus;
}

Number number(const Typed& typed, std::string_view part) {
  part.remove_prefix(std::min(part.find_first_not_of(' '), part.size()));
  part = part.substr(0, part.find_last_not_of(' ') + 1);
  if (part.empty()) typed.refuse("a number is missing");
  const std::string which = part == typed.text ? "it" : in_quotes(part);

  std::string_view rest = part;
  const bool negative = take_sign(rest);
  std::string digits = take_digits(rest);
  long power = 0;  // of ten
  if (!rest.empty() && rest.front() == '.') {
    rest.remove_prefix(1);
    const std::string decimals = take_digits(rest);
    digits += decimals;
    power = -static_cast<long>(decimals.size());
  }
  bool decimal = !digits.empty();
  if (!rest.empty() && (rest.front() == 'e' || rest.front() == 'E')) {
    rest.remove_prefix(1);
    const bool minus = take_sign(rest);
    std::string typed_power = take_digits(rest);
    decimal = decimal && !typed_power.empty();
    typed_power.erase(0, typed_power.find_first_not_of('0'));
    constexpr std::size_t most = 9;  // digits; a longer exponent is beyond any double
    const long size = typed_power.size() > most ? 1'000'000'000 : std::strtol(typed_power.c_str(), nullptr, 10);
    power += minus ? -size : size;
  }
  if (!decimal || !rest.empty()) typed.refuse(which + " is not a decimal number");

  digits.erase(0, digits.find_first_not_of('0'));
  if (digits.empty()) return {{0}, negative ? -0.0 : 0.0};
  // Its leading digit stands for this power of ten; of those far outside, no fraction is made.
  const long leading = power + static_cast<long>(digits.size());
  const auto beyond = [&] { typed.refuse(which + " is beyond double precision, about 1e-308 to 1e308"); };
  if (std::abs(leading) > 400) beyond();
  Fraction exact{Integer(digits)};
  if (negative) exact.numerator = -exact.numerator;
  const Integer ten = pow(Integer(10), static_cast<unsigned>(std::abs(power)));
  (power < 0 ? exact.denominator : exact.numerator) *= ten;
  const double value = nearest(exact);
  if (value == 0.0 || std::isinf(value)) beyond();
  return {exact, value};
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t end = text.find(separator); end != std::string_view::npos; end = text.find(separator)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

/// The values between the ends.
std::vector<double> arithmetic(const Fraction& first, const Fraction& last, int count) {
  const Integer start = first.numerator * last.denominator;
  const Integer rise = last.numerator * first.denominator - start;
  const Integer denominator = first.denominator * last.denominator * (count - 1);
  std::vector<double> values;
  for (int i = 1; i + 1 < count; ++i) values.push_back(nearest({start * (count - 1) + rise * i, denominator}));
  return values;
}

std::vector<double> geometric(const Fraction& first, const Fraction& last, int count) {
  const Real start = Real(first.numerator) / Real(first.denominator);
  const Real ratio = Real(last.numerator) / Real(last.denominator) / start;
  std::vector<double> values;
  if (count < 3) return values;
  const Real factor = exp(log(ratio) / (count - 1));
  Real value = start;
  for (int i = 1; i + 1 < count; ++i) values.push_back(nearest(value *= factor));
  return values;
}

std::vector<double> series(const Typed& typed, bool logarithmic) {
  const auto parts = split(typed.text, ':');
  if (parts.size() != 4) typed.refuse("it needs three parts after the first colon");
  const Number first = number(typed, parts[1]), last = number(typed, parts[2]);
  const double count = number(typed, parts[3]).value;
  if (count != std::floor(count) || count < 1 || count > longest_series) {
    typed.refuse("n is " + visible(shortened(parts[3])) + ", not a whole number from 1 to " +
                 std::to_string(longest_series));
  }
  if (logarithmic && (first.value <= 0.0 || last.value <= 0.0)) {
    typed.refuse("a logarithmic series needs ends above 0");
  }
  const auto between = logarithmic ? geometric : arithmetic;
  std::vector<double> values{first.value};
  const std::vector<double> inner = between(first.exact, last.exact, static_cast<int>(count));
  values.insert(values.end(), inner.begin(), inner.end());
  if (count > 1) values.push_back(last.value);
  return values;
}

}  // namespace

double parse_number(std::string_view name, std::string_view text) {
  return number({name, text, one_number}, text).value;
}

int parse_integer(std::string_view name, std::string_view text) {
  const Typed typed{name, text, one_integer};
  const double value = number(typed, text).value;
  if (value != std::floor(value)) typed.refuse("it is not a whole number");
  if (std::abs(value) > std::numeric_limits<int>::max()) typed.refuse("it is too large");
  return static_cast<int>(value);
}

std::vector<double> parse_series(std::string_view name, std::string_view text) {
  const Typed typed{name, text, many_numbers};
  if (text.substr(0, 4) == "log:") return series(typed, true);
  if (text.substr(0, 4) == "lin:") return series(typed, false);
  std::vector<double> values;
  for (const std::string_view part : split(text, ',')) values.push_back(number(typed, part).value);
  return values;
}

}  // namespace stoss
