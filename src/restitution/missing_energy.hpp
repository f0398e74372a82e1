#pragma once

#include "restitution/error_bar.hpp"

namespace stoss {

/// What 1 − ε² lacks at a cutoff, as shares of the unresolved energy.
struct Missing {
  double share;  ///< which the modes above the cutoff would return
  Term doubt;    ///< by which one run may be off
};

/// Of contacts on a line. @param cutoff over the time scale of the contact
/// @param speed of the faster body in its own wave speed
Missing missing_on_a_line(double cutoff, double speed);

/// The same where a circle touches. At low speed the loss is a wave of the speed (docs/theory/spheres.md), and what one
/// run is off by falls no faster than the cutoff rises. In a shell waves above the cutoff come back to the contact.
/// @param hole b of the thinner of both bodies, 0 of solid ones
Missing missing_of_balls(double cutoff, double speed, double hole);

}  // namespace stoss
