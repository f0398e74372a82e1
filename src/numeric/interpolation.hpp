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
  explicit Bins(std::vector<double> x) : x_(std::move(x)), begin_(x_.front()), end_(x_.back()) {
    constexpr double rounding = 1e-6;  // of a bin: it begins no later than a place that is found in it
    const std::size_t intervals = x_.size() - 1;
    per_unit_ = static_cast<double>(intervals) / (end_ - begin_);
    for (std::size_t k = 0; k < intervals; ++k) intervals_.push_back({x_[k], x_[k + 1], 1.0 / (x_[k + 1] - x_[k])});
    intervals_.back().end = std::numeric_limits<double>::infinity();
    std::size_t k = 0;
    for (std::size_t bin = 0; bin <= intervals + 1; ++bin) {
      const double begin = begin_ + (static_cast<double>(bin) - rounding) / per_unit_;
      while (intervals_[k].end <= begin) ++k;
      first_.push_back(k);
    }
  }

  /// k of a place between the first and the last x, but for rounding.
  [[nodiscard]] std::size_t interval(double at) const {
    std::size_t k = first_[static_cast<std::size_t>(static_cast<int>((at - begin_) * per_unit_))];
    while (at >= intervals_[k].end) ++k;
    return k;
  }

  /// Share of interval k at which a place lies.
  [[nodiscard]] double share(std::size_t k, double at) const {
    return at < end_ ? (at - intervals_[k].begin) * intervals_[k].per_width : 1.0;
  }

  [[nodiscard]] const std::vector<double>& x() const { return x_; }

  [[nodiscard]] std::size_t intervals() const { return intervals_.size(); }

  [[nodiscard]] double per_unit() const { return per_unit_; }

  /// Interval in which each bin begins.
  [[nodiscard]] const std::vector<std::size_t>& first() const { return first_; }

 private:
  struct Interval {
    double begin, end, per_width;  ///< the last has no end
  };

  std::vector<double> x_;
  double begin_, end_, per_unit_ = 0.0;
  std::vector<Interval> intervals_{};
  std::vector<std::size_t> first_{};
};

/// Slopes d_k of a cubic through points (x_k, y_k) that rises and falls only as they do: the harmonic mean of the
/// slopes on either side, weighted with the intervals, 0 at extremes (F. N. Fritsch and J. Butland, SIAM J. Sci. Stat.
/// Comput. 5, 300, 1984); at the ends that of the last interval. @param x rising, two or more. @param y as many
[[nodiscard]] std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y);

/// Slope at each place of the parabola through it and its two neighbours, at an end through the last three. Linear in
/// y, so it may be taken of values and of their derivatives in another direction alike.
/// @param x    rising, three or more
/// @param even whether y is mirrored at x = 0, which may be the first place: the slope there is 0
[[nodiscard]] std::vector<double> parabolic_slopes(const std::vector<double>& x, const std::vector<double>& y,
                                                   bool even);

/// What interpolates along an axis: a cubic with monotone slopes, or with those of parabolas, through values that may
/// be mirrored at 0.
enum class Slopes { monotone, parabolic, mirrored };

/// Slope at each place of what interpolates. @param x rising, two or more. @param y as many
[[nodiscard]] std::vector<double> slopes(Slopes how, const std::vector<double>& x, const std::vector<double>& y);

/// A function of up to three variables between values on a grid, along each axis a cubic in the share t of an interval
/// of width h, from its values y and slopes d at both ends: with Δ = y₁ − y₀
///
///   y₀ + t {Δ + (1 − t) [h d₀ − Δ + (2Δ − h d₀ − h d₁) t]}.
///
/// An axis of one place does not count. A node has the value, then for each axis that counts the derivatives by it of
/// all that it had before.
class CubicGrid {
 public:
  using Place = std::array<double, 3>;
  using Places = std::array<std::vector<double>, 3>;

  struct Found {
    double value;
    std::size_t cell;  ///< in which the place lies
  };

  /// @param places rising along each axis
  /// @param values at the places of the first axis in turn, for all of the second, for all of the third
  CubicGrid(Places places, const std::array<Slopes, 3>& slopes, const std::vector<double>& values);

  /// The function at a place within the grid, but for rounding. @param at along the axes that count
  template <std::size_t dimensions>
  [[nodiscard, gnu::always_inline]] inline Found at(const std::array<double, dimensions>& at) const {
    return at_each(at, std::make_index_sequence<dimensions>());
  }

  [[nodiscard]] const Places& places() const { return places_; }

  /// 2^(axes that count) numbers at each place, in the order of the values.
  [[nodiscard]] const std::vector<double>& nodes() const { return nodes_; }

  /// Number of intervals along an axis, 1 of one that does not count.
  [[nodiscard]] std::size_t intervals(std::size_t axis) const;

 private:
  struct Axis {
    std::size_t number;  ///< of the three
    Bins bins;
    std::size_t step = 0;   ///< from a node to the next along it, in nodes_
    std::size_t cells = 0;  ///< from a cell to the next

    [[nodiscard]] std::size_t interval_of(std::size_t cell) const { return cell / cells % bins.intervals(); }
  };

  void set_nodes(const std::array<Slopes, 3>& slopes, const std::vector<double>& values);
  void set_coefficients();

  template <std::size_t dimensions, std::size_t... d>
  [[nodiscard, gnu::always_inline]] inline Found at_each(const std::array<double, dimensions>& at,
                                                         std::index_sequence<d...>) const {
    const std::array<std::size_t, dimensions> k{axes_[d].bins.interval(at[d])...};
    const std::array<double, dimensions> share{axes_[d].bins.share(k[d], at[d])...};
    const std::size_t cell = (std::size_t{0} + ... + (k[d] * axes_[d].cells));
    return {sum<dimensions>(&coefficients_[cell << 2 * dimensions], share.data()), cell};
  }

  /// The cubic of coefficients along all axes, the last one first: for all of the others at once.
  template <std::size_t dimensions>
  [[gnu::always_inline]] static inline double sum(const double* own, const double* share) {
    if constexpr (dimensions == 0) {
      return *own;
    } else {
      constexpr std::size_t count = std::size_t{1} << 2 * (dimensions - 1);
      const double t = share[dimensions - 1], u = 1.0 - t;
      std::array<double, count> rest;
      for (std::size_t i = 0; i < count; ++i) {
        rest[i] = own[i] + t * (own[count + i] + u * (own[2 * count + i] + own[3 * count + i] * t));
      }
      return sum<dimensions - 1>(rest.data(), share);
    }
  }

  Places places_;
  std::vector<Axis> axes_{};
  std::vector<double> nodes_{};
  std::vector<double> coefficients_{};  ///< of each cell: 4 of the first axis, for 4 of the second, for 4 of the third
};

}  // namespace stoss::numeric
