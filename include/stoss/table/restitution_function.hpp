#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "stoss/table/table_values.hpp"

namespace stoss {

/// What a RestitutionFunction gives beyond its range.
enum class Beyond {
  error,  ///< nothing: InvalidInput
  clamp,  ///< the value at the nearer end, with an unknown (infinite) error
  law     ///< below, what the law of slow impacts says (slow_law); above, InvalidInput
};

/// ε of a slow impact with its error, as a law has it, at any speed from 0; an infinite error where it says nothing.
using SlowLaw = std::function<Estimate(double speed)>;

/// The coefficient of restitution as a function of the speed: a cubic in ln v between computed values that rises and
/// falls only as they do (F. N. Fritsch and J. Butland, SIAM J. Sci. Stat. Comput. 5, 300, 1984), so ε never leaves the
/// range of its neighbours.
///
/// Its error is the sum of the larger error of the two neighbours and of the error of the interpolation. A speed
/// counts without its sign; 0 lies below every range.
class RestitutionFunction {
 public:
  /// @param values of five speeds or more; without interpolation errors these are estimated from how well values are
  ///               met by the others
  /// @param law    for Beyond::law
  /// @throws InvalidInput for speeds that do not rise, values or errors that are not finite or of another number, more
  ///         than one slip or ratio, and Beyond::law without a law, or with one that says nothing at the slowest speed
  explicit RestitutionFunction(TableValues values, Beyond beyond = Beyond::error, SlowLaw law = {});

  /// ε with its whole error. @throws InvalidInput for a speed that is not finite, and beyond the range as it says
  [[nodiscard]] Estimate operator()(double speed) const;

  /// ε alone, which is faster. @throws InvalidInput as above
  [[nodiscard]] double value(double speed) const;

  [[nodiscard]] double slowest() const;
  [[nodiscard]] double fastest() const;
  [[nodiscard]] Beyond beyond() const;

  /// Maximum error within the range.
  [[nodiscard]] double greatest_error() const;

  /// What it was made of, with the errors of the interpolation.
  [[nodiscard]] const TableValues& values() const;

  /// At each speed ε, then dε/d ln v.
  [[nodiscard]] const std::vector<double>& nodes() const;

  /// Whole error of each interval.
  [[nodiscard]] const std::vector<double>& errors() const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace stoss
