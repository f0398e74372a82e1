#pragma once

#include "restitution/error_bar.hpp"

namespace stoss {

// What the law of a yielding contact leaves open, whatever the cutoff: that all of it acts at one place, and the fit to
// its finite elements. Nothing where nothing yields. With the half-width a of the contact,

/// Of 1 − ε²: 2a/R of what rings, 0.3 a/R of what runs away; of ε² 1 % where flow takes most, and up to 15 % where one
/// body yields and the other is elastic and as soft.
[[nodiscard]] double doubt_of_yield(const Contact& contact, const Impact& finest);

/// Of greatest force and compression, and of times, as a share of themselves: 0.05 a/R, on plates 0.3 a/R,
/// and 0.3 (a/R)².
[[nodiscard]] Term yield_error_of_force(const Contact& contact, const Restitution& result, double value);
[[nodiscard]] Term yield_error_of_time(const Contact& contact, const Restitution& result, double value);

}  // namespace stoss
