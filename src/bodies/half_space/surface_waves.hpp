#pragma once

#include <vector>

#include "bodies/half_space/medium.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::half_space {

/// The waves of one wave number along the surface, as a quadrature: of all with weight dk, those with ω ≤ cutoff one by
/// one, the others by what they add to slow responses.
struct SurfaceWaves {
  double wave_number;             ///< k
  double compliance;              ///< of all together, static: the medium's, times the weight of k
  std::vector<double> omega;      ///< of the kept ones, kind by kind: the Rayleigh wave, then the continuum
  std::vector<double> strength;   ///< ω² times the share of each in the compliance
  double residual_compliance;     ///< Σ strength/ω² over those that are not kept
  double residual_second_moment;  ///< Σ strength/ω⁴ over those that are not kept
};

/// All wave numbers of which waves are kept, k ≤ cutoff/c_R. The quadratures reproduce the response of the surface for
/// times up to 0.9 duration and more, by which what comes later hardly matters: forces that far apart are the beginning
/// and the end of a contact.
[[nodiscard]] std::vector<SurfaceWaves> surface_waves(const Medium& medium, double cutoff, double duration,
                                                      const Poll& poll);

/// Cutoff at which that would be about so many waves.
[[nodiscard]] double cutoff_of_count(const Medium& medium, double count, double duration);

}  // namespace stoss::bodies::half_space
