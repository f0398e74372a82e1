#pragma once

#include <optional>

#include "stoss/contact/contact.hpp"

namespace stoss {

/// A body on its way into what gives way, in units of the first.
struct Slowing {
  double time = 0.0;
  double velocity = 0.0;  ///< of the first body towards what it meets
  double energy = 1.0;    ///< that it still has, or could get back from the compression, as a share of ½mv²
  bool touches = true;
};

/// Whether a body stays on a plate or a strip: ε at most with which it may still leave, or empty if it may part.
///
/// What gives way is infinite, and never returns what it takes. So a body that moves along with it, as the law of the
/// surface has it, stays:
///
/// - a ball on a plate, V̇ = −V/(Ym) with the mobility Y (Zener), as λ > 2.7 and Zener's ε falls as 0.68/λ⁵. It is
///   taken at what λ must be for how the ball was slowed since `before`;
/// - a disk on a strip, V = v eˣ erfc √x, x = t/τ, which is never below 0: the strip moves at g I/√t after an impulse
///   I, and √τ = √π g m. One that is ahead of nothing, but slower than the strip under it, meets it again when that
///   has half its velocity, and even thrown back without a loss it would not recede then.
///
/// @param before when about half of this time was over
[[nodiscard]] std::optional<double> rebound_of_staying(const Contact& contact, double speed, const Slowing& before,
                                                       const Slowing& now);

}  // namespace stoss
