// A second rival: finite elements, which share nothing with stoss but the problem (docs/theory/walls.md). An elastic
// disk in plane stress, R = c = ρ = 1, E = 1, meets a rigid wall without friction:
//
//   M ü = −K u + f,   u_z(φ) ≤ 1 − cos φ on the edge,   f ≥ 0 there only where they are equal.
//
// Spectral elements of order 4 with the Gauss–Lobatto rule, hence a diagonal M, on half the disk; central differences.
// After each step, nodes beyond the wall are put on it and stop, and the momentum that this takes is the wall's
// impulse. As fast as we know: no matrix is assembled, sums factorise over rows and columns, four elements are computed
// at a time, side by side in vector registers, and the mesh is finest at the contact and coarse inside.
#pragma once

#include <cstddef>
#include <vector>

#include "element_forces.hpp"
#include "half_disk_mesh.hpp"

namespace bench {

struct ElementCollision {
  double lost_fraction = 0.0;  ///< 1 − ε² of the centre of mass
  double contact_time = 0.0;   ///< from the first to the last contact, R/c
  long steps = 0;
};

class FiniteElements {
 public:
  FiniteElements(double poisson, const MeshSize& size);

  /// One impact at a speed v, in c, from the first touch until no node has met the wall for a while.
  [[nodiscard]] ElementCollision collide(double speed);

  /// Rayleigh's quotient uᵀKu / uᵀMu, an estimate of a mode's ω² by its displacement.
  [[nodiscard]] double rayleigh_quotient(const std::vector<Point>& displacement);

  [[nodiscard]] const std::vector<Point>& nodes() const { return nodes_; }
  /// Of the half disk.
  [[nodiscard]] double mass() const { return mass_of_half_; }

 private:
  void place(const std::vector<Element>& elements);
  void find_step();
  void add_forces();

  Moduli moduli_;
  std::vector<Point> nodes_;
  std::vector<ElementGroup> groups_;
  std::vector<std::size_t> edge_;  // nodes on the half circle
  std::vector<double> mass_;       // of each node
  double mass_of_half_ = 0.0;
  double step_ = 0.0;
  // Across, then towards the wall, as all vectors here: of nodes that cannot move so, 1/mass is 0.
  std::vector<double> inverse_mass_, displacement_, velocity_, force_;
};

}  // namespace bench
