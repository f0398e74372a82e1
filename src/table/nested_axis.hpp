#pragma once

#include <cstddef>
#include <vector>

#include "numeric/cubic_grid.hpp"

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

}  // namespace stoss
