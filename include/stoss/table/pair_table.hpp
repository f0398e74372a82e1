#pragma once

#include <memory>
#include <vector>

#include "stoss/table/restitution_function.hpp"

namespace stoss {

/// Computed values of a PairTable.
struct PairValues {
  std::vector<double> speeds;               ///< of approach, rising, in any unit: two or more
  std::vector<double> ratios;               ///< radius of the second body over that of the first, rising: three or more
  std::vector<Estimate> restitution;        ///< ε at each speed in turn, for all ratios
  std::vector<double> interpolation_error;  ///< of ε, for each interval of speeds in turn, for all intervals of ratios
  bool alike = false;  ///< bodies of one material: a ratio and its inverse are the same pair, ratios are 1 or more
};

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
  /// A value of the table with its derivatives by x = ln v, by s, and by both.
  struct Node {
    double value = 0.0, by_speed = 0.0, by_ratio = 0.0, by_both = 0.0;
  };

  /// @param beyond error or clamp, for speeds and for ratios
  /// @throws InvalidInput for speeds or ratios that do not rise or are not positive, for ratios below 1 of bodies of
  ///         one material, values or errors that are not finite or too few, and Beyond::law: of unequal bodies there is
  ///         no law of slow impacts
  explicit PairTable(PairValues values, Beyond beyond = Beyond::error);

  /// ε with its whole error. @throws InvalidInput for a speed that is not finite, a ratio that is not positive and
  /// finite, and beyond the range as it says
  [[nodiscard]] Estimate operator()(double speed, double ratio) const;

  /// ε alone, which is faster. @throws InvalidInput as above
  [[nodiscard]] double value(double speed, double ratio) const;

  /// What it was made of.
  [[nodiscard]] const PairValues& values() const;

  [[nodiscard]] Beyond beyond() const;

  /// At each speed in turn, for all ratios.
  [[nodiscard]] const std::vector<Node>& nodes() const;

  /// Whole error of each interval of speeds in turn, for all intervals of ratios.
  [[nodiscard]] const std::vector<double>& errors() const;

  /// Maximum of these errors.
  [[nodiscard]] double greatest_error() const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace stoss
