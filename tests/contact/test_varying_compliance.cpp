// Blocks of a compliance with what is kept from one to the next, against their solution from scratch.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "contact/edge/compliance.hpp"

namespace stoss {
namespace varying_compliance {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index side = 30;  // nodes of each of two sides

/// Positive definite, and not symmetric.
MatrixXd compliance(double slant) {
  MatrixXd matrix(2 * side, 2 * side);
  for (Index i = 0; i < 2 * side; ++i) {
    for (Index j = 0; j < 2 * side; ++j) {
      const auto apart = static_cast<double>(i - j);
      matrix(i, j) = 1.0 / (1.0 + std::abs(apart)) + slant * (apart < 0.0 ? 0.1 : -0.1);
    }
  }
  matrix.diagonal().array() += 2.0;
  return matrix;
}

/// Nodes up to `touching` of each side, of which those from `rigid` on are not.
void expect_solution(VaryingCompliance& varying, Index touching, Index rigid) {
  std::vector<Index> nodes;
  for (const Index first : {Index{0}, side}) {
    for (Index i = 0; i < touching; ++i) nodes.push_back(first + i);
  }
  const auto size = static_cast<Index>(nodes.size());
  VectorXd diagonal(size), x(size);
  for (Index k = 0; k < size; ++k) {
    const Index i = k % touching;
    diagonal(k) = i < rigid ? 0.0 : 0.3 * static_cast<double>(1 + i - rigid);
    x(k) = std::cos(static_cast<double>(k));
  }
  MatrixXd block(size, size);
  for (Index a = 0; a < size; ++a) {
    for (Index b = 0; b < size; ++b) {
      block(a, b) = varying.matrix()(nodes[static_cast<std::size_t>(a)], nodes[static_cast<std::size_t>(b)]);
    }
    block(a, a) += diagonal(a);
  }
  const VectorXd expected = block.partialPivLu().solve(x);
  ASSERT_TRUE(varying.solve(nodes, diagonal, x));
  EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-13) << touching << ' ' << rigid;
}

TEST(VaryingCompliance, SolvesWhileTheEdgeGoesToAndFro) {
  VaryingCompliance varying;
  for (const double slant : {0.0, 1.0}) {
    varying.assign(compliance(slant));
    for (const Index touching : {2, 5, 12, 13, 12, 14, 20, 28, 30, 29, 20, 11, 3, 1}) {
      for (const Index behind : {2, 1, 3, 0, 2})
        expect_solution(varying, touching, std::max<Index>(0, touching - behind));
    }
  }
}

}  // namespace
}  // namespace varying_compliance
}  // namespace stoss
