#include "table/table.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "check.hpp"
#include "stoss/errors.hpp"
#include "table/arguments.hpp"

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
                                     "speeds in turn, for all slips, for all ratios");
  }
}

std::size_t intervals(const std::vector<double>& places) { return std::max<std::size_t>(places.size(), 2) - 1; }

numeric::CubicGrid cubic_of(const TableValues& table) {
  using numeric::Slopes;
  numeric::CubicGrid::Places places{{{}, table.slips, {}}};
  for (const double each : table.speeds) places[0].push_back(std::log(each));
  for (const double each : table.ratios) places[2].push_back(place_of_ratio(each));
  std::vector<double> values;
  for (const Estimate& each : table.values) values.push_back(each.value);
  return {std::move(places),
          {Slopes::monotone, Slopes::parabolic, table.alike ? Slopes::mirrored : Slopes::parabolic},
          values};
}

std::vector<double> errors_of(const TableValues& table) {
  const std::size_t slips = table.slips.size(), ratios = table.ratios.size();
  const double weight =
      (slips > 1 ? table::weight_between_places : 1.0) * (ratios > 1 ? table::weight_between_places : 1.0);
  std::vector<double> errors;
  for (std::size_t i = 0; i < intervals(table.speeds); ++i) {
    for (std::size_t j = 0; j < intervals(table.slips); ++j) {
      for (std::size_t k = 0; k < intervals(table.ratios); ++k) {
        double greatest = 0.0;
        for (const std::size_t a : {i, i + 1}) {
          for (std::size_t b = j; b < std::min(j + 2, slips); ++b) {
            for (std::size_t c = k; c < std::min(k + 2, ratios); ++c) {
              greatest = std::max(greatest, table.values[(a * slips + b) * ratios + c].error);
            }
          }
        }
        errors.push_back(weight * greatest + table.interpolation_error[errors.size()]);
      }
    }
  }
  return errors;
}

}  // namespace

void require_values(const char* name, const TableValues& table) {
  require_rising("speeds", table.speeds, 2);
  require_rising("ratios", table.ratios, 1);
  if (table.alike && table.ratios.front() < 1.0) {
    throw InvalidInput::out_of_range("ratios", shown(table.ratios.front()), "1 or more for bodies that are alike",
                                     "their inverses are the same pairs");
  }
  const std::vector<double>& slips = table.slips;
  const bool rises = std::adjacent_find(slips.begin(), slips.end(), std::greater_equal<>()) == slips.end();
  const bool whole = slips.size() > 2 && slips.front() == -1.0 && slips.back() == 1.0 && rises;
  if (slips.size() != 1 && !whole) {
    throw InvalidInput::out_of_range("slips", std::to_string(slips.size()),
                                     "one, or three and more that rise from -1 to 1");
  }
  require_count(name, table.values.size(), table.speeds.size() * slips.size() * table.ratios.size());
  require_count("interpolation_error", table.interpolation_error.size(),
                intervals(table.speeds) * intervals(slips) * intervals(table.ratios));
  const auto bad = [](double error) { return !(error >= 0.0) || !std::isfinite(error); };
  for (const Estimate& each : table.values) {
    if (!std::isfinite(each.value) || bad(each.error)) {
      throw InvalidInput::out_of_range(std::string(name), shown(each.value) + " with the error " + shown(each.error),
                                       "values with known errors", "leave out what has not converged");
    }
  }
  if (std::any_of(table.interpolation_error.begin(), table.interpolation_error.end(), bad)) {
    throw InvalidInput::conflict("interpolation_error", "negative or not finite, allowed 0 or more");
  }
}

Table::Table(const char* name, TableValues values)
    : values_((require_values(name, values), std::move(values))),
      cubic_(cubic_of(values_)),
      errors_(errors_of(values_)),
      slowest_(values_.speeds.front()),
      fastest_(values_.speeds.back()),
      first_(cubic_.places()[2].front() - rounding_of_ratios),
      last_(cubic_.places()[2].back() + rounding_of_ratios) {}

double Table::greatest_error() const { return *std::max_element(errors_.begin(), errors_.end()); }

Estimate Table::nearest(double speed, double z, double p) const {
  const auto& [speeds, slips, ratios] = cubic_.places();
  const double x = std::clamp(std::log(speed), speeds.front(), speeds.back());
  z = std::clamp(z, slips.front(), slips.back());
  p = std::clamp(p, ratios.front(), ratios.back());
  const bool slides = slips.size() > 1;
  if (slides && is_mixture()) return known(at<3>({x, z, p}));
  if (slides) return known(at<2>({x, z}));
  return is_mixture() ? known(at<2>({x, p})) : known(at<1>({x}));
}

void Table::require_numbers(double speed, double ratio) const {
  if (!std::isfinite(speed)) throw InvalidInput::out_of_range("speed", shown(speed), "a finite speed of approach");
  if (is_mixture() && !(ratio > 0.0 && std::isfinite(ratio))) {
    throw InvalidInput::out_of_range("ratio", shown(ratio), "a positive finite ratio of radii");
  }
}

void Table::require_inside(double speed, double ratio) const {
  const auto refuse = [](const char* name, double got, const std::vector<double>& range, const char* inverse) {
    throw InvalidInput::out_of_range(std::string(name), shown(got),
                                     shown_least(range.front()) + " to " + shown_most(range.back()) + inverse,
                                     "the range for which the table was made");
  };
  if (!holds(speed)) refuse("speed", speed, values_.speeds, "");
  if (is_mixture() && !holds(speed, place(ratio))) {
    refuse("ratio", ratio, values_.ratios, values_.alike ? " or inverse" : "");
  }
}

}  // namespace stoss
