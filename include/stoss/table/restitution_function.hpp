#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// A computed value of a RestitutionFunction.
struct Knot {
  double speed = 0.0;    ///< of approach, in any unit, the same for all knots
  Estimate restitution;  ///< ε
};

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
  /// @param knots               of rising speed, five or more, with finite values and errors
  /// @param law                 for Beyond::law
  /// @param interpolation_error of each interval between knots; empty: estimated from how well knots are met by the
  ///                            others
  /// @throws InvalidInput for knots that do not rise or are not finite, errors that are negative or of another number,
  ///         and Beyond::law without a law, or with one that says nothing at the slowest knot
  explicit RestitutionFunction(std::vector<Knot> knots, Beyond beyond = Beyond::error, SlowLaw law = {},
                               std::vector<double> interpolation_error = {});

  /// ε with its whole error. @throws InvalidInput for a speed that is not finite, and beyond the range as it says
  [[nodiscard]] Estimate operator()(double speed) const;

  /// ε alone, which is faster. @throws InvalidInput as above
  [[nodiscard]] double value(double speed) const;

  [[nodiscard]] double slowest() const;
  [[nodiscard]] double fastest() const;
  [[nodiscard]] Beyond beyond() const;

  /// Maximum error within the range.
  [[nodiscard]] double greatest_error() const;

  [[nodiscard]] const std::vector<Knot>& knots() const;

  /// dε/d ln v at each knot.
  [[nodiscard]] const std::vector<double>& slopes() const;

  /// Error of each interval between knots, of their values and of the interpolation together.
  [[nodiscard]] const std::vector<double>& errors() const;

  /// Error of the interpolation alone in each interval: with the knots they make the same function again.
  [[nodiscard]] const std::vector<double>& interpolation_errors() const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace stoss
