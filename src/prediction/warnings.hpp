#pragma once

#include <string>
#include <vector>

#include "stoss/prediction/prediction.hpp"

namespace stoss::prediction {

/// What ends within an impact of what was computed, each with the speed at which it does.
[[nodiscard]] std::vector<std::string> warnings(const Encounter& encounter, const Thresholds& limits,
                                                const Restitution& computed, const Prediction& made);

/// What asperities save. @param rough,smooth shares that ring and radiate
[[nodiscard]] std::string saved_by_asperities(double rough, double smooth);

}  // namespace stoss::prediction
