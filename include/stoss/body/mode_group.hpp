#pragma once

#include <cstddef>
#include <vector>

#include "stoss/cxx20.hpp"

namespace stoss {

/// Kept modes that move the surface in the same two shapes, as a structure of arrays over the index l: for a disk
/// those of one angular order n. A mode with coordinate Q moves contact point i towards what the body meets by
///
///   Q (upper · shape[upper_row][i] + lower · shape[lower_row][i]),
///
/// with the rows of Surface::shape, which groups may share: for a disk cos(n + 1)φ and cos(n − 1)φ.
struct ModeGroup {
  int order = 0;              ///< n
  std::vector<double> omega;  ///< ω > 0, c/R
  std::vector<double> upper;  ///< weight on the first row
  std::vector<double> lower;  ///< weight on the second row
  std::size_t upper_row = 0;  ///< of Surface::shape
  std::size_t lower_row = 0;  ///< of Surface::shape
  std::vector<int> index{};   ///< l of each mode; empty: 0, 1, 2, …
  double wave_number = 0.0;   ///< of the shapes along the surface, 1/R

  /// Of a body with Body::layers, modes × layers: the modulus of a mode is the sum of these times those of the layers,
  /// each 1 at first (docs/theory/plates.md).
  std::vector<double> moduli{};
};

}  // namespace stoss
