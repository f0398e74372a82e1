// Cholesky factorization and triangular inverses in blocks, against their definitions and Eigen's own; copies in
// blocks.
#include "numeric/dense.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <numeric>
#include <vector>

namespace stoss::numeric::dense {
namespace {

using Eigen::MatrixXd;

/// Positive definite, with eigenvalues from 1 on.
MatrixXd positive(Eigen::Index size) {
  MatrixXd b(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) b(i, j) = std::sin(1.0 + 3.7 * static_cast<double>(i * size + j));
  }
  return b * b.transpose() + MatrixXd::Identity(size, size);
}

TEST(Dense, FactorsAndInvertsMatricesOfAllSizes) {
  for (const Eigen::Index size : {1, 2, 31, 32, 33, 64, 100, 129}) {
    const MatrixXd matrix = positive(size);
    MatrixXd factored = matrix;
    ASSERT_TRUE(factor(factored, {})) << size;
    const MatrixXd lower = factored.triangularView<Eigen::Lower>();
    EXPECT_LT((lower * lower.transpose() - matrix).norm(), 1e-14 * matrix.norm()) << size;
    const MatrixXd reference = matrix.llt().matrixL();
    EXPECT_LT((lower - reference).norm(), 1e-12 * lower.norm()) << size;

    MatrixXd inverse(size, size);
    invert_lower(factored, inverse, {});
    EXPECT_LT((inverse * lower - MatrixXd::Identity(size, size)).norm(), 1e-12 * static_cast<double>(size)) << size;
    const MatrixXd above = inverse.triangularView<Eigen::StrictlyUpper>();
    EXPECT_EQ(above.norm(), 0.0);

    MatrixXd solution = MatrixXd::Identity(size, size);
    solve(factored, solution, {});
    EXPECT_LT((matrix * solution - MatrixXd::Identity(size, size)).norm(), 1e-11 * static_cast<double>(size)) << size;
  }
}

TEST(Dense, SaysWhatIsNotPositiveDefinite) {
  for (const Eigen::Index bad : {0, 5, 40, 99}) {
    MatrixXd matrix = positive(100);
    matrix(bad, bad) = -1.0;
    EXPECT_FALSE(factor(matrix, {})) << bad;
  }
}

TEST(Dense, CopiesWithAPollBeforeEachBlock) {
  constexpr std::size_t block = std::size_t{1} << 20U;
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, block, 2 * block + 1}) {
    std::vector<double> values(size);
    std::iota(values.begin(), values.end(), 0.5);
    std::size_t polls = 0;
    EXPECT_EQ(copy(values, [&polls] { ++polls; }), values);
    EXPECT_EQ(polls, (size + block - 1) / block);
    EXPECT_EQ(copy(values, {}), values);
  }
}

}  // namespace
}  // namespace stoss::numeric::dense
