#pragma once

#include <vector>

#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// Computed values at all crossings of one axis to three. A table does not depend on what has one place.
struct TableValues {
  std::vector<double> speeds{};               ///< v_n of approach, rising, in any unit: two or more
  std::vector<double> slips{0.0};             ///< z = (|s| − μ v_n)/(|s| + μ v_n), rising from −1 to 1
  std::vector<double> ratios{1.0};            ///< radius of the second body over that of the first, rising
  std::vector<Estimate> values{};             ///< at each speed in turn, for all slips, for all ratios
  std::vector<double> interpolation_error{};  ///< of each interval of speeds in turn, for those of slips, of ratios
  bool alike = false;  ///< bodies of one material: a ratio and its inverse are the same pair, ratios are 1 or more
};

}  // namespace stoss
