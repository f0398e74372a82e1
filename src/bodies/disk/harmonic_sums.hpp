#pragma once

#include <cstddef>

namespace stoss::bodies::disk {

/// Σ cos kθ/k and Σ sin kθ/k.
struct HarmonicSums {
  double cosine = 0.0;
  double sine = 0.0;
};

/// Over k = 1 … N, the last term with weight ½, at θ = mπ/N, 0 ≤ m ≤ 2N. Error O(N⁻³).
[[nodiscard]] HarmonicSums harmonic_sums(std::size_t m, std::size_t highest);

/// Over all k, 0 < θ < 2π: −ln(2 sin ½θ) and ½(π − θ).
[[nodiscard]] HarmonicSums infinite_harmonic_sums(double theta);

}  // namespace stoss::bodies::disk
