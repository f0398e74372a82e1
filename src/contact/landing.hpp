#pragma once

#include <algorithm>

namespace stoss {

/// D of a node in a step, by which it moves along the surface per friction in addition to the compliance between nodes
/// (Friction): what the edge law is along the normal, in the other direction.
///
/// The edge law lets a node carry pressure at a gap, so that its stiffness grows gradually. A node that sticks as soon
/// as it carries pressure would add all of its stiffness at once, an error of first order in the spacing. In a
/// continuous contact a small step along the surface meets the punch that a step along the normal meets, whose
/// compliance is W + diag(−dg/df); with the secant in place of the slope friction under a load of fixed direction is
/// proportional to the pressure at every node and step, as it must be.
/// @param ratio  local softness along the surface over that along the normal
/// @param gap    of the node, exactly 0 where it is rigid; as far as it is open where it carries no pressure
/// @param force  its pressure times its area
[[nodiscard]] inline double landing_give(double ratio, double gap, double gap_before, double force,
                                         double force_before) {
  if (!(force > 0.0) || force == force_before) return 0.0;
  return ratio * std::max(0.0, -(gap - gap_before) / (force - force_before));
}

}  // namespace stoss
