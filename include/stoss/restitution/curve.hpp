#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// Coefficient of restitution as `restitution` has it, or the best value that it reached: `converged` is false then,
/// with a reason, and the values are NaN where no two impacts end.
/// @throws InvalidInput as the options of one value do; what poll throws comes through
[[nodiscard]] Restitution best_restitution(const RefinableContact& contact, double speed,
                                           const RestitutionOptions& options);

/// Receives the results of a curve in the order of its speeds, on the calling thread: each as soon
/// as it and all before it are there. What it throws ends the curve.
using CurveObserver = std::function<void(std::size_t index, const Restitution& result)>;

/// How the values of a curve are computed.
struct CurveOptions {
  /// Of each value. `poll` is called on the calling thread, at least every 50 ms, and so is `attempt_observer`: with
  /// the last impact that has begun for the result that comes next.
  RestitutionOptions each{};
  int threads = 0;  ///< 0: as many as the machine has; results do not depend on it
};

/// Checks the speeds and the options of a curve.
/// @throws InvalidInput for speeds, tolerances or threads out of range
void validate(const std::vector<double>& speeds, const CurveOptions& options);

/// Computes ε at each of the speeds and hands the results over one by one. A point that does not
/// converge does not end the curve: it has `converged` false, a reason, and the best value, or NaN
/// where no two impacts end.
/// @throws InvalidInput for arguments out of range, before anything is computed; what observer and poll throw, after
///         the impacts under way have stopped
void restitution_curve(const RefinableContact& contact, const std::vector<double>& speeds, const CurveOptions& options,
                       const CurveObserver& observer);

/// Computes ε at each of the speeds and returns all results. Each holds all modes of its finest
/// impact (0.05 MB); a long curve is better observed.
[[nodiscard]] std::vector<Restitution> restitution_curve(const RefinableContact& contact,
                                                         const std::vector<double>& speeds,
                                                         const CurveOptions& options = {});

/// Computes ε of a disk at each of the speeds. @param poisson 2-D Poisson's ratio, −0.95 … 0.995
[[nodiscard]] std::vector<Restitution> restitution_curve(double poisson, const std::vector<double>& speeds,
                                                         const CurveOptions& options = {});

}  // namespace stoss
