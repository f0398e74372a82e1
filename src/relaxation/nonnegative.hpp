#pragma once

#include <Eigen/Core>

namespace stoss {

/// The x ≥ 0 that makes |Ax − b| least: Lawson and Hanson, Solving Least Squares Problems (1974), chapter 23.
/// @param matrix A, whose columns are not 0
[[nodiscard]] Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

}  // namespace stoss
