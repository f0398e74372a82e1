// Half of the unit disk, x ≥ 0, as curved quadrilaterals for spectral elements: the nodes of an element are the
// products of the Gauss–Lobatto points of order 4. A half square in the middle, and rings around it; then the whole is
// pulled towards (0, 1), where the wall is, by ζ → (ζ + s)/(1 + sζ), which keeps the circle and all angles. There
// elements become smaller by (1 − s)/(1 + s), and larger by as much on the far side.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace bench {

inline constexpr std::size_t element_side = 5;  ///< nodes
inline constexpr std::size_t element_nodes = element_side * element_side;
inline constexpr std::array<double, element_side> lobatto_points = {-1.0, -0.654653670707977144, 0.0,
                                                                    0.654653670707977144, 1.0};
inline constexpr std::array<double, element_side> lobatto_weights = {1.0 / 10, 49.0 / 90, 32.0 / 45, 49.0 / 90,
                                                                     1.0 / 10};

struct Point {
  double across = 0.0;   ///< x, from the axis of symmetry
  double towards = 0.0;  ///< z, from the centre towards the wall
};

struct MeshSize {
  int elements = 1;      ///< n, across the half square, and 2n along the axis: 4n on the half circle
  int rings = 1;         ///< m, of elements around the square: 2n² + 4nm elements in all
  double grading = 0.0;  ///< s, 0 … below 1
};

/// The nodes of an element, row by row; neighbours along a row differ in the second coordinate.
using Element = std::array<Point, element_nodes>;

/// All elements; their nodes are counted once for each.
[[nodiscard]] std::vector<Element> half_disk(const MeshSize& size);

}  // namespace bench
