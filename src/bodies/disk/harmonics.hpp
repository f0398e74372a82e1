#pragma once

#include <Eigen/Core>

namespace stoss::bodies::disk {

/// Sums over angular orders are taken so many orders at a time: the tables stay small for any number of orders.
inline constexpr int order_block = 32;

/// Cosines and sines of nφ for n = first … first + order_block − 1: orders × angles.
struct Harmonics {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Matrix cosine, sine;
};

[[nodiscard]] Harmonics harmonics(const Eigen::ArrayXd& angle, int first);

}  // namespace stoss::bodies::disk
