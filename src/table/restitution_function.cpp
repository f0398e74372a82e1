// ε between computed values is a CubicGrid in ln v with monotone slopes.
#include "stoss/table/restitution_function.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "check.hpp"
#include "numeric/interpolation.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr std::size_t fewest = 5;  // so that one can be left out, with two on either side

void require_knots(const std::vector<Knot>& knots) {
  if (knots.size() < fewest) {
    throw InvalidInput::out_of_range("knots", std::to_string(knots.size()),
                                     std::to_string(fewest) + " computed values or more");
  }
  double before = 0.0;
  for (const Knot& knot : knots) {
    const auto& [value, error] = knot.restitution;
    if (!(knot.speed > before) || !std::isfinite(knot.speed)) {
      throw InvalidInput::out_of_range("speed", shown(knot.speed) + " after " + shown(before),
                                       "positive finite speeds that rise", "sort them");
    }
    if (!std::isfinite(value) || !std::isfinite(error) || error < 0.0) {
      throw InvalidInput::out_of_range(
          "restitution", shown(value) + " with the error " + shown(error) + " at speed " + shown(knot.speed),
          "values with known errors", "leave out what has not converged");
    }
    before = knot.speed;
  }
}

numeric::CubicGrid monotone_cubic(std::vector<double> x, const std::vector<double>& y) {
  constexpr auto how = numeric::Slopes::monotone;
  return {{std::move(x), {0.0}, {0.0}}, {how, how, how}, y};
}

std::vector<double> logarithms(const std::vector<Knot>& knots) {
  std::vector<double> all;
  all.reserve(knots.size());
  for (const Knot& knot : knots) all.push_back(std::log(knot.speed));
  return all;
}

std::vector<double> values(const std::vector<Knot>& knots) {
  std::vector<double> all;
  all.reserve(knots.size());
  for (const Knot& knot : knots) all.push_back(knot.restitution.value);
  return all;
}

/// How far each knot is from the cubic through its two neighbours on either side; of knots too near the ends 0.
std::vector<double> missed(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> distance(x.size());
  for (std::size_t k = 2; k + 2 < x.size(); ++k) {
    const auto without =
        monotone_cubic({x[k - 2], x[k - 1], x[k + 1], x[k + 2]}, {y[k - 2], y[k - 1], y[k + 1], y[k + 2]});
    distance[k] = std::abs(without.at<1>({x[k]}).value - y[k]);
  }
  return distance;
}

/// What the interpolation may be off by in each interval: half of how far the cubic misses the knots around it when
/// they are left out, which doubles the spacing. A single knot may be met by chance: the worst of four counts.
std::vector<double> estimated(const std::vector<double>& x, const std::vector<double>& y) {
  constexpr double of_half_the_spacing = 0.5;
  const std::vector<double> distance = missed(x, y);
  std::vector<double> error(x.size() - 1);
  for (std::size_t k = 0; k < error.size(); ++k) {
    // The nearest four knots that can be left out.
    const std::size_t first = std::clamp<std::size_t>(k, 3, std::max<std::size_t>(x.size() - 3, 3)) - 1;
    for (std::size_t i = first; i < std::min(first + 4, x.size()); ++i) error[k] = std::max(error[k], distance[i]);
    error[k] *= of_half_the_spacing;
  }
  return error;
}

}  // namespace

struct RestitutionFunction::Data {
  std::vector<Knot> knots;
  numeric::CubicGrid cubic;
  double slowest, fastest;
  Beyond beyond;
  SlowLaw law;
  std::vector<double> interpolation;  // error of each interval
  std::vector<double> error;          // with that of the knots
  std::vector<double> slopes;

  [[nodiscard]] Estimate outside(double speed) const {
    if (!std::isfinite(speed)) throw InvalidInput::out_of_range("speed", shown(speed), "a finite speed of approach");
    const bool below = speed < slowest;
    if (beyond == Beyond::law && below) return law(speed);
    if (beyond == Beyond::clamp) {
      return {(below ? knots.front() : knots.back()).restitution.value, std::numeric_limits<double>::infinity()};
    }
    throw InvalidInput::out_of_range("speed", shown(speed), shown(slowest) + " to " + shown(fastest),
                                     "the range for which the function was made");
  }
};

RestitutionFunction::RestitutionFunction(std::vector<Knot> knots, Beyond beyond, SlowLaw law,
                                         std::vector<double> interpolation_error) {
  require_knots(knots);
  if (beyond == Beyond::law && !law) {
    throw InvalidInput::out_of_range("beyond", "law", "error or clamp",
                                     "there is no law of slow impacts of these bodies");
  }
  if (beyond == Beyond::law && !std::isfinite(law(knots.front().speed).error)) {
    throw InvalidInput::out_of_range("beyond", "law", "error or clamp from speed " + shown(knots.front().speed) + " on",
                                     "the law of slow impacts says nothing there: begin at a lower speed");
  }
  numeric::CubicGrid cubic = monotone_cubic(logarithms(knots), values(knots));
  const std::size_t intervals = knots.size() - 1;
  std::vector<double> interpolation =
      interpolation_error.empty() ? estimated(cubic.places()[0], values(knots)) : std::move(interpolation_error);
  const auto bad = [](double each) { return !(each >= 0.0) || !std::isfinite(each); };
  if (interpolation.size() != intervals || std::any_of(interpolation.begin(), interpolation.end(), bad)) {
    throw InvalidInput::out_of_range("interpolation_error", std::to_string(interpolation.size()),
                                     std::to_string(intervals) + " finite ones, 0 or more", "one for each interval");
  }
  std::vector<double> error = interpolation;
  for (std::size_t k = 0; k < intervals; ++k) {
    error[k] += std::max(knots[k].restitution.error, knots[k + 1].restitution.error);
  }
  const double slowest = knots.front().speed, fastest = knots.back().speed;
  std::vector<double> slopes;
  for (std::size_t k = 0; k <= intervals; ++k) slopes.push_back(cubic.nodes()[2 * k + 1]);
  Data table{std::move(knots), std::move(cubic),         slowest,          fastest,          beyond,
             std::move(law),   std::move(interpolation), std::move(error), std::move(slopes)};
  data_ = std::make_shared<const Data>(std::move(table));
}

Estimate RestitutionFunction::operator()(double speed) const {
  const double size = std::abs(speed);
  if (!(size >= slowest() && size <= fastest())) return data_->outside(size);
  const auto [value, cell] = data_->cubic.at<1>({std::log(size)});
  return {value, data_->error[cell]};
}

double RestitutionFunction::value(double speed) const {
  const double size = std::abs(speed);
  if (!(size >= data_->slowest && size <= data_->fastest)) return data_->outside(size).value;
  return data_->cubic.at<1>({std::log(size)}).value;
}

double RestitutionFunction::slowest() const { return data_->slowest; }
double RestitutionFunction::fastest() const { return data_->fastest; }
Beyond RestitutionFunction::beyond() const { return data_->beyond; }
double RestitutionFunction::greatest_error() const {
  return *std::max_element(data_->error.begin(), data_->error.end());
}
const std::vector<Knot>& RestitutionFunction::knots() const { return data_->knots; }
const std::vector<double>& RestitutionFunction::slopes() const { return data_->slopes; }
const std::vector<double>& RestitutionFunction::errors() const { return data_->error; }
const std::vector<double>& RestitutionFunction::interpolation_errors() const { return data_->interpolation; }

}  // namespace stoss
