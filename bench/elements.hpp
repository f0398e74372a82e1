// Curved quadrilaterals for spectral elements of order 4: the nodes of one are the products of the points of two rules
// of quadrature.
#pragma once

#include <array>
#include <cstddef>

#include "spectral_rule.hpp"

namespace bench {

inline constexpr std::size_t element_nodes = element_side * element_side;

/// Nodes are further apart; coordinates of one agree much better.
inline constexpr double same_place = 1e-8;

struct Point {
  double across = 0.0;   ///< x, from the axis of symmetry
  double towards = 0.0;  ///< z, from the centre of the disk or ball towards what it meets
};

struct Element {
  std::array<Point, element_nodes> nodes;  ///< row by row, r from −1 to 1; along a row s from −1 to 1
  bool at_axis = false;  ///< its row r = −1 lies on an axis of symmetry, and r has `lobatto_at_axis`
};

enum class Symmetry {
  plane,  ///< plane stress, two halves: u_x = 0 at x = 0
  axial   ///< about the axis x = 0
};

}  // namespace bench
