// SymmetricProducts against products of whole matrices, for sizes and numbers of rows around its blocks.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cstddef>
#include <random>

#include "numeric/dense.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using numeric::SymmetricProducts;
using Matrix = SymmetricProducts::Matrix;

TEST(SymmetricProducts, AreThoseOfWholeMatrices) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const Poll none;
  for (const Eigen::Index size : {1, 7, 8, 9, 33, 64, 130}) {
    for (const Eigen::Index rows : {0, 1, 63, 64, 65, 200}) {
      const Matrix shape = Matrix::NullaryExpr(rows, size, [&] { return normal(random); });
      const Eigen::VectorXd weight = Eigen::VectorXd::NullaryExpr(rows, [&] { return normal(random); });
      SymmetricProducts products(static_cast<std::size_t>(size), none);
      for (Eigen::Index row = 0; row < rows; ++row) {
        products.start();
        products.shape() = shape.row(row);
        products.load() = weight(row) * shape.row(row);
      }
      const Matrix expected = shape.transpose() * weight.asDiagonal() * shape, sum = products.sum();
      EXPECT_LT((sum - expected).cwiseAbs().maxCoeff(), 1e-12 * static_cast<double>(1 + rows)) << size << " " << rows;
      EXPECT_EQ(sum, Matrix(sum.transpose()));
    }
  }
}

TEST(SymmetricProducts, CanBeStopped) {
  struct Stopped {};
  bool stopping = false;
  const Poll poll = [&stopping] {
    if (stopping) throw Stopped{};
  };
  SymmetricProducts products(5, poll);
  for (int row = 0; row < 64; ++row) products.start();
  stopping = true;
  EXPECT_THROW(products.start(), Stopped);
  EXPECT_THROW(SymmetricProducts(5, poll), Stopped);
}

}  // namespace
}  // namespace stoss
