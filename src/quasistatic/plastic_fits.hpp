#pragma once

#include "stoss/quasistatic/elastic_plastic.hpp"

/// Fits of own finite elements (studies/yield) at ν = 0.3, in the units of the onset, for d of 1 and more. From d =
/// 1600 on, where the runs end, they go on as powers.
namespace stoss::quasistatic::fits {

[[nodiscard]] double force(double depth);
[[nodiscard]] double stiffness(double depth);
[[nodiscard]] double radius(double depth);
[[nodiscard]] double work(double depth);
[[nodiscard]] Unloading unloading(double deepest);

}  // namespace stoss::quasistatic::fits
