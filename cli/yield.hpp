#pragma once

#include <optional>
#include <string>

#include "record.hpp"
#include "units.hpp"

namespace stoss::cli {

/// Adds the speed at which yielding begins to a record, where there is one, and whether an impact is faster.
/// @param yield_speed m/s
/// @param speed       of the impact, c of the first body, which has a material
void add_yield(Record& record, const Units& units, const std::optional<double>& yield_speed, double speed);

/// The warning about impacts beyond the speed at which yielding begins, m/s.
[[nodiscard]] std::string yield_warning(double yield_speed);

}  // namespace stoss::cli
