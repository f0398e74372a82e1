#pragma once

#include <vector>

#include "stoss/bodies/disk/modes.hpp"

namespace stoss::bodies::disk {

/// All modes with 0 < ω ≤ cutoff, sorted by order and frequency; arguments already checked. Every root is
/// bracketed by exact root counts at both ends, so none can be missed or found twice.
[[nodiscard]] std::vector<Mode> find_modes(double poisson, double cutoff, const Poll& poll);

/// The same, checked against the static sum rules. @throws NotConverged if the list fails its check
[[nodiscard]] std::vector<Mode> checked_modes(double poisson, double cutoff, const Poll& poll);

}  // namespace stoss::bodies::disk
