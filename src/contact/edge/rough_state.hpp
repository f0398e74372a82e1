#pragma once

#include <cstddef>
#include <vector>

#include "contact/edge/edge_law.hpp"
#include "numeric/kernels.hpp"

namespace stoss {

/// Nodes of a rough contact, with all that follows from their closures: f = f* eᵗ for any t, and the gap and its slope
/// of EdgeLaw.
struct RoughState {
  std::vector<double> closure, force, root, gap, stiffness;  ///< t, f, √(f/f_e), g, d = −dg/df

  explicit RoughState(std::size_t nodes) : closure(nodes), force(nodes), root(nodes), gap(nodes), stiffness(nodes) {}

  /// Sets the closure of a node.
  void set(const EdgeLaw& law, std::size_t i, double closure_of_it);

  /// Adds small changes of the closure to neighbouring nodes, up to kernels::most_of_closure.
  void close(const EdgeLaw& law, std::size_t first, std::size_t count, const double* change);

  /// Changes the forces of neighbouring nodes as a step of Newton's method has it. Where the change is not small a node
  /// moves by itself to where w f − g has the value that the step asks for, however far that is.
  /// @param own w, what the others leave of the compliance of each
  /// @return the largest change over the force
  double push(const EdgeLaw& law, std::size_t first, std::size_t count, const double* change, const double* own);

 private:
  void settle(const EdgeLaw& law, std::size_t i, double change, double own);
  [[nodiscard]] numeric::kernels::RoughNodes view(const EdgeLaw& law, std::size_t first);

  std::vector<double> reach_;  // g of t = 0 without an edge
};

}  // namespace stoss
