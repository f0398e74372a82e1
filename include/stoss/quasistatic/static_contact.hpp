#pragma once

#include <vector>

#include "stoss/bodies/sphere.hpp"
#include "stoss/poll.hpp"

namespace stoss::quasistatic {

/// Resolution of a static contact with a hard wall.
struct StaticContactOptions {
  int nodes = 160;  ///< on half of the contact, 16 … 1024
  Poll poll{};
};

/// A disk or a sphere held against a hard wall, at rest.
struct StaticContact {
  double poisson = 0.0;
  double compression = 0.0;      ///< δ = R + x₀, R
  double force = 0.0;            ///< F, πRE = mc²/R
  double force_error = 0.0;      ///< estimate: change from half as many nodes, at least 0.2 F/nodes² (sphere: 0.25)
  double half_width = 0.0;       ///< of the contact, R; the arc on the undeformed edge
  double energy = 0.0;           ///< stored in the disk, mc²; dU/dδ = F
  int contact_nodes = 0;         ///< nodes with a pressure; the first ones
  double spacing = 0.0;          ///< h of the nodes, which stand for h on either side of the contact's middle
  std::vector<double> position;  ///< φ_i = (i + ½)h of the nodes, on the undeformed edge, R
  std::vector<double> pressure;  ///< in the direction of x, per length of the undeformed edge, E; Σ 2hp_i = πF
};

/// The contact of a disk whose centre of mass is held at the distance R − δ from a hard wall, by small-strain
/// elasticity and the exact shape of the edge: pressures f ≥ 0 and gaps g ≥ 0 with
///
///   g = W f − (δ − 2 sin²(φ/2)),   fᵀ g = 0,
///
/// where W is the closed-form compliance of all modes, with inertia relief for n = 1 (docs/theory/modes.md,
/// walls.md): the force of the wall is balanced by a uniform body force, as in the impact. No law of contact enters.
///
/// The force converges with the square of the nodes: to 1.5e-6 with 160 for δ up to 0.13, 6e-6 up to 0.5; the energy to
/// 2e-8, the half-width to 1e-4 for δ up to 0.13 and always to one node (docs/theory/quasistatic.md).
/// @param poisson     2-D Poisson's ratio, −0.95 … 0.995
/// @param compression δ, 1e-12 … 0.5 R. Small-strain elasticity means little from about 0.1 on.
/// @throws InvalidInput outside these ranges; NotConverged if no set of touching nodes satisfies the conditions
[[nodiscard]] StaticContact static_contact(double poisson, double compression,
                                           const StaticContactOptions& options = {});

/// The same of a sphere: rings for nodes, and the compliance of all degrees. `half_width` is the radius of the contact,
/// `pressure` that of each ring, and Σ area · pressure = (4π/3)F: 13 % too little in the innermost ring and 2.4 % too
/// much in the next, at any resolution, and within 1 % elsewhere. The force converges with the square of the nodes: to
/// 3e-6 with 160 for δ up to 0.1. Takes 0.3 s with 160 nodes for δ below 1e-3, 0.1 s with 80.
/// @throws InvalidInput as above, with a 3-D Poisson's ratio of −0.95 … 0.4999
[[nodiscard]] StaticContact static_contact(const Sphere& sphere, double compression,
                                           const StaticContactOptions& options = {});

}  // namespace stoss::quasistatic
