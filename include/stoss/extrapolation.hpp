#pragma once

#include <functional>
#include <vector>

#include "stoss/restitution.hpp"

namespace stoss {

struct ExtrapolationOptions {
  std::vector<double> cutoffs;     ///< each a number N of modes; otherwise those with about 300, 400, 600 and 940 modes
  std::vector<double> hardnesses;  ///< αR; otherwise a series of hard walls that depends on the speed
  std::function<void()> poll{};    ///< as in ImpactOptions
};

/// 1 − ε² of one exponential wall and one number of modes.
struct SoftImpact {
  double cutoff = 0.0;    ///< c/R
  long modes = 0;         ///< N
  double hardness = 0.0;  ///< α, 1/R
  double lost_fraction = 0.0;
  long steps = 0;
};

/// ε by the two limits of the paper, with the errors of its regressions.
struct ExtrapolatedRestitution {
  Estimate restitution;    ///< ε
  Estimate lost_fraction;  ///< 1 − ε² for α → ∞ and N → ∞
  std::vector<Estimate> hard_wall;  ///< 1 − ε² for α → ∞, one for each cutoff
  std::vector<SoftImpact> impacts;  ///< all of them, by cutoff, then by hardness
  long steps = 0;
};

/// The coefficient of restitution as the paper computes it (its figures 7 and 8): impacts on exponential walls, 1 − ε²
/// extrapolated linearly in 1/α to the hard wall, those limits linearly in 1/√N to infinitely many modes. The errors are
/// the standard errors of the intercepts, the first carried into the second. It exists to show that this road meets the
/// hard wall of `restitution`, and how long it is.
/// @param poisson 2-D Poisson number, −0.95 … 0.995
/// @param speed   of the centre of mass, 1e-3 … 0.5 c: slower, the walls would have to be too hard
/// @throws InvalidInput for arguments out of range, fewer than three cutoffs or fewer than three hardnesses;
///         NotConverged as impact
[[nodiscard]] ExtrapolatedRestitution extrapolated_restitution(double poisson, double speed,
                                                               const ExtrapolationOptions& options = {});

}  // namespace stoss
