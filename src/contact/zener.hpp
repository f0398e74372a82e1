#pragma once

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

}  // namespace stoss
