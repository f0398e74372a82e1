#pragma once

namespace stoss::numeric {

/// Cosine integral Ci(x) = −∫_x^∞ cos t/t dt for x > 0; absolute error below 1e-14.
[[nodiscard]] double cosine_integral(double x);

}  // namespace stoss::numeric
