#include "table/axes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "check.hpp"
#include "numeric/interpolation.hpp"
#include "stoss/errors.hpp"

namespace stoss {

void NestedAxis::add(double place, int turn) {
  const auto at = std::upper_bound(x_.begin(), x_.end(), place) - x_.begin();
  x_.insert(x_.begin() + at, place);
  turn_.insert(turn_.begin() + at, turn);
  last_ = std::max(last_, turn);
}

std::vector<double> NestedAxis::missed(const std::vector<double>& y) const {
  std::vector<double> distance(x_.size(), std::numeric_limits<double>::infinity());
  for (int turn = 1; turn <= last_; ++turn) {
    std::vector<double> x, before;
    for (std::size_t k = 0; k < x_.size(); ++k) {
      if (turn_[k] >= turn) continue;
      x.push_back(x_[k]);
      before.push_back(y[k]);
    }
    const numeric::CubicGrid cubic({x, {0.0}, {0.0}}, {slopes_, slopes_, slopes_}, before);
    for (std::size_t k = 0; k < x_.size(); ++k) {
      if (turn_[k] == turn) distance[k] = std::abs(cubic.at<1>({x_[k]}).value - y[k]);
    }
  }
  std::vector<double> own;
  for (std::size_t k = 0; k + 1 < x_.size(); ++k) {
    own.push_back(turn_[k] > turn_[k + 1] ? distance[k] : distance[k + 1]);  // that of the later end
  }
  return own;
}

std::vector<double> NestedAxis::cost_of_monotony(const std::vector<double>& y) const {
  constexpr double greatest = 4.0 / 27.0;  // of t(1 − t)²
  const std::vector<double> own = numeric::slopes(slopes_, x_, y), free = numeric::parabolic_slopes(x_, y, false);
  const auto apart = [&](std::size_t k) { return std::abs(own[k] - free[k]); };
  std::vector<double> cost;
  for (std::size_t k = 0; k + 1 < x_.size(); ++k) {
    cost.push_back(greatest * (x_[k + 1] - x_[k]) * (apart(k) + apart(k + 1)));
  }
  return cost;
}

std::vector<double> NestedAxis::errors(const std::vector<double>& y, const Doubt& doubt) const {
  const std::vector<double> own = missed(y);
  std::vector<double> errors = doubt.uneven ? cost_of_monotony(y) : std::vector<double>(own.size());
  // Both halves of an interval have the same middle; at an end two of three are such halves.
  const std::size_t together = std::min(doubt.together, own.size()), side = together / 2;
  for (std::size_t k = 0; k < own.size(); ++k) {
    const std::size_t first = std::min(std::max(k, side) - side, own.size() - together);
    for (std::size_t i = first; i < first + together; ++i) {
      const double ratio = doubt.uneven ? std::max(1.0, (x_[k + 1] - x_[k]) / (x_[i + 1] - x_[i])) : 1.0;
      errors[k] = std::max(errors[k], ratio * ratio * doubt.safety * own[i]);
    }
  }
  return errors;
}

bool NestedAxis::halve(const std::vector<double>& missed) {
  std::vector<double> middles;
  for (std::size_t k = 0; k < missed.size(); ++k) {
    if (missed[k] > 1.0) middles.push_back(0.5 * (x_[k] + x_[k + 1]));
  }
  const int turn = last_ + 1;
  for (const double middle : middles) add(middle, turn);
  return !middles.empty();
}

namespace {

constexpr double knots_per_decade = 6.0;
constexpr std::size_t fewest_of_speeds = 6, fewest_of_ratios = 2;  // intervals

void require_rising(const char* name, const AxisRange& range) {
  if (!(range.low < range.high)) {
    throw InvalidInput::out_of_range(std::string(name), shown(range.low) + " to " + shown(range.high),
                                     "a first value below the last");
  }
}

/// ln of what lies at a share of a range.
double logarithm(const AxisRange& range, double share) {
  return std::log(range.low) + share * (std::log(range.high) - std::log(range.low));
}

double speed_place(const AxisRange& range, double share) { return logarithm(range, share); }
double ratio_place(const AxisRange& range, double share) { return std::tanh(0.5 * logarithm(range, share)); }

std::size_t intervals(const AxisRange& range, std::size_t fewest) {
  return std::max(fewest, static_cast<std::size_t>(std::ceil(knots_per_decade * std::log10(range.high / range.low))));
}

}  // namespace

double AxisRange::speed(double place) const {
  if (place <= speed_place(*this, 0.0)) return low;
  return place >= speed_place(*this, 1.0) ? high : std::exp(place);
}

double AxisRange::ratio(double place) const {
  if (place <= ratio_place(*this, 0.0)) return low;
  return place >= ratio_place(*this, 1.0) ? high : (1.0 + place) / (1.0 - place);
}

NestedAxis axis_of_speeds(const AxisRange& range) {
  NestedAxis axis(numeric::Slopes::monotone);
  const std::size_t count = intervals(range, fewest_of_speeds);
  for (std::size_t i = 0; i <= count; ++i) {
    axis.add(speed_place(range, static_cast<double>(i) / static_cast<double>(count)), 0);
  }
  return axis;
}

NestedAxis axis_of_ratios(const AxisRange& range, bool alike) {
  NestedAxis axis(alike ? numeric::Slopes::mirrored : numeric::Slopes::parabolic);
  const std::size_t count = intervals(range, fewest_of_ratios);
  for (std::size_t i = 0; i <= count; ++i) {
    axis.add(ratio_place(range, static_cast<double>(i) / static_cast<double>(count)), 0);
  }
  return axis;
}

NestedAxis one_place(double place) {
  NestedAxis axis(numeric::Slopes::parabolic);
  axis.add(place, 0);
  return axis;
}

void require_speeds(const AxisRange& speeds) {
  require_speed(speeds.low);
  require_speed(speeds.high);
  require_rising("speed", speeds);
}

AxisRange held_ratios(bool alike, const AxisRange& ratios) {
  const Range range{1e-3, 1e3, true, true, "0.001 to 1000"};
  require("ratio", ratios.low, range, "radius of the second over that of the first");
  require("ratio", ratios.high, range, "radius of the second over that of the first");
  require_rising("ratio", ratios);
  if (!alike || ratios.low >= 1.0) return ratios;
  if (ratios.high <= 1.0) return {1.0 / ratios.high, 1.0 / ratios.low};
  return {1.0, std::max(ratios.high, 1.0 / ratios.low)};
}

}  // namespace stoss
