#include "numeric/interpolation.hpp"

#include <algorithm>
#include <utility>

namespace stoss::numeric {

MonotoneCubic::MonotoneCubic(std::vector<double> at, std::vector<double> of) : x(std::move(at)), y(std::move(of)) {
  const auto secant = [this](std::size_t k) { return (y[k + 1] - y[k]) / (x[k + 1] - x[k]); };
  slope.push_back(secant(0));
  for (std::size_t k = 1; k + 1 < x.size(); ++k) {
    const double left = secant(k - 1), right = secant(k), before = x[k] - x[k - 1], after = x[k + 1] - x[k];
    const double first = 2.0 * after + before, second = after + 2.0 * before;
    slope.push_back(left * right > 0.0 ? (first + second) / (first / left + second / right) : 0.0);
  }
  slope.push_back(secant(x.size() - 2));
}

std::vector<double> parabolic_slopes(const std::vector<double>& x, const std::vector<double>& y, bool even) {
  const std::size_t last = x.size() - 1;
  const auto width = [&](std::size_t k) { return x[k + 1] - x[k]; };
  const auto secant = [&](std::size_t k) { return (y[k + 1] - y[k]) / width(k); };
  // How the secant of an interval changes to the next, per unit of the length of both.
  const auto bend = [&](std::size_t k) { return (secant(k + 1) - secant(k)) / (width(k) + width(k + 1)); };
  std::vector<double> slope;
  slope.push_back(even && x[0] == 0.0 ? 0.0 : secant(0) - width(0) * bend(0));
  for (std::size_t k = 1; k < last; ++k) slope.push_back(secant(k - 1) + width(k - 1) * bend(k - 1));
  slope.push_back(secant(last - 1) + width(last - 1) * bend(last - 2));
  return slope;
}

std::vector<double> slopes(Slopes how, const std::vector<double>& x, const std::vector<double>& y) {
  if (how == Slopes::monotone || x.size() < 3) return MonotoneCubic(x, y).slope;
  return parabolic_slopes(x, y, how == Slopes::mirrored);
}

CubicGrid::CubicGrid(Places places, const std::array<Slopes, 3>& slopes, const std::vector<double>& values)
    : places_(std::move(places)) {
  for (std::size_t a = 0; a < places_.size(); ++a) {
    if (places_[a].size() > 1) axes_.push_back({a, Bins(places_[a])});
  }
  const std::size_t size = std::size_t{1} << axes_.size();
  std::size_t step = size, cells = 1;
  for (auto axis = axes_.rbegin(); axis != axes_.rend(); ++axis) {
    axis->step = step;
    axis->cells = cells;
    step *= places_[axis->number].size();
    cells *= intervals(axis->number);
  }
  nodes_.resize(values.size() * size);
  for (std::size_t i = 0; i < values.size(); ++i) nodes_[i * size] = values[i];
  for (std::size_t d = 0; d < axes_.size(); ++d) {
    const Axis& axis = axes_[d];
    const std::vector<double>& x = places_[axis.number];
    for (std::size_t part = 0; part < std::size_t{1} << d; ++part) {
      for (std::size_t begin = 0; begin < nodes_.size(); begin += size) {
        if (begin / axis.step % x.size() != 0) continue;  // no line begins here
        std::vector<double> y;
        for (std::size_t k = 0; k < x.size(); ++k) y.push_back(nodes_[begin + k * axis.step + part]);
        const std::vector<double> slope = numeric::slopes(slopes[axis.number], x, y);
        for (std::size_t k = 0; k < x.size(); ++k) {
          nodes_[begin + k * axis.step + part + (std::size_t{1} << d)] = slope[k];
        }
      }
    }
  }
}

std::size_t CubicGrid::intervals(std::size_t axis) const { return std::max<std::size_t>(places_[axis].size(), 2) - 1; }

CubicGrid::Spot CubicGrid::spot(const Place& at) const {
  Spot spot;
  for (std::size_t d = 0; d < axes_.size(); ++d) {
    const Axis& axis = axes_[d];
    const std::vector<double>& x = axis.bins.x();
    const double place = std::clamp(at[axis.number], x.front(), x.back());
    const std::size_t k = axis.bins.interval(place);
    const double width = x[k + 1] - x[k];
    spot.node += k * axis.step;
    spot.cell += k * axis.cells;
    spot.weight[d] = cubic_weights(width, (place - x[k]) / width);
  }
  return spot;
}

template <std::size_t dimension>
double CubicGrid::sum(const double* node, const Spot& spot) const {
  if constexpr (dimension == 0) {
    return *node;
  } else {
    constexpr std::size_t slope = std::size_t{1} << (dimension - 1);
    const std::array<double, 4>& weight = spot.weight[dimension - 1];
    const double* next = node + axes_[dimension - 1].step;
    return weight[0] * sum<dimension - 1>(node, spot) + weight[1] * sum<dimension - 1>(next, spot) +
           weight[2] * sum<dimension - 1>(node + slope, spot) + weight[3] * sum<dimension - 1>(next + slope, spot);
  }
}

double CubicGrid::operator()(const Spot& spot) const {
  const double* node = nodes_.data() + spot.node;
  switch (axes_.size()) {
    case 0:
      return sum<0>(node, spot);
    case 1:
      return sum<1>(node, spot);
    case 2:
      return sum<2>(node, spot);
    default:
      return sum<3>(node, spot);
  }
}

}  // namespace stoss::numeric
