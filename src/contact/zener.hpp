#pragma once

namespace stoss {

/// What C. Zener's law says of a ball on a plate that gives way like a dashpot.
struct ZenerImpact {
  double restitution = 1.0;  ///< ε; of a ball that stays, 0
  double duration = 0.0;     ///< in (m/(K√v))^(2/5), of Hertz' force K δ^(3/2); of a ball that stays, until its energy is
                             ///< 1e-4 of what it was
};

/// The sphere on a thin plate, s̈ + (1 + λ d/dσ) s^(3/2) = 0 with s = 0, ṡ = 1 (Phys. Rev. 59, 669, 1941), to 1e-6:
/// s is the compression, λ the mobility of the plate times the mass over the unit of time.
/// @param inelasticity λ, 0 or more
[[nodiscard]] ZenerImpact zener_impact(double inelasticity);

}  // namespace stoss
