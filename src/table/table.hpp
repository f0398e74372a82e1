#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "numeric/interpolation.hpp"
#include "stoss/table/table_values.hpp"
#include "table/axes.hpp"

namespace stoss {

/// @param name of the quantity, for refusals. @throws InvalidInput for values of no table
void require_values(const char* name, const TableValues& values);

/// A quantity between computed values, with its error: a CubicGrid in x = ln v with monotone slopes, in z and in
/// p = (r − 1)/(r + 1) with those of parabolas. p is tanh(½ ln r): it changes its sign with the inverse of r and needs
/// no logarithm.
///
/// The error of a cell is the sum of the largest of the values around, 1.25 times for z and for p each, as they weigh
/// most between them, and of the interpolation's.
class Table {
 public:
  /// @throws InvalidInput as require_values
  Table(const char* name, TableValues values);

  [[nodiscard]] const TableValues& values() const { return values_; }
  [[nodiscard]] const std::vector<double>& nodes() const { return cubic_.nodes(); }
  [[nodiscard]] const std::vector<double>& errors() const { return errors_; }
  [[nodiscard]] double greatest_error() const;

  [[nodiscard]] bool is_mixture() const { return values_.ratios.size() > 1; }

  /// p of a ratio, of its inverse where that is the same pair.
  [[nodiscard]] double place(double ratio) const {
    const double p = place_of_ratio(ratio);
    return values_.alike ? std::abs(p) : p;
  }

  /// Whether a speed without its sign, and a place of a ratio, lie within. NaN does not.
  [[nodiscard]] bool holds(double speed) const { return speed >= slowest_ && speed <= fastest_; }
  [[nodiscard]] bool holds(double speed, double p) const { return holds(speed) && p >= first_ && p <= last_; }

  /// Value and cell at places within, along the axes that count.
  template <std::size_t dimensions>
  [[nodiscard, gnu::always_inline]] inline numeric::CubicGrid::Found at(
      const std::array<double, dimensions>& places) const {
    return cubic_.at(places);
  }

  [[nodiscard]] Estimate known(const numeric::CubicGrid::Found& found) const {
    return {found.value, errors_[found.cell]};
  }

  /// The nearest value within. @param speed not negative. @param p place of a ratio
  [[nodiscard]] Estimate nearest(double speed, double z, double p) const;

  /// @throws InvalidInput for what is not finite, and a ratio of a mixture that is not positive
  void require_numbers(double speed, double ratio) const;

  /// @throws InvalidInput for what is beyond the range. @param speed without its sign
  void require_inside(double speed, double ratio) const;

 private:
  TableValues values_;
  numeric::CubicGrid cubic_;
  std::vector<double> errors_{};
  double slowest_, fastest_, first_, last_;  ///< of speeds and of places of ratios
};

}  // namespace stoss
