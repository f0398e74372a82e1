#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace stoss {

/// The compliance between points on both sides of the axis, first all on the right, then their mirror images: of the
/// displacement x against the normal force f of each, and of y against its friction q,
///
///   u_x = xx f + xy q,   u_y = xyᵀ f + yy q.
struct SidedCompliance {
  Eigen::MatrixXd xx, xy, yy;
};

/// @param normal_even, along_even the blocks of bodies with two components (Body::along), 2 · points × 2 · points
[[nodiscard]] SidedCompliance sided_compliance(const std::vector<double>& normal_even,
                                               const std::vector<double>& along_even, std::size_t points);

/// Values at points on both sides, right and left, as those of a block: even first component, odd second one.
/// @param first, second of both components at all points
/// @param share ½ for displacements, 1 for forces: the work is the same
void to_block(const Eigen::VectorXd& first, const Eigen::VectorXd& second, double share, std::vector<double>& block);

/// Adds the displacements of a block to those of both sides.
void add_block(const std::vector<double>& block, Eigen::VectorXd& first, Eigen::VectorXd& second);

}  // namespace stoss
