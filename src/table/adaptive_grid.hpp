#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "stoss/restitution/restitution.hpp"
#include "table/axes.hpp"

namespace stoss {

/// Computed values at all crossings of three axes, whose intervals are halved until what is computed in their middles
/// is predicted. An axis of one place does not count.
class AdaptiveGrid {
 public:
  using Place = std::array<double, 3>;
  using Values = std::vector<Estimate>;  ///< of each quantity

  explicit AdaptiveGrid(std::array<NestedAxis, 3> axes) : axes_(std::move(axes)) {}

  [[nodiscard]] const NestedAxis& axis(std::size_t number) const { return axes_[number]; }

  /// Number of crossings.
  [[nodiscard]] std::size_t size() const;

  /// Crossings without values: those of the last axis in turn, for all of the first, for all of the second.
  [[nodiscard]] std::vector<Place> open() const;

  void set(const Place& place, Values values) { values_[place] = std::move(values); }

  [[nodiscard]] const Values& at(const Place& place) const { return values_.at(place); }

  /// Halves the intervals of the first axis in which the middle of one was missed by more than enough, on any line;
  /// whether there is one. All crossings must have values. @param enough of each quantity
  bool halve(const std::vector<double>& enough);

  /// Of a quantity, at the places of the first axis in turn, for all of the second, for all of the third.
  [[nodiscard]] std::vector<Estimate> values(std::size_t quantity) const;

  /// Error of the interpolation of each cell, in the same order: the sum of those along the axes.
  [[nodiscard]] std::vector<double> interpolation_errors(std::size_t quantity) const;

 private:
  using Index = std::array<std::size_t, 3>;

  [[nodiscard]] Place place(const Index& index) const;
  [[nodiscard]] std::size_t intervals(std::size_t number) const;

  /// Values of a quantity along an axis through a crossing.
  [[nodiscard]] std::vector<double> line(std::size_t number, Index through, std::size_t quantity) const;

  std::array<NestedAxis, 3> axes_;
  std::map<Place, Values> values_{};
};

}  // namespace stoss
