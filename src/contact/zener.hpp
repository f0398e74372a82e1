#pragma once

#include <optional>

#include "stoss/contact/contact.hpp"

namespace stoss {

/// Where a ball on a plate is in C. Zener's law: compression s in v T₀ and speed V of the ball in v, the speed of
/// approach, with T₀ = (m/(K√v))^(2/5) of Hertz' force K δ^(3/2).
struct ZenerMotion {
  double compression = 0.0, speed = 1.0;
};

/// What follows from there.
struct ZenerImpact {
  double restitution = 1.0;  ///< ε; 0 of a ball that stays: its energy falls to 2e-5 of what it was
  double duration = 0.0;     ///< T₀; of a ball that stays, until it has followed its force for some time
};

/// A sphere on a plate so thin that it gives way like a dashpot, s̈ + (1 + λ d/dσ) s^(3/2) = 0 (Phys. Rev. 59, 669,
/// 1941), to 1e-6.
/// @param inelasticity λ: the mobility of the plate times the mass over T₀, 0 or more
[[nodiscard]] ZenerImpact zener_impact(double inelasticity, const ZenerMotion& start = {});

/// λ and T₀, R/c, of a contact with a plate.
struct ZenerScales {
  double inelasticity, time;
};
[[nodiscard]] ZenerScales zener_scales(const Contact& contact, double speed);

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

/// Whether a ball on a plate stays, but cannot be seen to before a time is over: its contact, of a² = 2δ/R = 2vt/R
/// at first, grows faster than waves of bending spread, a² = κt, and these have not left the ball by then, so that
/// it does not move by Zener's law yet. On 30 plates (v = 10⁻³ to 0.1, κ = 0.1 v to 2 v, elastic and rigid balls)
/// none below both limits was seen to stay within 8 times what is expected.
[[nodiscard]] bool stays_unseen(const Contact& contact, double speed, double time);

}  // namespace stoss
