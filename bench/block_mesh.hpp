// Elements of a block about the axis x = 0, below a ball that it carries at (0, 1): a half-space for as long as no wave
// comes back from its faces. Its nodes lie opposite those of the ball where both may touch; further out and down
// elements grow.
#pragma once

#include <vector>

#include "elements.hpp"
#include "half_disk_mesh.hpp"

namespace bench {

struct BlockSize {
  double contact_radius = 0.0;  ///< R; at least up to there nodes lie opposite each other
  double extent = 0.0;          ///< R; at least as deep, and its radius too
};

[[nodiscard]] std::vector<Element> block(const MeshSize& ball, const BlockSize& size);

}  // namespace bench
