#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "numeric/bins.hpp"

namespace stoss::numeric {

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
