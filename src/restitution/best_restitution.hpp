#pragma once

#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// Coefficient of restitution as `restitution` has it, or the best value that it reached: `converged` is false then,
/// with a reason, and the values are NaN where no two impacts end.
/// @throws InvalidInput, and what poll throws
[[nodiscard]] Restitution best_restitution(const RefinableContact& contact, double speed,
                                           const RestitutionOptions& options);

}  // namespace stoss
