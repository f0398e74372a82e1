#include "numeric/interpolation.hpp"

#include <algorithm>
#include <utility>

namespace stoss::numeric {

std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const auto secant = [&](std::size_t k) { return (y[k + 1] - y[k]) / (x[k + 1] - x[k]); };
  std::vector<double> slope{secant(0)};
  for (std::size_t k = 1; k + 1 < x.size(); ++k) {
    const double left = secant(k - 1), right = secant(k), before = x[k] - x[k - 1], after = x[k + 1] - x[k];
    const double first = 2.0 * after + before, second = after + 2.0 * before;
    slope.push_back(left * right > 0.0 ? (first + second) / (first / left + second / right) : 0.0);
  }
  slope.push_back(secant(x.size() - 2));
  return slope;
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
  if (how == Slopes::monotone || x.size() < 3) return monotone_slopes(x, y);
  return parabolic_slopes(x, y, how == Slopes::mirrored);
}

CubicGrid::CubicGrid(Places places, const std::array<Slopes, 3>& slopes, const std::vector<double>& values)
    : places_(std::move(places)) {
  for (std::size_t a = 0; a < places_.size(); ++a) {
    if (places_[a].size() > 1) axes_.push_back({a, Bins(places_[a])});
  }
  std::size_t step = std::size_t{1} << axes_.size(), cells = 1;
  for (auto axis = axes_.rbegin(); axis != axes_.rend(); ++axis) {
    axis->step = step;
    axis->cells = cells;
    step *= places_[axis->number].size();
    cells *= intervals(axis->number);
  }
  set_nodes(slopes, values);
  set_coefficients();
}

void CubicGrid::set_nodes(const std::array<Slopes, 3>& slopes, const std::vector<double>& values) {
  const std::size_t size = std::size_t{1} << axes_.size();
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

void CubicGrid::set_coefficients() {
  const std::size_t size = std::size_t{1} << 2 * axes_.size();
  coefficients_.resize(intervals(0) * intervals(1) * intervals(2) * size);
  for (std::size_t cell = 0; cell < coefficients_.size() / size; ++cell) {
    double* own = &coefficients_[cell * size];
    // Along each axis first the values at both ends, then the slopes there.
    for (std::size_t i = 0; i < size; ++i) {
      std::size_t node = 0;
      for (std::size_t d = 0; d < axes_.size(); ++d) {
        const std::size_t which = i >> 2 * d & 3;
        node += (axes_[d].interval_of(cell) + which % 2) * axes_[d].step + (which / 2 << d);
      }
      own[i] = nodes_[node];
    }
    for (std::size_t d = 0; d < axes_.size(); ++d) {
      const std::size_t next = std::size_t{1} << 2 * d, k = axes_[d].interval_of(cell);
      const double width = axes_[d].bins.x()[k + 1] - axes_[d].bins.x()[k];
      for (std::size_t i = 0; i < size; ++i) {
        if (i / next % 4 != 0) continue;
        const double change = own[i + next] - own[i];
        const double first = width * own[i + 2 * next] - change, last = width * own[i + 3 * next] - change;
        own[i + next] = change;
        own[i + 2 * next] = first;
        own[i + 3 * next] = -first - last;
      }
    }
  }
}

std::size_t CubicGrid::intervals(std::size_t axis) const { return std::max<std::size_t>(places_[axis].size(), 2) - 1; }

}  // namespace stoss::numeric
