#pragma once

#include <vector>

#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::sphere {

/// A response between rings as a sum over the degrees,
///
///   (1/m) Σ_n [R^UU a_i a_j − R^UV (a_i b_j + b_i a_j) + R^VV b_i b_j],   a = cos θ P_n,   b = sin θ dP_n/dθ,
///
/// over those that the rings resolve, n ≤ N = π/h, the last with weight ½. R_n are the given coefficients and, where
/// `with_static`, the static flexibilities of all degrees.
///
/// Low degrees are added up one by one. Where there are many more than rings, the higher ones go by Gauss quadrature of
/// a sum over blocks of degrees, in which the products turn by at most 18 to either side: an error of 1e-14, and as
/// many terms for any N.
struct DegreeSum {
  double poisson = 0.0;
  bool with_static = false;
  std::vector<Flexibility> coefficients;  ///< of n = 0, 1, 2, …
};

/// The matrix of the sum, rings × rings, symmetric.
[[nodiscard]] std::vector<double> sum_over_degrees(const DegreeSum& sum, const ContactPoints& points, const Poll& poll);

}  // namespace stoss::bodies::sphere
