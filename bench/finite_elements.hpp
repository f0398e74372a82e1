// Finite elements of one elastic body, the second rival of stoss, which share nothing with it but the problem
// (docs/theory/walls.md). R = c = ρ = E = 1:
//
//   M ü = −K u + f.
//
// Spectral elements of order 4, whose points are those of the quadrature, hence a diagonal M; central differences. As
// fast as we know: no matrix is assembled, sums factorise over rows and columns, and four elements are computed at a
// time, side by side in vector registers.
#pragma once

#include <cstddef>
#include <vector>

#include "element_forces.hpp"
#include "elements.hpp"

namespace bench {

class FiniteElements {
 public:
  FiniteElements(Symmetry symmetry, double poisson, const std::vector<Element>& elements);

  /// At rest in its undeformed shape but for a velocity towards the contact, of all nodes.
  void start(double velocity);

  /// One step of all nodes, without contact.
  void advance(double step);

  /// Moves a node towards the contact by so much more, and what that is in the last step of its velocity.
  /// @return the impulse that does it
  double push(std::size_t node, double more, double step);

  /// Where a node is now, towards the contact.
  [[nodiscard]] double towards(std::size_t node) const {
    return nodes_[node].towards + displacement_[nodes_.size() + node];
  }

  /// Rayleigh's quotient uᵀKu / uᵀMu, an estimate of a mode's ω² by its displacement.
  [[nodiscard]] double rayleigh_quotient(const std::vector<Point>& displacement);

  /// Undeformed.
  [[nodiscard]] const std::vector<Point>& nodes() const { return nodes_; }
  /// Of a node: of half a disk, or of a body about an axis over 2π.
  [[nodiscard]] double mass(std::size_t node) const { return mass_[node]; }
  [[nodiscard]] double mass() const { return all_mass_; }
  /// As long as is stable, less a margin.
  [[nodiscard]] double step() const { return step_; }

 private:
  void place(const std::vector<Element>& elements);
  void find_step();
  void add_forces();

  Symmetry symmetry_;
  Moduli moduli_;
  std::vector<Point> nodes_;
  Groups groups_;
  std::vector<double> mass_;  // of each node
  double all_mass_ = 0.0;
  double step_ = 0.0;
  // Across, then towards the contact, as all vectors here: of nodes that cannot move so, 1/mass is 0.
  std::vector<double> inverse_mass_, displacement_, velocity_, force_;
};

}  // namespace bench
