#pragma once

#include <array>
#include <cstdint>

namespace stoss::numeric {

/// Two independent random numbers, uniform in (0, 1), for each seed and counter: Philox4x32-10 (Salmon et al. 2011), of
/// which a counter is no state, so that any of them can be asked for in any order and on any thread. They are odd
/// multiples of 2⁻⁵³, never 0 or 1.
[[nodiscard]] std::array<double, 2> uniform(std::uint64_t seed, const std::array<std::uint32_t, 4>& counter);

}  // namespace stoss::numeric
