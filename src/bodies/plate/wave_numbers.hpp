#pragma once

#include <vector>

#include "bodies/plate/plate_waves.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::plate {

inline constexpr double share_of_duration = 0.9;  ///< for which the quadratures hold

/// A wave number of a quadrature, and its weight.
struct WaveNumber {
  double k, weight;
};

/// Those of which waves with ω ≤ cutoff are kept, for times up to 0.9 duration. The last is below highest_kept.
/// @throws InvalidInput where these are more than are computed
[[nodiscard]] std::vector<WaveNumber> wave_numbers(const Lamina& plate, double cutoff, double duration,
                                                   const Poll& poll = {});

/// Wave number above which no modes are below the cutoff.
[[nodiscard]] double highest_kept(const Lamina& plate, double cutoff, const Poll& poll = {});

/// The layers that waves with ω ≤ cutoff reach from the upper face: deeper ones, in which slower waves may run, move
/// this face by less than rounding.
[[nodiscard]] Sheets reached(const Sheets& part, double k, double cutoff);

}  // namespace stoss::bodies::plate
