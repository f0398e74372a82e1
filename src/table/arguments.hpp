#pragma once

#include <utility>

#include "stoss/table/restitution_function.hpp"

namespace stoss {

/// Throws InvalidInput for what a PairTable or a RuleTable does not do beyond its range.
void require_beyond(Beyond beyond);

/// Throws InvalidInput for options of a PairTable or a RuleTable out of range.
void require_options(double error, int most_values, int threads, Beyond beyond);

}  // namespace stoss

namespace stoss::table {

/// Σ |weight| of four neighbours in the middle of equal intervals of a cubic with the slopes of parabolas: what the
/// errors of values count between them.
inline constexpr double weight_between_places = 1.25;

/// Slowest and fastest speed of a table in another unit. They are rounded outwards to 15 digits where that is the
/// same number but for rounding: what was typed in that unit is then what is written.
/// @throws InvalidInput for a scale that is not positive and finite
[[nodiscard]] std::pair<double, double> speed_range(double slowest, double fastest, double scale);

}  // namespace stoss::table
