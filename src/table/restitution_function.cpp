#include "stoss/table/restitution_function.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "check.hpp"
#include "numeric/interpolation.hpp"
#include "stoss/errors.hpp"
#include "table/table.hpp"

namespace stoss {
namespace {

constexpr std::size_t fewest = 5;  // so that one can be left out, with two on either side

/// How far each value is from the cubic through its two neighbours on either side; of those too near the ends 0.
std::vector<double> missed(const std::vector<double>& x, const std::vector<Estimate>& y) {
  std::vector<double> distance(x.size());
  for (std::size_t k = 2; k + 2 < x.size(); ++k) {
    constexpr auto how = numeric::Slopes::monotone;
    const numeric::CubicGrid without({{{x[k - 2], x[k - 1], x[k + 1], x[k + 2]}, {0.0}, {0.0}}}, {how, how, how},
                                     {y[k - 2].value, y[k - 1].value, y[k + 1].value, y[k + 2].value});
    distance[k] = std::abs(without.at<1>({x[k]}).value - y[k].value);
  }
  return distance;
}

/// What the interpolation may be off by in each interval: half of how far the cubic misses the values around it when
/// they are left out, which doubles the spacing. A single one may be met by chance: the worst of four counts.
std::vector<double> estimated(const TableValues& table) {
  constexpr double of_half_the_spacing = 0.5;
  std::vector<double> x;
  for (const double each : table.speeds) x.push_back(std::log(each));
  const std::vector<double> distance = missed(x, table.values);
  std::vector<double> error(x.size() - 1);
  for (std::size_t k = 0; k < error.size(); ++k) {
    // The nearest four values that can be left out.
    const std::size_t first = std::clamp<std::size_t>(k, 3, std::max<std::size_t>(x.size() - 3, 3)) - 1;
    for (std::size_t i = first; i < std::min(first + 4, x.size()); ++i) error[k] = std::max(error[k], distance[i]);
    error[k] *= of_half_the_spacing;
  }
  return error;
}

}  // namespace

struct RestitutionFunction::Data {
  Table table;
  Beyond beyond;
  SlowLaw law;

  [[nodiscard]] Estimate outside(double speed) const {
    table.require_numbers(speed, 1.0);
    if (beyond == Beyond::law && speed < table.values().speeds.front()) return law(speed);
    if (beyond != Beyond::clamp) table.require_inside(speed, 1.0);
    return {table.nearest(speed, 0.0, 0.0).value, std::numeric_limits<double>::infinity()};
  }
};

RestitutionFunction::RestitutionFunction(TableValues values, Beyond beyond, SlowLaw law) {
  if (values.speeds.size() < fewest) {
    throw InvalidInput::out_of_range("speeds", std::to_string(values.speeds.size()),
                                     std::to_string(fewest) + " or more");
  }
  if (values.slips.size() > 1 || values.ratios.size() > 1) {
    throw InvalidInput::conflict(values.slips.size() > 1 ? "slips" : "ratios", "several, on which no function depends",
                                 "make a PairTable or a RuleTable");
  }
  const bool estimates = values.interpolation_error.empty();
  if (estimates) values.interpolation_error.resize(values.speeds.size() - 1);
  require_values("restitution", values);
  if (estimates) values.interpolation_error = estimated(values);
  if (beyond == Beyond::law && !law) {
    throw InvalidInput::out_of_range("beyond", "law", "error or clamp",
                                     "there is no law of slow impacts of these bodies");
  }
  if (beyond == Beyond::law && !std::isfinite(law(values.speeds.front()).error)) {
    throw InvalidInput::out_of_range("beyond", "law",
                                     "error or clamp from speed " + shown(values.speeds.front()) + " on",
                                     "the law of slow impacts says nothing there: begin at a lower speed");
  }
  data_ = std::make_shared<const Data>(Data{Table("restitution", std::move(values)), beyond, std::move(law)});
}

Estimate RestitutionFunction::operator()(double speed) const {
  const Table& table = data_->table;
  const double size = std::abs(speed);
  return table.holds(size) ? table.known(table.at<1>({std::log(size)})) : data_->outside(size);
}

double RestitutionFunction::value(double speed) const {
  const Table& table = data_->table;
  const double size = std::abs(speed);
  return table.holds(size) ? table.at<1>({std::log(size)}).value : data_->outside(size).value;
}

double RestitutionFunction::slowest() const { return values().speeds.front(); }
double RestitutionFunction::fastest() const { return values().speeds.back(); }
Beyond RestitutionFunction::beyond() const { return data_->beyond; }
double RestitutionFunction::greatest_error() const { return data_->table.greatest_error(); }
const TableValues& RestitutionFunction::values() const { return data_->table.values(); }
const std::vector<double>& RestitutionFunction::nodes() const { return data_->table.nodes(); }
const std::vector<double>& RestitutionFunction::errors() const { return data_->table.errors(); }

}  // namespace stoss
