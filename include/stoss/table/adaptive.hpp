#pragma once

#include <functional>
#include <vector>

#include "stoss/poll.hpp"
#include "stoss/restitution/ladder.hpp"
#include "stoss/table/restitution_function.hpp"

namespace stoss {

/// How a RestitutionFunction is made.
struct FunctionOptions {
  double error = 1e-3;  ///< maximum error of ε at any speed, 1e-7 … 0.1
  Beyond beyond = Beyond::error;
  SlowLaw law{};           ///< for Beyond::law
  int most_speeds = 2000;  ///< at which ε is computed, 16 … 100 000
  int threads = 0;         ///< 0: as many as the machine has; the result does not depend on it
  Poll poll{};             ///< on the calling thread, at least every 50 ms
};

/// Function ε(v) that is accurate to an error of ε, interpolation included: speeds are added where the values computed
/// so far do not predict those between them.
///
/// It begins with six speeds per decade, evenly in ln v, and halves every interval until ε computed in its middle,
/// which becomes a knot, differs from the interpolation by no more than a quarter of the error, and nothing around it
/// tells of an error above half of it (docs/developer/numerics.md, section 11). Values are computed to a third of the
/// error, and 1.5 times their errors are those of the knots.
/// @param slowest,fastest 1e-8 … 1, in c, slowest < fastest
/// @throws InvalidInput for arguments out of range; NotConverged if some value does not reach its share of the error,
///         or more speeds are needed
[[nodiscard]] RestitutionFunction restitution_function(const RefinableContact& contact, double slowest, double fastest,
                                                       const FunctionOptions& options = {});

/// ε with its error at each of some speeds, in c.
using ComputedRestitution = std::function<std::vector<Estimate>(const std::vector<double>& speeds)>;

/// The same of any ε that can be computed, of errors that are a third of that of the options or less.
/// @throws InvalidInput and NotConverged as above, and what `computed` throws
[[nodiscard]] RestitutionFunction restitution_function(const ComputedRestitution& computed, double slowest,
                                                       double fastest, const FunctionOptions& options = {});

}  // namespace stoss
