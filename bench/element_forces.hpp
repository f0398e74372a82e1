// Forces of spectral elements, f = −K u: the derivatives of the displacement, stress by Hooke's law, and back. Sums
// factorise over rows and columns, no matrix is assembled, and elements are computed side by side in vector registers.
#pragma once

#include <array>
#include <cstddef>

#include "half_disk_mesh.hpp"

namespace bench {

/// d/dr of the polynomial that is 1 at one point and 0 at the others, at all points: derivative[point][polynomial].
inline constexpr auto derivative = [] {
  std::array<std::array<double, element_side>, element_side> result{};
  const auto& x = lobatto_points;
  for (std::size_t i = 0; i < element_side; ++i) {
    for (std::size_t j = 0; j < element_side; ++j) {
      for (std::size_t k = 0; k < element_side; ++k) {
        if (k == j) continue;
        double product = 1.0 / (x[j] - x[k]);
        for (std::size_t l = 0; l < element_side; ++l) {
          if (l != j && l != k) product *= (x[i] - x[l]) / (x[j] - x[l]);
        }
        result[i][j] += product;
      }
    }
  }
  return result;
}();

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

/// σ_xx = normal ε_xx + lateral ε_zz, σ_xz = 2 shear ε_xz.
struct Moduli {
  double normal, lateral, shear;
};

/// Sets the forces at inner nodes, and adds to those at others.
/// @param displacement of all `count` nodes, across, then towards the wall; forces likewise
void add_forces(const ElementGroup* groups, std::size_t number, const Moduli& moduli, std::size_t count,
                const double* displacement, double* force);

}  // namespace bench
