#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "stoss/poll.hpp"
#include "stoss/restitution/ladder.hpp"
#include "stoss/restitution/restitution.hpp"
#include "stoss/vibration/ensemble.hpp"

namespace stoss {

/// Coefficient of restitution of one sample of an ensemble; `restitution` with the vibration that `draw` gives for its
/// number repeats it, in every detail.
struct Sample {
  std::int64_t number = 0;
  double vibration = 0.0;            ///< energy before the impact, of all modes, as a share of ½μv²
  Estimate restitution;              ///< ε, which may exceed 1; NaN where no two impacts end
  Estimate lost_fraction;            ///< 1 − ε², which may be negative
  Estimate contact_time;             ///< from first to last contact, R/c
  int contacts = 0;                  ///< separate periods of contact
  std::int64_t steps = 0;            ///< of all runs
  bool converged = false;            ///< whether the error of 1 − ε² is that asked for, or less
  double strain = 0.0;               ///< as in Impact
  bool beyond_small_strain = false;  ///< as in Impact
  std::string reason;                ///< why it has not converged
};

/// Receives the samples in the order of their numbers, on the calling thread: each as soon as it and all before it are
/// there. What it throws ends the ensemble.
using SampleObserver = std::function<void(const Sample&)>;

/// Which samples of an ensemble are computed, and how accurately.
struct DistributionOptions {
  std::int64_t first = 0;       ///< number of the first sample, 0 … 1e15: an ensemble can be continued
  std::int64_t samples = 1000;  ///< how many, 1 … 1 000 000
  std::uint64_t seed = 0;       ///< of the ensemble
  double error = 1e-3;  ///< of 1 − ε² of each sample, 1e-9 … 0.5: absolute, as 1 − ε² may be 0 when bodies vibrate
  int threads = 0;  ///< 0: as many as the machine has; results do not depend on it
  Poll poll{};      ///< on the calling thread, at least every 50 ms
};

/// Checks the arguments of a distribution.
/// @throws InvalidInput for a speed, a spectrum or options out of range; for modes that the bodies do not have or that
///         come twice
void validate(const RefinableContact& contact, double speed, const Spectrum& spectrum,
              const DistributionOptions& options);

/// Computes ε of each sample of an ensemble of vibrating bodies and hands the samples over one by one. One that does
/// not converge does not end the ensemble: it has `converged` false, a reason, and the best value, or NaN where no two
/// impacts end.
///
/// The phases and energies of the modes are independent of the instant at which the bodies meet, so all samples have
/// one weight: the ensemble is that of bodies thrown at each other at this speed, not of pairs that meet in a gas,
/// where fast pairs meet more often.
/// @param speed of approach, 1e-8 … 1, in c
/// @throws InvalidInput as `validate`, before anything is computed; what observer and poll throw, after the impacts
///         under way have stopped
void restitution_distribution(const RefinableContact& contact, double speed, const Spectrum& spectrum,
                              const DistributionOptions& options, const SampleObserver& observer);

/// Computes ε of each sample of an ensemble of vibrating bodies and returns all samples.
[[nodiscard]] std::vector<Sample> restitution_distribution(const RefinableContact& contact, double speed,
                                                           const Spectrum& spectrum,
                                                           const DistributionOptions& options = {});

/// Mean over the samples of an ensemble, with both of its errors.
struct Mean {
  double value = 0.0;
  double statistical_error = 0.0;  ///< standard error s/√n with s² = Σ(x − mean)²/(n − 1); infinite for one sample
  double numerical_error = 0.0;  ///< mean of the samples' errors, as these may all be of one sign
};

/// What the samples of an ensemble have in common. Samples without a value are counted, but enter nothing else; those
/// that have not converged enter with the errors that they have, as to leave them out would prefer some vibrations.
struct DistributionSummary {
  long samples = 0;                 ///< that have a value
  long missing = 0;                 ///< without one: no two impacts ended
  long not_converged = 0;           ///< that have one, but miss the error asked for
  Mean restitution;                 ///< of ε
  Mean lost_fraction;               ///< of 1 − ε²: what translation loses to vibration; negative where it gains
  double standard_deviation = 0.0;  ///< of ε; infinite for one sample
  double least = 0.0;               ///< ε
  double greatest = 0.0;            ///< ε
  double share_above_one = 0.0;     ///< of the samples, with ε > 1
};

/// Summary of samples of one ensemble.
/// @throws InvalidInput if none of them has a value
[[nodiscard]] DistributionSummary summary(std::span<const Sample> samples);

}  // namespace stoss
