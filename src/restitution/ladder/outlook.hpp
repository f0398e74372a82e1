#pragma once

#include <string>

#include "stoss/contact/contact.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// What is to be expected of finer runs.
struct NextRun {
  int rungs;               ///< to the next run
  double cutoff = 0.0;     ///< at which the tolerance would be met, if the errors go on falling as they did
  double reachable = 0.0;  ///< scaled error that the highest cutoff would meet
  bool worthwhile = true;  ///< the next run has a chance, or costs little
};

/// The error of 1 − ε² with the runs up to a cutoff, in what it is asked for: that value itself, or, of vibrating
/// bodies, 1, as it may be 0.
struct Reached {
  double cutoff;
  double error;
};

/// @param result of at least two runs
[[nodiscard]] Reached reached(const Restitution& result);

/// Error of 1 − ε² with which a result counts as converged.
[[nodiscard]] double wanted_error(const Restitution& result);

/// By how many levels the first run lies below the usual one: on a half-space, where slow impacts last longer and lose
/// at lower frequencies. @param stretch of the half-space (RefinableContact::stretch)
[[nodiscard]] int levels_below(const Contact& contact, double speed, double stretch);

/// Rungs from the first run to the second: few waves are enough on a half-space, and at the circle where a ball
/// touches.
[[nodiscard]] int second_rung(const Contact& contact);

/// What the runs of a result let expect. @param first of them that counts
/// @param order at which errors should fall with the cutoff @param highest cutoff
[[nodiscard]] NextRun outlook(const Restitution& result, const Reached& first, double order, double highest);

/// Rungs to the third run, which is at most the highest level. @param order, highest as above
[[nodiscard]] int third_rung(const Restitution& result, double order, double highest, int levels_above);

/// Why a tolerance cannot be met: because a body stays, of which no cutoff tells more,
[[nodiscard]] std::string stays_open(const Restitution& result);

/// or because that needs cutoffs above the highest.
[[nodiscard]] std::string beyond_reach(const Restitution& result, const NextRun& next, double highest,
                                       const Contact& contact);

}  // namespace stoss
