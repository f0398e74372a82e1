// Elements of half of the unit disk, x ≥ 0, or of the unit ball about the axis x = 0. A half square in the middle, and
// rings around it; then the whole is pulled towards (0, 1), where the contact is, by ζ → (ζ + s)/(1 + sζ), which keeps
// the circle and all angles. There elements become smaller by (1 − s)/(1 + s), and larger by as much on the far side.
#pragma once

#include <vector>

#include "elements.hpp"

namespace bench {

struct MeshSize {
  int elements = 1;      ///< n, across the half square, and 2n along the axis: 4n on the half circle
  int rings = 1;         ///< m, of elements around the square: 2n² + 4nm elements in all
  double grading = 0.0;  ///< s, 0 … below 1
};

/// All elements; their nodes are counted once for each.
[[nodiscard]] std::vector<Element> half_disk(Symmetry symmetry, const MeshSize& size);

/// A point of its edge, by the angle before grading.
[[nodiscard]] Point on_edge(double angle, const MeshSize& size);

}  // namespace bench
