#pragma once

#include <cstddef>
#include <vector>

#include "restitution/oblique_errors.hpp"
#include "stoss/restitution/ladder.hpp"

namespace stoss {

/// What several obliquities of one contact have in common. @throws InvalidInput for one that is out of range
[[nodiscard]] ObliquePlan plan_of(const Contact& contact, double speed, const std::vector<Obliquity>& obliquities,
                                  double tolerance, const Poll& poll);

/// The levels of the runs of a plan: all, or those at which bodies are known of which only a point is.
[[nodiscard]] Levels levels_of(const ObliquePlan& plan, const RefinableContact& contact, double speed, double stretch,
                               const Poll& poll);

/// Whether the run after one asks so much of the machine: steps, times the modes and the entries of the matrices
/// between points, of rings also for all steps before (WaveMemory).
[[nodiscard]] bool takes_seconds_after(const Contact& contact, const ObliqueImpact& last, bool rings,
                                       std::size_t outcomes);

}  // namespace stoss
