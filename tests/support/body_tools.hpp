#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "stoss/body/body.hpp"
#include "stoss/impact/impact.hpp"

namespace stoss::test {

/// The same body on one grid for all speeds, so that two impacts at different speeds see the same nodes.
inline Body on_one_grid(const Body& body, double speed) {
  Body result = body;
  const double half_width = std::min(1.5 * body.expected_half_width(speed) + 0.25, body.max_half_width);
  result.grid = [grid = body.grid, half_width](double, int nodes) { return grid(half_width, nodes); };
  return result;
}

/// The same body with its groups in reverse order, and the modes in reverse order within each group.
inline Body reversed(const Body& body) {
  Body result = body;
  std::reverse(result.groups.begin(), result.groups.end());
  for (ModeGroup& group : result.groups) {
    std::reverse(group.omega.begin(), group.omega.end());
    std::reverse(group.radial.begin(), group.radial.end());
    std::reverse(group.tangential.begin(), group.tangential.end());
  }
  return result;
}

/// The motion run backwards: velocities and momenta change sign.
inline State backwards(State state) {
  state.velocity = -state.velocity;
  for (double& momentum : state.momentum) momentum = -momentum;
  return state;
}

}  // namespace stoss::test
