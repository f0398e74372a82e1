#pragma once

#include "stoss/bodies/disk.hpp"

namespace stoss {

/// The near side of a disk: a smaller disk of the same material, but with the contour of the whole.
///
/// A load on the edge tells nothing of the size of the disk until the pressure wave is back from the far side of the
/// smaller one, 4 size/c_P, but through the curvature of the edge, which is 1/size here instead of 1. That changes what
/// the edge answers in proportion to 1/size − 1 (docs/theory/pairs.md).
/// @param size   radius of the smaller disk, R, above 0 to 1
/// @param cutoff in c/R of the whole disk, above 0 to 1000/size
/// @throws InvalidInput outside these ranges
[[nodiscard]] Body near_side(const Disk& disk, double size, double cutoff, const Poll& poll = {});

}  // namespace stoss
