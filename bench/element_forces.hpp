// Forces of spectral elements, f = −K u: the derivatives of the displacement, stress by Hooke's law, and back. Sums
// factorise over rows and columns, no matrix is assembled, and elements are computed side by side in vector registers.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "elements.hpp"

namespace bench {

/// Whether a node belongs to no other element.
constexpr bool is_inner(std::size_t node) {
  const std::size_t row = node / element_side;
  const std::size_t column = node % element_side;
  return row > 0 && row + 1 < element_side && column > 0 && column + 1 < element_side;
}

/// Elements side by side in vector registers. Their inner nodes are neighbours in memory, from `inner` on.
struct ElementGroup {
  static constexpr std::size_t lanes = 4;
  using Lanes [[gnu::vector_size(8 * lanes), gnu::aligned(8 * lanes)]] = double;

  Lanes slope[element_nodes][4];  ///< ∂r/∂x, ∂s/∂x, ∂r/∂z, ∂s/∂z, times √(weight)
  std::array<std::array<std::size_t, lanes>, element_nodes> rim;  ///< nodes shared with others
  std::size_t inner;
};

/// What a circumference adds where all is symmetric about an axis: ε_θθ = u_x/x. The factor of u_x, 1/x times
/// √(weight), is 0 on the axis itself, where ε_θθ = ε_xx.
struct HoopGroup {
  ElementGroup::Lanes slope[element_nodes];
};

/// σ_xx = normal ε_xx + lateral (ε_zz + ε_θθ), σ_xz = 2 shear ε_xz, and likewise.
struct Moduli {
  double normal, lateral, shear;
};

/// Elements of one body: in plane stress, without hoops; or about an axis, with as many hoops as groups, and those
/// first that touch it.
struct Groups {
  std::vector<ElementGroup> all;
  std::vector<HoopGroup> hoops;
  std::size_t at_axis = 0;
};

/// Sets the forces at inner nodes, and adds to those at others.
/// @param displacement of all `count` nodes, across, then towards the wall; forces likewise
void add_forces(const Groups& groups, const Moduli& moduli, std::size_t count, const double* displacement,
                double* force);

}  // namespace bench
