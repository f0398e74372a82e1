#pragma once

#include <cstddef>
#include <vector>

#include "numeric/interpolation.hpp"

namespace stoss {

/// Places on a line whose intervals are halved in turns. What each middle was missed by, interpolated between the
/// places that were there before it, is the error of both halves.
class NestedAxis {
 public:
  explicit NestedAxis(numeric::Slopes slopes) : slopes_(slopes) {}

  /// Adds a place, in any order. @param turn in which it was added, 0 of the first places
  void add(double place, int turn);

  [[nodiscard]] std::size_t size() const { return x_.size(); }

  [[nodiscard]] numeric::Slopes slopes() const { return slopes_; }

  /// Rising.
  [[nodiscard]] const std::vector<double>& x() const { return x_; }

  /// How far the middle whose halving made each interval was missed; infinity where nothing has been halved yet.
  /// @param y values at all places
  [[nodiscard]] std::vector<double> missed(const std::vector<double>& y) const;

  /// Halves every interval that is missed by more than enough; whether there is one.
  bool halve(const std::vector<double>& missed, double enough);

  /// A middle may be met by chance: the worst of each interval and its neighbours.
  [[nodiscard]] static std::vector<double> worst_of_three(const std::vector<double>& missed);

 private:
  numeric::Slopes slopes_;
  std::vector<double> x_;
  std::vector<int> turn_;
  int last_ = 0;
};

/// Ends of an axis of a table, as they were given. Its places are ln v, or s = (r − 1)/(r + 1) of ratios r.
struct AxisRange {
  double low, high;

  /// What a place stands for. The ends are exact.
  [[nodiscard]] double speed(double place) const;
  [[nodiscard]] double ratio(double place) const;
};

/// s of a ratio, which is tanh(½ ln r): it changes its sign with the inverse of r.
[[nodiscard]] inline double place_of_ratio(double ratio) { return (ratio - 1.0) / (ratio + 1.0); }

/// Of s, so that 1/r is in a range where r is.
inline constexpr double rounding_of_ratios = 1e-15;

/// Six places per decade or more. @param range low < high
[[nodiscard]] NestedAxis axis_of_speeds(const AxisRange& range);
[[nodiscard]] NestedAxis axis_of_ratios(const AxisRange& range, bool alike);

/// An axis that does not count.
[[nodiscard]] NestedAxis one_place(double place = 0.0);

/// @throws InvalidInput for speeds that are out of range or do not rise
void require_speeds(const AxisRange& speeds);

/// Ratios that a table holds: of bodies that are alike those from 1 on.
/// @throws InvalidInput for ratios that are out of range or do not rise
[[nodiscard]] AxisRange held_ratios(bool alike, const AxisRange& ratios);

}  // namespace stoss
