#pragma once

#include <vector>

#include "bodies/residual.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::disk {

/// Which of two blocks of displacements at the points ±φ_i, and of the forces that drive them.
enum class Parity {
  normal_even,  ///< (x even | y odd): the modes u_r = C cos nφ, u_φ = S sin nφ
  along_even    ///< (y even | x odd): the modes u_r = C sin nφ, u_φ = −S cos nφ
};

/// A response between points of the edge as a sum over the angular orders, as sum_over_orders, of both components of a
/// block: 2 · points × 2 · points,
///
///   (1/m) Σ_n [R^CC c_i c_j + R^CS (c_i s_j + s_i c_j) + R^SS s_i s_j]
///
/// with, for the two components,
///
///   normal_even:  c = (cos nφ cos φ | cos nφ sin φ),   s = (−sin nφ sin φ | sin nφ cos φ)
///   along_even:   c = (sin nφ sin φ | sin nφ cos φ),   s = (−cos nφ cos φ | cos nφ sin φ).
[[nodiscard]] std::vector<double> sum_over_orders(const OrderSum& sum, Parity parity, const ContactPoints& points,
                                                  const Poll& poll);

}  // namespace stoss::bodies::disk
