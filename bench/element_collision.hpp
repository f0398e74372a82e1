// Collisions of finite elements without friction: a disk or a ball at a rigid wall, or a ball on a half-space. After
// each step nodes that would overlap are put together, and move on together, which takes the least impulse.
#pragma once

#include "block_mesh.hpp"
#include "finite_elements.hpp"

namespace bench {

struct ElementCollision {
  double lost_fraction = 0.0;  ///< 1 − ε² of the centre of mass
  double contact_time = 0.0;   ///< from the first to the last contact, R/c
  long steps = 0;
};

/// An impact at a speed, in c, from the first touch until no node has touched for a while.
[[nodiscard]] ElementCollision collide(FiniteElements& body, double speed);

/// Its like on a half-space, a block made for this ball.
[[nodiscard]] ElementCollision collide(FiniteElements& ball, FiniteElements& block, double speed);

}  // namespace bench
