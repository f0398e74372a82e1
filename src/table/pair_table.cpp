// A CubicGrid in x = ln v and s = (r − 1)/(r + 1). s is tanh(½ ln r): it changes its sign with the inverse of r and
// needs no logarithm.
#include "stoss/table/pair_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "check.hpp"
#include "numeric/interpolation.hpp"
#include "stoss/errors.hpp"
#include "table/arguments.hpp"
#include "table/axes.hpp"

namespace stoss {
namespace {

numeric::CubicGrid made(const PairValues& values) {
  using numeric::Slopes;
  numeric::CubicGrid::Places places{{{}, {0.0}, {}}};
  for (const double each : values.speeds) places[0].push_back(std::log(each));
  for (const double each : values.ratios) places[2].push_back(place_of_ratio(each));
  std::vector<double> all;
  for (const Estimate& each : values.restitution) all.push_back(each.value);
  const Slopes between_ratios = values.alike ? Slopes::mirrored : Slopes::parabolic;
  return {std::move(places), {Slopes::monotone, Slopes::monotone, between_ratios}, all};
}

}  // namespace

struct PairTable::Data {
  PairValues values;
  numeric::CubicGrid cubic;
  Beyond beyond;
  double first, last;  // of s
  std::vector<Node> nodes{};
  std::vector<double> errors{};

  Data(PairValues given, Beyond outside)
      : values(std::move(given)),
        cubic(made(values)),
        beyond(outside),
        first(cubic.places()[2].front() - rounding_of_ratios),
        last(cubic.places()[2].back() + rounding_of_ratios) {
    for (std::size_t i = 0; i < values.restitution.size(); ++i) {
      const double* node = &cubic.nodes()[4 * i];
      nodes.push_back({node[0], node[1], node[2], node[3]});
    }
    set_errors();
  }

  void set_errors() {
    const std::size_t columns = values.ratios.size();
    for (std::size_t k = 0; k + 1 < values.speeds.size(); ++k) {
      for (std::size_t j = 0; j + 1 < columns; ++j) {
        const Estimate *here = &values.restitution[k * columns + j], *next = here + columns;
        const double greatest = std::max({here[0].error, here[1].error, next[0].error, next[1].error});
        errors.push_back(table::weight_between_places * greatest + values.interpolation_error[k * (columns - 1) + j]);
      }
    }
  }

  /// s of a ratio, of its inverse where that is the same pair.
  [[nodiscard]] double place(double ratio) const {
    const double difference = place_of_ratio(ratio);
    return values.alike ? std::abs(difference) : difference;
  }

  /// Whether both are in the range. A NaN is not.
  [[nodiscard]] bool holds(double speed, double difference) const {
    return speed >= values.speeds.front() && speed <= values.speeds.back() && difference >= first && difference <= last;
  }

  [[nodiscard]] double outside(double speed, double ratio) const {
    if (!std::isfinite(speed)) {
      throw InvalidInput::out_of_range("speed", shown(speed), "a finite speed of approach");
    }
    if (!(ratio > 0.0) || !std::isfinite(ratio)) {
      throw InvalidInput::out_of_range("ratio", shown(ratio), "a positive finite ratio of radii");
    }
    const double difference = place(ratio);
    if (beyond == Beyond::error) {
      const bool of_speed = !(speed >= values.speeds.front() && speed <= values.speeds.back());
      const std::vector<double>& range = of_speed ? values.speeds : values.ratios;
      throw InvalidInput::out_of_range(of_speed ? "speed" : "ratio", shown(of_speed ? speed : ratio),
                                       shown_least(range.front()) + " to " + shown_most(range.back()) +
                                           (values.alike && !of_speed ? " or inverse" : ""),
                                       "the range for which the table was made");
    }
    const auto& [x, none, s] = cubic.places();
    return cubic.at<2>({std::clamp(std::log(speed), x.front(), x.back()), std::clamp(difference, s.front(), s.back())})
        .value;
  }
};

PairTable::PairTable(PairValues values, Beyond beyond) {
  require_values(values);
  require_beyond(beyond);
  data_ = std::make_shared<const Data>(std::move(values), beyond);
}

Estimate PairTable::operator()(double speed, double ratio) const {
  const double size = std::abs(speed), difference = data_->place(ratio);
  if (!(ratio > 0.0) || !data_->holds(size, difference)) {
    return {data_->outside(size, ratio), std::numeric_limits<double>::infinity()};
  }
  const auto [value, cell] = data_->cubic.at<2>({std::log(size), difference});
  return {value, data_->errors[cell]};
}

double PairTable::value(double speed, double ratio) const {
  const double size = std::abs(speed), difference = data_->place(ratio);
  if (!(ratio > 0.0) || !data_->holds(size, difference)) return data_->outside(size, ratio);
  return data_->cubic.at<2>({std::log(size), difference}).value;
}

const PairValues& PairTable::values() const { return data_->values; }
Beyond PairTable::beyond() const { return data_->beyond; }
const std::vector<PairTable::Node>& PairTable::nodes() const { return data_->nodes; }
const std::vector<double>& PairTable::errors() const { return data_->errors; }
double PairTable::greatest_error() const { return *std::max_element(data_->errors.begin(), data_->errors.end()); }

}  // namespace stoss
