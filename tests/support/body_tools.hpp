#pragma once

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <variant>
#include <vector>

#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/resolution.hpp"
#include "support/print.hpp"

namespace stoss::test {

/// A wall, and how the modes above the cutoff answer it if it is hard.
struct WallCase {
  Wall wall = HardWall{};
  Tail tail = Tail::radiating;
};

inline void PrintTo(const WallCase& its, std::ostream* out) {
  if (std::holds_alternative<HardWall>(its.wall)) {
    *out << "hard, ";
    PrintTo(its.tail, out);
  } else {
    *out << "exponential, ";
    PrintTo(its.tail, out);
  }
}

/// Both tails at a hard wall, and the exponential wall with and without a tail.
inline const std::vector<WallCase> every_wall{{HardWall{}, Tail::quasistatic},
                                              {HardWall{}, Tail::radiating},
                                              {ExponentialWall{500.0, 1.0}, Tail::none},
                                              {ExponentialWall{500.0, 1.0}, Tail::radiating}};

/// The contact grid of a body at a hard wall.
inline ContactGrid grid_of(const Body& body, double half_width, int nodes) {
  return contact_grid(contact(body), half_width, nodes);
}

/// A contact grid wide enough for all speeds up to this one, so that two impacts see the same nodes.
inline void use_one_grid(const Contact& contact, double speed, Resolution& resolution) {
  if (has_single_point(contact)) return;
  resolution.half_width = std::min(1.5 * expected_half_width(contact, speed) + 0.25, greatest_half_width(contact));
}

/// The same body with its groups in reverse order, and the modes in reverse order within each group.
inline Body reversed(const Body& body) {
  Body result = body;
  std::reverse(result.groups.begin(), result.groups.end());
  for (ModeGroup& group : result.groups) {
    std::reverse(group.omega.begin(), group.omega.end());
    std::reverse(group.upper.begin(), group.upper.end());
    std::reverse(group.lower.begin(), group.lower.end());
    std::vector<double> moduli;
    for (std::size_t l = group.omega.size(); l-- > 0;) {
      const auto from = group.moduli.begin() + static_cast<std::ptrdiff_t>(l * body.layers.size());
      moduli.insert(moduli.end(), from, from + static_cast<std::ptrdiff_t>(body.layers.size()));
    }
    group.moduli = moduli;
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
