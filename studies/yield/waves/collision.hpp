#pragma once

#include "mover.hpp"

namespace yield_study {

/// A sphere meets a block of its own density and elasticity. Lengths in R, speeds in c = √(E/ρ), stresses in E.
struct Meeting {
  double poisson, of_ball, of_block;  ///< Poisson's ratio, and the strengths
  double speed;
  int elements;  ///< equal ones along `side`, which the contact must not outgrow
  double side;
  double size;  ///< radius of the block, at which it is free: an echo needs 2 size over the fastest speed of sound
  double part = 0.9;  ///< time step over the largest stable one
};

/// What comes of it; energies over that of the approach.
struct Outcome {
  double restitution;
  double force;                  ///< largest mean over 0.25 R/c, mc²/R
  double time;                   ///< of contact
  double deepest;                ///< approach of the middles of the bodies, which a rigid ball and block would not have
  double dent;                   ///< what is left of it when contact ends
  double radius;                 ///< of the outermost node that touched
  double flow_ball, flow_block;  ///< taken by plastic flow
  double ball, block;            ///< waves and stresses that stay
  double imbalance;              ///< of all energies
  int unknowns;
  double step;
};

/// Explicit finite elements at small strain: central differences, lumped masses, node against node without friction.
/// Nodes that would overlap at the end of a step get opposite impulses, after which they just touch. It ends when the
/// ball has flown for 4 R/c.
[[nodiscard]] Outcome collide(const Meeting& meeting);

}  // namespace yield_study
