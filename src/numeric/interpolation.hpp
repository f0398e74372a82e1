#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace stoss::numeric {

/// Finds the interval x_k … x_{k+1} of a place by bins of equal width, as many as there are intervals: it is that in
/// which the bin begins, or one of the next.
class Bins {
 public:
  /// @param x rising, two or more
  explicit Bins(std::vector<double> x) : x_(std::move(x)), begin_(x_.front()) {
    constexpr double rounding = 1e-6;  // of a bin: it begins no later than a place that is found in it
    const std::size_t intervals = x_.size() - 1;
    per_unit_ = static_cast<double>(intervals) / (x_.back() - begin_);
    for (std::size_t k = 0; k < intervals; ++k) ends_.push_back(x_[k + 1]);
    ends_.back() = std::numeric_limits<double>::infinity();
    std::size_t k = 0;
    for (std::size_t bin = 0; bin <= intervals + 1; ++bin) {
      const double begin = begin_ + (static_cast<double>(bin) - rounding) / per_unit_;
      while (ends_[k] <= begin) ++k;
      first_.push_back(k);
    }
  }

  /// k of a place between the first and the last x, but for rounding.
  [[nodiscard]] std::size_t interval(double at) const {
    std::size_t k = first_[static_cast<std::size_t>(static_cast<int>((at - begin_) * per_unit_))];
    while (at >= ends_[k]) ++k;
    return k;
  }

  [[nodiscard]] const std::vector<double>& x() const { return x_; }

  [[nodiscard]] double per_unit() const { return per_unit_; }

  /// Interval in which each bin begins.
  [[nodiscard]] const std::vector<std::size_t>& first() const { return first_; }

 private:
  std::vector<double> x_;
  double begin_, per_unit_ = 0.0;
  std::vector<double> ends_{};  ///< of the intervals; the last is infinite
  std::vector<std::size_t> first_{};
};

/// A cubic through points (x_k, y_k) that rises and falls only as they do: with t = (x − x_k)/h, h = x_{k+1} − x_k,
///
///   y = y_k (1 + 2t)(1 − t)² + y_{k+1} t²(3 − 2t) + h [d_k t(1 − t)² − d_{k+1} t²(1 − t)],
///
/// d the harmonic mean of the slopes on either side, weighted with the intervals, 0 at extremes (F. N. Fritsch and
/// J. Butland, SIAM J. Sci. Stat. Comput. 5, 300, 1984); at the ends that of the last interval.
struct MonotoneCubic {
  std::vector<double> x, y, slope;

  /// @param x rising, two or more. @param y as many
  MonotoneCubic(std::vector<double> x, std::vector<double> y);

  /// At a place of interval k, x_k … x_{k+1}.
  [[nodiscard]] double operator()(std::size_t k, double at) const {
    const double h = x[k + 1] - x[k], t = (at - x[k]) / h, u = 1.0 - t;
    return y[k] * (1.0 + 2.0 * t) * u * u + y[k + 1] * t * t * (1.0 + 2.0 * u) +
           h * t * u * (slope[k] * u - slope[k + 1] * t);
  }
};

/// Weights of y_k, y_{k+1} and of the slopes there in the cubic of an interval of width h at the share t of it.
[[nodiscard]] inline std::array<double, 4> cubic_weights(double h, double t) {
  const double u = 1.0 - t;
  return {(1.0 + 2.0 * t) * u * u, t * t * (1.0 + 2.0 * u), h * t * u * u, -h * t * t * u};
}

/// Slope at each place of the parabola through it and its two neighbours, at an end through the last three. Linear in
/// y, so it may be taken of values and of their derivatives in another direction alike.
/// @param x    rising, three or more
/// @param even whether y is mirrored at x = 0, which may be the first place: the slope there is 0
[[nodiscard]] std::vector<double> parabolic_slopes(const std::vector<double>& x, const std::vector<double>& y,
                                                   bool even);

/// What interpolates along an axis: a MonotoneCubic, or a cubic with the slopes of parabolas, through values that may
/// be mirrored at 0.
enum class Slopes { monotone, parabolic, mirrored };

/// Slope at each place of what interpolates. @param x rising, two or more. @param y as many
[[nodiscard]] std::vector<double> slopes(Slopes how, const std::vector<double>& x, const std::vector<double>& y);

/// A function of up to three variables between values on a grid: a cubic along each axis. An axis of one place does
/// not count. A node has the value, then for each axis that counts the derivatives by it of all that it had before.
class CubicGrid {
 public:
  using Place = std::array<double, 3>;
  using Places = std::array<std::vector<double>, 3>;

  /// Where a place lies in the grid.
  struct Spot {
    std::size_t node = 0, cell = 0;                 ///< the first node of the cell, and its number
    std::array<std::array<double, 4>, 3> weight{};  ///< of each axis that counts, as cubic_weights has them
  };

  /// @param places rising along each axis
  /// @param values at the places of the first axis in turn, for all of the second, for all of the third
  CubicGrid(Places places, const std::array<Slopes, 3>& slopes, const std::vector<double>& values);

  /// Of a place, or of the nearest one within the grid. It must not be NaN.
  [[nodiscard]] Spot spot(const Place& at) const;

  /// The function at a spot.
  [[nodiscard]] double operator()(const Spot& spot) const;

  [[nodiscard]] const Places& places() const { return places_; }

  /// Axes that count.
  [[nodiscard]] std::size_t dimensions() const { return axes_.size(); }

  /// 2^dimensions numbers at each place, in the order of the values.
  [[nodiscard]] const std::vector<double>& nodes() const { return nodes_; }

  /// Number of intervals along an axis, 1 of one that does not count.
  [[nodiscard]] std::size_t intervals(std::size_t axis) const;

  /// Finds intervals along an axis that counts.
  [[nodiscard]] const Bins& bins(std::size_t counted) const { return axes_[counted].bins; }

 private:
  struct Axis {
    std::size_t number;  ///< of the three
    Bins bins;
    std::size_t step = 0;   ///< from a node to the next along it, in nodes_
    std::size_t cells = 0;  ///< from a cell to the next
  };

  template <std::size_t dimension>
  [[nodiscard]] double sum(const double* node, const Spot& spot) const;

  Places places_;
  std::vector<Axis> axes_{};
  std::vector<double> nodes_{};
};

}  // namespace stoss::numeric
