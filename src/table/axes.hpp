#pragma once

#include <cstddef>
#include <vector>

#include "numeric/interpolation.hpp"

namespace stoss {

/// How much more an interpolation may be off by than its middles were missed by.
struct Doubt {
  double safety;         ///< of what a middle was missed by: next to a kink half the spacing is hardly better
  std::size_t together;  ///< the worst of so many intervals counts, as a middle may be met by chance
  bool uneven;           ///< narrower ones count as at the full width, and so does what monotony costs
};

/// Places on a line whose intervals are halved in turns. What each middle was missed by, interpolated between the
/// places that were there before it, is the error of both halves.
class NestedAxis {
 public:
  explicit NestedAxis(numeric::Slopes slopes) : slopes_(slopes) {}

  /// Adds a place, in any order. @param turn in which it was added, 0 of the first places
  void add(double place, int turn);

  [[nodiscard]] std::size_t size() const { return x_.size(); }

  /// Rising.
  [[nodiscard]] const std::vector<double>& x() const { return x_; }

  /// How far the middle whose halving made each interval was missed; infinity where nothing has been halved yet.
  /// @param y values at all places
  [[nodiscard]] std::vector<double> missed(const std::vector<double>& y) const;

  /// What the interpolation may be off by in each interval.
  [[nodiscard]] std::vector<double> errors(const std::vector<double>& y, const Doubt& doubt) const;

  /// Halves every interval of which this is above 1; whether there is one.
  bool halve(const std::vector<double>& missed);

 private:
  /// What it costs each interval that the cubic rises and falls only as its values do: a bound of how far it is from
  /// the cubic with the slopes of parabolas, which is of third order also where the values turn and at the ends.
  [[nodiscard]] std::vector<double> cost_of_monotony(const std::vector<double>& y) const;

  numeric::Slopes slopes_;
  std::vector<double> x_;
  std::vector<int> turn_;
  int last_ = 0;
};

/// Ends of an axis of a table, as they were given. Its places are ln v, or p = (r − 1)/(r + 1) of ratios r.
struct AxisRange {
  double low, high;

  /// What a place stands for. The ends are exact.
  [[nodiscard]] double speed(double place) const;
  [[nodiscard]] double ratio(double place) const;
};

/// p of a ratio, which is tanh(½ ln r): it changes its sign with the inverse of r.
[[nodiscard]] inline double place_of_ratio(double ratio) { return (ratio - 1.0) / (ratio + 1.0); }

/// Of p, so that 1/r is in a range where r is.
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
