#pragma once

#include <vector>

#include "stoss/modes.hpp"

namespace curves {

/// What an impact would be if the disk followed the wall's force statically, and its modes had no share in the motion.
struct SlowImpact {
  double contact_time = 0.0;   ///< R/c
  double lost_fraction = 0.0;  ///< energy that this force leaves in the modes, as if they were driven by it; ½mv²
};

/// The centre of mass moves by δ̈ = −F, δ(F) = F [ln(1/F) − (1+ν)/4] (docs/theory.md, erratum E8; F in πRE). The energy
/// left in a mode of amplitude C at the point of contact is ½m C² |∫F e^{iωt} dt|² (Rayleigh). Meaningful for v ≲ 0.1.
/// @param modes of the disk, enough that their energies have died away
SlowImpact slow_impact(double poisson, double speed, const std::vector<stoss::Mode>& modes);

}  // namespace curves
