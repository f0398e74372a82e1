#include "estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stoss::cli {

std::string with_error(double value, double error) {
  if (std::isfinite(value) && !std::isfinite(error)) return fmt::format("{:.6g} ± {}", value, unknown);
  int decimals = 12;
  if (error > 0.0) decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 12);
  if (decimals < 8 || !std::isfinite(error)) return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, error, decimals);
  return fmt::format("{:.{}f}({:.0f})", value, decimals, error * std::pow(10.0, decimals));
}

Value error_of(const Estimate& estimate) {
  if (std::isfinite(estimate.value) && !std::isfinite(estimate.error)) return std::string(unknown);
  return estimate.error;
}

void add_estimate(Record& record, const std::string& key, const std::string& unit, const Estimate& estimate, int width,
                  const std::string& shown) {
  const Value error = error_of(estimate);
  const bool meaningless = std::holds_alternative<std::string>(error);
  record.push_back({key, unit, estimate.value, width, shown.empty() && meaningless ? std::string(unknown) : shown});
  record.push_back({key + "_error", unit, error});
}

}  // namespace stoss::cli
