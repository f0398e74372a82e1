#include "check.hpp"

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <string>

#include "stoss/bodies/disk/modes.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

[[noreturn]] void refuse(std::string_view name, const std::string& got, std::string_view allowed,
                         std::string_view hint) {
  throw InvalidInput::out_of_range(std::string(name), got, std::string(allowed), std::string(hint));
}

std::string with_digits(double value, int digits) {
  std::ostringstream writer;
  writer.imbue(std::locale::classic());
  writer.precision(digits);
  writer << value;
  return writer.str();
}

double read_back(const std::string& text) {
  std::istringstream reader(text);
  reader.imbue(std::locale::classic());
  double value = std::numeric_limits<double>::quiet_NaN();
  reader >> value;
  return value;
}

/// @param inside 1: upwards, -1: downwards
std::string shown_end(double value, double inside) {
  std::string text = rounded(value);
  if (!std::isfinite(value) || value == 0.0 || (read_back(text) - value) * inside >= 0.0) return text;
  const double digit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 5.0);
  return rounded(value + inside * digit);
}

}  // namespace

void require(std::string_view name, double value, const Range& range, std::string_view hint) {
  const bool above = range.low_included ? value >= range.low : value > range.low;
  const bool below = range.high_included ? value <= range.high : value < range.high;
  if (!std::isfinite(value) || !above || !below) refuse(name, shown(value), range.text, hint);
}

void require(std::string_view name, std::int64_t value, std::int64_t low, std::int64_t high, std::string_view hint) {
  if (value < low || value > high) {
    refuse(name, std::to_string(value), std::to_string(low) + " to " + std::to_string(high), hint);
  }
}

void require_poisson(double poisson) {
  constexpr Range allowed{bodies::disk::min_poisson, bodies::disk::max_poisson, true, true, "-0.95 to 0.995"};
  require("poisson", poisson, allowed,
          "2-D Poisson's ratio, plane stress; for plane strain pass nu/(1-nu) of the material");
}

void require_speed(double speed) { require("speed", speed, ranges::speed, "speed of approach, in units of c"); }

void require_loss_time(double loss_time) {
  require("loss_time", loss_time, {0.0, 1e5, true, true, "0 to 100000"},
          "eta of stress = (1 + eta d/dt) elastic stress, in R/c of the body");
}

void require_tolerance(double tolerance, double absolute) {
  require("tolerance", tolerance, ranges::tolerance, "relative error of 1 - eps^2");
  require("absolute", absolute, ranges::absolute, "error of 1 - eps^2 that is small enough");
}

std::string shown(double value) {
  if (std::isnan(value)) return "nan";  // without the sign that some processors give it
  std::string text;
  for (int digits = 10; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    text = with_digits(value, digits);
    if (read_back(text) == value) break;
  }
  return text;
}

std::string rounded(double value, int digits) { return std::isnan(value) ? "nan" : with_digits(value, digits); }

std::string shown_least(double value) { return shown_end(value, 1.0); }

std::string shown_most(double value) { return shown_end(value, -1.0); }

}  // namespace stoss
