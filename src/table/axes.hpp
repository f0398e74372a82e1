#pragma once

#include "table/nested_axis.hpp"

namespace stoss {

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
