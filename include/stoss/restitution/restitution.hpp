#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stoss/errors.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/vibration.hpp"
#include "stoss/poll.hpp"
#include "stoss/restitution/ladder.hpp"

namespace stoss {

/// A number with its estimated error: in the validation (docs/developer/validation.md) the true error of ε and of 1 −
/// ε² is within it in at least 95 % of the cases of each set, for fast disks (0.1 to 0.6 c) in 92 % at the tolerance
/// 10⁻³ and 91 % at 10⁻⁴, and rarely beyond three times it. An infinite error means that it is unknown: it would reach
/// the value itself or, for ε and 1 − ε², exceed 1.
struct Estimate {
  double value = 0.0;
  double error = 0.0;
};

/// One impact on the way to a converged value: its resolution, with which `impact` repeats it bit by bit, and results.
struct Run {
  double cutoff = 0.0;
  FixedResolution resolution;
  double lost_fraction = 0.0;
  double dissipated = 0.0;  ///< energy that the material took, share of the initial energy of translation
  double unresolved = 0.0;  ///< energy that the modes above the cutoff took, share of the initial energy of translation
  double remaining = 0.0;   ///< Impact::remaining
  double contact_time = 0.0;
  double impulse_time = 0.0;
  double max_force = 0.0;
  double max_compression = 0.0;
  double energy_error = 0.0;
  long steps = 0;
};

/// The coefficient of restitution at a hard wall or of two bodies, with its errors and the runs that led to it.
/// Units as in Impact.
struct Restitution {
  Estimate restitution;    ///< ε; its error is that of 1 − ε²
  Estimate lost_fraction;  ///< 1 − ε²
  Estimate contact_time;
  Estimate impulse_time;
  Estimate max_force;
  Estimate max_compression;
  double lost_to_first = 0.0;   ///< share of the initial energy that the first body vibrates with or takes
  double lost_to_second = 0.0;  ///< the same of the second, 0 at a wall. Of bodies unexcited before, the sum of
                                ///< both is lost_fraction
  double dissipated = 0.0;      ///< part of both that their material takes
  double yielded = 0.0;         ///< the same of plastic flow
  double tolerance = 0.0;       ///< asked for, relative to 1 − ε²
  double absolute = 0.0;        ///< error of 1 − ε² that is small enough in any case
  bool converged = false;       ///< whether one of them is met
  std::string reason;           ///< why not
  std::vector<Run> runs;        ///< from coarse to fine
  Impact finest;   ///< the last of them, whole; beyond_small_strain says where linear elasticity has ended.
                   ///< Where the near side of a body stands for it, corrected for its curvature
  long steps = 0;  ///< of all runs
};

/// An impact that is about to begin on the way to a converged value.
struct Attempt {
  double cutoff = 0.0;     ///< its cutoff, c/R
  Estimate lost_fraction;  ///< 1 − ε² after the impacts before it; 0 ± 0 while they are too few to tell
};

/// Tolerance of the coefficient of restitution.
struct RestitutionOptions {
  double tolerance = 1e-3;  ///< error of 1 − ε² over 1 − ε², 1e-15 … 0.5
  double absolute = 1e-6;   ///< or error of 1 − ε² that is small enough in any case, 0 … 0.5
  Poll poll{};
  std::function<void(const Attempt&)> attempt_observer{};  ///< called before each impact; what it throws ends them
  Vibration vibration{};  ///< of the bodies before the impact; 1 − ε² may then be negative
};

/// Checks that bodies can vibrate so before an impact at this speed.
/// @throws InvalidInput as `approach`, and for modes above all cutoffs
void validate(const RefinableContact& contact, double speed, const Vibration& vibration, const Poll& poll = {});

/// A coefficient of restitution that misses its tolerance. `best` is the best value that was
/// reached; best.reason, also in what(), gives the reason.
class RestitutionNotConverged : public NotConverged {
 public:
  explicit RestitutionNotConverged(Restitution result);
  Restitution best;
};

/// Coefficient of restitution of a body at a hard wall, or of two bodies, from impacts at rising cutoffs
/// (docs/developer/numerics.md, sections 5 and 7): cutoff, step and grid are refined together until the error of
/// 1 − ε² is at most tolerance × (1 − ε²), or at most `absolute`. The error is the greater of a share of the energy
/// that the modes above the cutoff took and a multiple of the maximum difference from a coarser run, scaled by the
/// observed order of convergence. Where the errors fall too slowly for any cutoff, it gives up before impacts that take
/// more than a second.
/// @param speed of approach, 1e-8 … 1, in c
/// @throws InvalidInput for arguments out of range, and a vibration of modes above all cutoffs;
///         RestitutionNotConverged if no cutoff of the ladder is enough; NotConverged if no two impacts end
[[nodiscard]] Restitution restitution(const RefinableContact& contact, double speed,
                                      const RestitutionOptions& options = {});

/// Coefficient of restitution at one speed, for a body that is needed only once.
[[nodiscard]] Restitution restitution(const BodyMaker& maker, double speed, const RestitutionOptions& options = {});

}  // namespace stoss
