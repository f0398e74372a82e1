#include "input/encounter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stoss/encounter/series.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

/// An end of a range to six digits, rounded towards its inside, so that what is shown is allowed.
/// @param inside 1: upwards, -1: downwards
std::string shown_end(double value, double inside) {
  const std::string text = fmt::format("{:.6g}", value);
  if ((std::stod(text) - value) * inside >= 0.0) return text;
  const double digit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 5.0);
  return fmt::format("{:.6g}", value + inside * digit);
}

}  // namespace

std::vector<double> parse_series_in(const std::string& name, const std::string& text, Dimension dimension,
                                    const Units& units, const Allowed& allowed) {
  std::vector<double> values = parse_series(name, text);
  const double unit = units.si ? unit_in_si(dimension, *units.si) : 1.0;
  const double least = allowed.least * unit, greatest = allowed.greatest * unit;
  for (double& value : values) {
    if (!(value >= least && value <= greatest)) {
      throw InvalidInput::out_of_range(fmt::format("{}", name), fmt::format("{}", value),
                                       fmt::format("{} to {} {}", shown_end(least, 1.0), shown_end(greatest, -1.0),
                                                   unit_name(dimension, units.si ? units.in_si : units.own)),
                                       fmt::format("{}", allowed.hint));
    }
    // The division may round beyond an end.
    value = std::clamp(value / unit, allowed.least, allowed.greatest);
  }
  return values;
}

}  // namespace stoss::cli
