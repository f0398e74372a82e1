#pragma once

#include <vector>

#include "bodies/half_space/medium.hpp"
#include "bodies/surface/waves.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::half_space {

/// All wave numbers of which waves are kept, k ≤ cutoff/c_R. The quadratures reproduce the response of the surface for
/// times up to 0.9 duration and more, by which what comes later hardly matters: forces that far apart are the beginning
/// and the end of a contact.
[[nodiscard]] std::vector<SurfaceWaves> surface_waves(const Medium& medium, double cutoff, double duration,
                                                      const Poll& poll);

/// Cutoff at which that would be about so many waves.
[[nodiscard]] double cutoff_of_count(const Medium& medium, double count, double duration);

}  // namespace stoss::bodies::half_space
