#pragma once

#include <cstdint>
#include <vector>

#include "stoss/impact/vibration.hpp"
#include "stoss/poll.hpp"
#include "stoss/restitution/ladder.hpp"

namespace stoss {

/// Mean energy with which a mode vibrates before the impacts of an ensemble.
struct MeanEnergy {
  int body = 0;         ///< 0: of the first, 1: of the second
  int order = 0;        ///< n
  int index = 0;        ///< l
  double energy = 0.0;  ///< as a share of the translational energy ½μv², 0 … 1e6
};

/// How the bodies of an ensemble vibrate on average. Modes that are not named rest.
using Spectrum = std::vector<MeanEnergy>;

/// Spectrum of bodies that are warm up to a frequency: every mode with ω ≤ `highest` has the same mean energy,
/// temperature × ½μv² (equipartition). Its number of modes, and so the vibrational energy, grows with `highest`: a
/// classical body without such a limit has no finite energy.
///
/// Modes are those that a central impact without friction moves, symmetric about its line. Half-spaces, and the large
/// bodies of which only the near side is computed (RefinableContact), rest.
/// @param temperature k_B T over ½μv², 0 … 1e6
/// @param highest     c/R of the first body, from the lowest mode to what leaves three rising cutoffs above it: 128 at
///                    a wall, less for unequal or lossy bodies
/// @throws InvalidInput for arguments out of range, and what the makers and poll throw
[[nodiscard]] Spectrum thermal(const RefinableContact& contact, double temperature, double highest,
                               const Poll& poll = {});

/// Frequency up to which modes vibrate where none is given, c/R of the first body: 10, the lowest mode where that is
/// higher, or what `thermal` allows where that is less. @throws what the makers and poll throw
[[nodiscard]] double usual_highest(const RefinableContact& contact, const Poll& poll = {});

/// Frequency of each mode of a spectrum, c/R of the first body. @throws what the makers and poll throw
[[nodiscard]] std::vector<double> frequencies(const RefinableContact& contact, const Spectrum& spectrum,
                                              const Poll& poll = {});

/// One sample of an ensemble: how the bodies vibrate before it.
///
/// Q and P of each mode are independent normal numbers, as in thermal equilibrium, so its energy E is distributed like
/// exp(−E/⟨E⟩) and its phase uniformly. Each mode of each sample has random numbers of its own, whichever others are
/// drawn: a spectrum with more modes has the same energies and phases in those of the smaller one. Modes of mean energy
/// 0 are left out.
/// @param seed   of the ensemble; another one gives independent samples
/// @param sample number of the sample
/// @throws InvalidInput for mean energies outside 0 … 1e6
[[nodiscard]] Vibration draw(const Spectrum& spectrum, std::uint64_t seed, std::uint64_t sample);

}  // namespace stoss
