#pragma once

#include <memory>
#include <vector>

#include "stoss/table/restitution_function.hpp"

namespace stoss {

/// The coefficient of restitution of two bodies as a function of their speed of approach and of the ratio of their
/// radii: in ln v the monotone cubic of a RestitutionFunction, on the same speeds for all ratios, and between ratios r
/// a cubic in s = (r − 1)/(r + 1), half the difference of the radii over their mean, with the slopes of parabolas
/// through three neighbours.
///
/// Its error is the sum of 1.25 times the maximum error of the four values around, as those weigh most between
/// ratios, and of the error of the interpolation. For bodies of one material it is symmetric: 1/r gives what r
/// gives, at the same speed. A speed counts without its sign; 0 lies below every range. An immutable value, for any
/// number of threads; a call takes some 20 ns.
class PairTable {
 public:
  /// @param beyond error or clamp, for speeds and for ratios
  /// @throws InvalidInput for speeds or ratios that do not rise or are not positive, fewer than three ratios, some
  /// below
  ///         1 of bodies of one material, values or errors that are not finite or too few, and Beyond::law: of unequal
  ///         bodies there is no law of slow impacts
  explicit PairTable(TableValues values, Beyond beyond = Beyond::error);

  /// ε with its whole error. @throws InvalidInput for a speed that is not finite, a ratio that is not positive and
  /// finite, and beyond the range as it says
  [[nodiscard]] Estimate operator()(double speed, double ratio) const;

  /// ε alone, which is faster. @throws InvalidInput as above
  [[nodiscard]] double value(double speed, double ratio) const;

  /// What it was made of.
  [[nodiscard]] const TableValues& values() const;

  [[nodiscard]] Beyond beyond() const;

  /// At each speed in turn, for all ratios: ε, its derivatives by ln v, by s, and by both.
  [[nodiscard]] const std::vector<double>& nodes() const;

  /// Whole error of each interval of speeds in turn, for all intervals of ratios.
  [[nodiscard]] const std::vector<double>& errors() const;

  /// Maximum of these errors.
  [[nodiscard]] double greatest_error() const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace stoss
