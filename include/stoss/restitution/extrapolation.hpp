#pragma once

#include <vector>

#include "stoss/poll.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// Cutoffs and hardnesses from which the two limits of the paper are extrapolated.
struct ExtrapolationOptions {
  std::vector<double> cutoffs;  ///< ascending; otherwise those that keep 300, 400, 600 and 940 modes (paper, figure 8)
  std::vector<double> hardnesses;  ///< αR, ascending; otherwise αv/c = 25, 33, 50 and 100
  Poll poll{};
};

/// One impact on an exponential wall with a number of modes.
struct SoftImpact {
  double cutoff = 0.0;    ///< c/R
  long modes = 0;         ///< N
  double hardness = 0.0;  ///< α, 1/R
  double lost_fraction = 0.0;
  long steps = 0;
};

/// Coefficient of restitution by the two limits of the paper, with the errors of its regressions.
struct ExtrapolatedRestitution {
  Estimate restitution;             ///< ε
  Estimate lost_fraction;           ///< 1 − ε² for α → ∞ and N → ∞
  std::vector<Estimate> hard_wall;  ///< 1 − ε² for α → ∞, one for each cutoff
  std::vector<SoftImpact> impacts;  ///< all of them, by cutoff, then by hardness
  long steps = 0;
};

/// The coefficient of restitution as the paper computes it: impacts on exponential walls
/// (eq. (40)), 1 − ε² extrapolated linearly in 1/α to the hard wall (figure 7), those limits
/// linearly in 1/√N to infinitely many modes (figure 8). It is a check of `restitution`, whose hard
/// wall it reaches at far greater cost.
///
/// Both lines have equal weights. Their errors are the standard errors of the intercepts times Student's factor (95 %;
/// 12.7 for three points, 4.3 for more: what deviates from the lines is mostly curvature, which more points do not
/// average out); the errors of the first lines are carried into that of the second.
///
/// For −0.9 ≤ ν ≤ 0.995 and speeds from 0.005 to 0.5 the difference from `restitution` is typically
/// 0.5 % of 1 − ε², the error 3 %, and the difference exceeds it in one of a hundred cases. Limits
/// of the method:
/// * Only the double limit is that of the hard wall. With N modes, much harder walls make the edge bounce, and 1 − ε²
///   rises by up to a fifth above the first line.
/// * Below a speed of about 0.005 the contact is too narrow for 940 modes and 1/√N is not the law: the errors are half
///   the value and more, below 0.002 (for most ν) even up to 2.5 times too small.
/// * For ν below −0.7 at speeds above 0.2 the wall of `restitution`, which absorbs what the kept modes do not resolve,
///   takes less than this one, which absorbs nothing: 1 − ε² differs by 4 to 16 % at ν = −0.95, more than the error.
/// @param poisson 2-D Poisson's ratio, −0.95 … 0.995
/// @param speed   of the centre of mass, 1e-3 … 0.5 c: slower, the walls would have to be too hard
/// @throws InvalidInput for arguments out of range, fewer than three cutoffs or hardnesses, series that do not rise by
///         1 % each; NotConverged as impact
[[nodiscard]] ExtrapolatedRestitution extrapolated_restitution(double poisson, double speed,
                                                               const ExtrapolationOptions& options = {});

}  // namespace stoss
