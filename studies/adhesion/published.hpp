#pragma once

namespace adhesion_study {

/// JKR's pull-off over wR, 3π/2, that of Derjaguin, Muller and Toporov (and of rigid bodies), 2π, and JKR's work
/// between the jumps over (w⁵R⁴/E*²)^{1/3}.
inline constexpr double jkr_pull_off = 4.712388980384690, dmt_pull_off = 6.283185307179586;
[[nodiscard]] double jkr_work();

/// Pull-off over wR by D. Maugis (J. Colloid Interface Sci. 150, 243, 1992): a constant pull σ₀ = λ (2πwE*²/9R)^{1/3}
/// up to a gap of w/σ₀.
[[nodiscard]] double maugis_pull_off(double number);

}  // namespace adhesion_study
