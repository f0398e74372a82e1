#include "numeric/cubic_grid.hpp"

#include <algorithm>
#include <utility>

#include "numeric/monotone_cubic.hpp"
#include "numeric/parabolic_cubic.hpp"

namespace stoss::numeric {

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
