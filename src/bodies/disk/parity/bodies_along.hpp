#pragma once

#include <memory>
#include <vector>

#include "bodies/parity.hpp"
#include "bodies/residual.hpp"
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

/// A response between points of the edge as a sum over the angular orders, as sum_over_orders, of both components of a
/// block: 2 · points × 2 · points,
///
///   (1/m) Σ_n [R^CC c_i c_j + R^CS (c_i s_j + s_i c_j) + R^SS s_i s_j]
///
/// with, for the two components of the modes u_r = C cos nφ, u_φ = S sin nφ and of their brothers u_r = C sin nφ,
/// u_φ = −S cos nφ,
///
///   normal_even:  c = (cos nφ cos φ | cos nφ sin φ),   s = (−sin nφ sin φ | sin nφ cos φ)
///   along_even:   c = (sin nφ sin φ | sin nφ cos φ),   s = (−cos nφ cos φ | cos nφ sin φ).
[[nodiscard]] std::vector<double> sum_over_orders(const OrderSum& sum, Parity parity, const ContactPoints& points,
                                                  const Poll& poll);

}  // namespace stoss::bodies::disk
