#include "output/estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stoss::cli {
namespace {

/// As in 3.49794(14)e-19: the error has two digits and counts units of the last digit of the value.
std::string in_powers_of_ten(double value, double error) {
  const std::string doubt = fmt::format("{:.1e}", error);
  const int last = std::stoi(doubt.substr(4)) - 1;  // power of ten of that digit
  const std::string digits = fmt::format("{}", std::llround(std::abs(value) / std::pow(10.0L, last)));
  return fmt::format("{}{}.{}({}{})e{:+03}", value < 0.0 ? "-" : "", digits[0], digits.substr(1), doubt[0], doubt[2],
                     last + static_cast<int>(digits.size()) - 1);
}

}  // namespace

std::string with_error(double value, double error) {
  if (std::isfinite(value) && !std::isfinite(error)) return fmt::format("{:.6g} ± {}", value, unknown);
  constexpr int most = 12;
  int decimals = most;
  if (error > 0.0) decimals = std::max(1 - static_cast<int>(std::floor(std::log10(error))), 0);
  const double size = std::abs(value);
  if (decimals > most && size < 1e-6 && error < size && error > 1e-15 * size) return in_powers_of_ten(value, error);
  decimals = std::min(decimals, most);
  if (decimals < 8 || !std::isfinite(error)) return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, error, decimals);
  return fmt::format("{:.{}f}({:.0f})", value, decimals, error * std::pow(10.0, decimals));
}

Value error_of(double value, double error) {
  if (std::isfinite(value) && !std::isfinite(error)) return std::string(unknown);
  return error;
}

}  // namespace stoss::cli
