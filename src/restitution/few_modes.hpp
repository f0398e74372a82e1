#pragma once

#include <vector>

#include "restitution/error_bar.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {

/// Whether one of two bodies is known at a point only, so that few modes of it may be all there are.
[[nodiscard]] bool has_few_modes(const Contact& contact);

/// By how much 1 − ε² may be off where few modes are kept, in place of the doubt of a single run. What the modes above
/// the cutoff take swings with it, as they do or do not swing with the contact, so what counts is the greatest
/// unresolved energy of all runs, each brought to the last cutoff ω as ω^−2:
///
///   k max_j U_j (ω_j/ω)²,   k = a (4/ω)^p max((10⁻³/v)^q, f), at most 2
///
/// as modes above take between nothing and twice what they do on average.
///
/// @param scale of time of the contact; ω is in its units
/// @param speed of the faster body in its own wave speed
[[nodiscard]] Term doubt_of_few_modes(const std::vector<Run>& runs, double scale, double speed);

}  // namespace stoss
