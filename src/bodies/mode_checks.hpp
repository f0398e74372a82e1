#pragma once

#include <vector>

#include "bodies/kept_sums.hpp"
#include "stoss/bodies/round.hpp"

/// Checks of the modes of disks and spheres.
namespace stoss::bodies {

/// The static sum rule of one order (docs/theory/modes.md): what its modes leave of its flexibility must be positive
/// semidefinite and no larger than the modes above the cutoff can carry.
/// @param rounding of the sum of both diagonal elements, relative
/// @param tail     what these modes can carry
/// @throws NotConverged if it is violated
void check_sum_rule(int order, const Flexibility& all, const Flexibility& kept, double rounding, double tail,
                    double cutoff);

/// Throws InvalidInput for a cutoff below the lowest mode. @param some modes, the lowest among them
[[noreturn]] void refuse_low_cutoff(const std::vector<Mode>& some, double cutoff, double highest);

}  // namespace stoss::bodies
