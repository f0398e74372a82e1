#pragma once

#include <vector>

#include "bodies/parity.hpp"
#include "bodies/residual.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::disk {

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
