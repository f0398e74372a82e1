#pragma once

#include <cstddef>

#include "stoss/bodies/disk/modes.hpp"

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

/// Σ_n R^CC cos nθ, Σ_n R^CS sin nθ and Σ_n R^SS cos nθ of the static flexibilities.
struct StaticSums {
  double radial = 0.0;
  double mixed = 0.0;
  double tangential = 0.0;
};

/// The static sums from those of the harmonics: with partial fractions in n they consist of Σ cos kθ/k and Σ sin kθ/k.
class StaticOrders {
 public:
  explicit StaticOrders(double poisson);

  /// @param cosine_sum, sine_sum Σ cos kθ/k and Σ sin kθ/k up to the order N, the last with weight ½
  /// @param last ½ cos Nθ, the share of the last order; 0 for sums over all orders
  [[nodiscard]] StaticSums at(double theta, double cosine_sum, double sine_sum, double last, double highest) const;

 private:
  Flexibility zero_, one_;
  double low_, high_;  // n ≥ 2: F^CC = F^SS = low/(n−1) + high/(n+1), F^CS = −low/(n−1) + high/(n+1)
};

}  // namespace stoss::bodies::disk
