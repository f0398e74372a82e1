#pragma once

#include <memory>
#include <vector>

#include "stoss/bodies/disk/modes.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::disk {

/// A disk against forces along its edge (Body::along): its displacements (x even | y odd) under normal forces that are
/// even in y and tangential ones that are odd, then (y even | x odd) under tangential forces that are even.
///
/// With the rows (m,±) = (cos mφ | ± sin mφ) a mode of amplitudes C, S moves the first by ½(C + S) on (n+1,+) and
/// ½(C − S) on (n−1,−), and its brother, turned by π/2n, the second by −½(C + S) on (n+1,−) and ½(C − S) on (n−1,+).
/// The second has the torsional vibrations besides.
/// @param disk  all but its modes and functions
/// @param modes up to its kept cutoff
[[nodiscard]] std::vector<Body> bodies_along(const Body& disk, double poisson,
                                             const std::shared_ptr<const std::vector<Mode>>& modes, const Poll& poll);

}  // namespace stoss::bodies::disk
