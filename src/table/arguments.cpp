#include "table/arguments.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

void require_rising(const char* name, const std::vector<double>& list, std::size_t fewest) {
  double before = 0.0;
  for (const double each : list) {
    if (!(each > before) || !std::isfinite(each)) {
      throw InvalidInput::out_of_range(std::string(name), shown(each) + " after " + shown(before),
                                       "positive finite ones that rise", "sort them");
    }
    before = each;
  }
  if (list.size() < fewest) {
    throw InvalidInput::out_of_range(std::string(name), std::to_string(list.size()),
                                     std::to_string(fewest) + " or more");
  }
}

void require_count(const char* name, std::size_t got, std::size_t allowed) {
  if (got != allowed) {
    throw InvalidInput::out_of_range(std::string(name), std::to_string(got) + " values", std::to_string(allowed),
                                     "speeds in turn, for all ratios");
  }
}

bool bad(double error) { return !(error >= 0.0) || !std::isfinite(error); }

void require_estimates(const std::vector<Estimate>& values, const std::vector<double>& interpolation_error) {
  for (const Estimate& each : values) {
    if (!std::isfinite(each.value) || bad(each.error)) {
      throw InvalidInput::out_of_range("restitution", shown(each.value) + " with the error " + shown(each.error),
                                       "values with known errors");
    }
  }
  if (std::any_of(interpolation_error.begin(), interpolation_error.end(), bad)) {
    throw InvalidInput::conflict("interpolation_error", "negative or not finite, allowed 0 or more");
  }
}

void require_grid(const char* name, const RuleGrid& grid, bool alike) {
  require_rising("speeds", grid.speeds, 2);
  require_rising("ratios", grid.ratios, 1);
  if (alike && grid.ratios.front() < 1.0) {
    throw InvalidInput::out_of_range("ratios", shown(grid.ratios.front()), "1 or more for bodies that are alike");
  }
  const bool rises =
      std::adjacent_find(grid.slips.begin(), grid.slips.end(), std::greater_equal<>()) == grid.slips.end();
  const bool whole = grid.slips.size() > 2 && grid.slips.front() == -1.0 && grid.slips.back() == 1.0 && rises;
  if (grid.slips.size() != 1 && !whole) {
    throw InvalidInput::out_of_range("slips", std::to_string(grid.slips.size()),
                                     "one, or three and more that rise from -1 to 1");
  }
  const auto intervals = [](const std::vector<double>& places) { return std::max<std::size_t>(places.size(), 2) - 1; };
  require_count(name, grid.values.size(), grid.speeds.size() * grid.slips.size() * grid.ratios.size());
  require_count("interpolation_error", grid.interpolation_error.size(),
                intervals(grid.speeds) * intervals(grid.slips) * intervals(grid.ratios));
  require_estimates(grid.values, grid.interpolation_error);
}

}  // namespace

void require_values(const PairValues& values) {
  require_rising("speeds", values.speeds, 2);
  require_rising("ratios", values.ratios, 3);
  if (values.alike && values.ratios.front() < 1.0) {
    throw InvalidInput::out_of_range("ratios", shown(values.ratios.front()), "1 or more for bodies that are alike",
                                     "their inverses are the same pairs");
  }
  const std::size_t cells = (values.speeds.size() - 1) * (values.ratios.size() - 1);
  require_count("restitution", values.restitution.size(), values.speeds.size() * values.ratios.size());
  require_count("interpolation_error", values.interpolation_error.size(), cells);
  require_estimates(values.restitution, values.interpolation_error);
}

void require_values(const RuleValues& values) {
  require_grid("restitution", values.restitution, values.alike);
  require_grid("sliding", values.sliding, values.alike);
  const RuleGrid &normal = values.restitution, &along = values.sliding;
  if (along.slips.size() < 2)
    throw InvalidInput::out_of_range("slips", "one place of sliding", "two or more, from -1 to 1");
  if (normal.speeds.front() != along.speeds.front() || normal.speeds.back() != along.speeds.back() ||
      normal.ratios.front() != along.ratios.front() || normal.ratios.back() != along.ratios.back()) {
    throw InvalidInput::out_of_range("speeds", "other ends of restitution than of sliding", "the same",
                                     "of ratios, too");
  }
  if (values.friction) require("friction", *values.friction, {0.0, 5.0, false, true, "above 0 to 5"}, "of the values");
}

void require_beyond(Beyond beyond) {
  if (beyond == Beyond::law) {
    throw InvalidInput::out_of_range("beyond", "law", "error or clamp",
                                     "there is no law of slow impacts of unequal bodies");
  }
}

}  // namespace stoss

namespace stoss::table {
namespace {

double to_fifteen_digits(double value) {
  std::stringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::digits10);
  text << value;
  text >> value;
  return value;
}

}  // namespace

std::pair<double, double> speed_range(const RestitutionFunction& function, double scale) {
  return speed_range(function.slowest(), function.fastest(), scale);
}

std::pair<double, double> speed_range(double slowest, double fastest, double scale) {
  require("scale", scale, {0.0, 1e100, false, true, "above 0 to 1e100"},
          "speed of the table over that of the function");
  const double low = slowest * scale, high = fastest * scale;
  return {std::min(low, to_fifteen_digits(low)), std::max(high, to_fifteen_digits(high))};
}

}  // namespace stoss::table
