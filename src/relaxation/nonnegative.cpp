#include "relaxation/nonnegative.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <limits>
#include <vector>

namespace stoss {
namespace {

/// The least squares of some columns alone, 0 for the others.
Eigen::VectorXd solved(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right, const std::vector<bool>& free) {
  const auto count = static_cast<Eigen::Index>(std::count(free.begin(), free.end(), true));
  Eigen::MatrixXd some(matrix.rows(), count);
  Eigen::Index next = 0;
  for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
    if (free[static_cast<std::size_t>(j)]) some.col(next++) = matrix.col(j);
  }
  const Eigen::VectorXd found = some.colPivHouseholderQr().solve(right);
  Eigen::VectorXd all = Eigen::VectorXd::Zero(matrix.cols());
  next = 0;
  for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
    if (free[static_cast<std::size_t>(j)]) all(j) = found(next++);
  }
  return all;
}

}  // namespace

Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& given, const Eigen::VectorXd& right) {
  constexpr double rounding = 1e-13;
  const Eigen::VectorXd lengths =
      given.colwise().norm();  // columns of one length: what rounding is, is the same for all
  const Eigen::MatrixXd matrix = given.array().rowwise() / lengths.transpose().array();
  const Eigen::Index size = matrix.cols();
  const double enough = rounding * right.norm();
  std::vector<bool> free(static_cast<std::size_t>(size), false);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(size);
  // Each step frees a column, so that three times their number is more than it takes but for rounding.
  for (Eigen::Index step = 0; step < 3 * size; ++step) {
    const Eigen::VectorXd gain = matrix.transpose() * (right - matrix * x);
    Eigen::Index best = -1;
    for (Eigen::Index j = 0; j < size; ++j) {
      if (!free[static_cast<std::size_t>(j)] && gain(j) > enough && (best < 0 || gain(j) > gain(best))) best = j;
    }
    if (best < 0) break;
    free[static_cast<std::size_t>(best)] = true;
    for (Eigen::VectorXd next = solved(matrix, right, free);; next = solved(matrix, right, free)) {
      double way = 1.0;  // to the first of them that would become negative
      for (Eigen::Index j = 0; j < size; ++j) {
        if (free[static_cast<std::size_t>(j)] && next(j) <= 0.0) way = std::min(way, x(j) / (x(j) - next(j)));
      }
      const bool whole = way == 1.0 && (next.array() >= 0.0).all();
      x += way * (next - x);
      if (whole) break;
      for (Eigen::Index j = 0; j < size; ++j) {
        if (free[static_cast<std::size_t>(j)] && (next(j) <= 0.0) &&
            x(j) <= std::numeric_limits<double>::epsilon() * x.maxCoeff()) {
          free[static_cast<std::size_t>(j)] = false, x(j) = 0.0;
        }
      }
    }
  }
  return x.array() / lengths.array();
}

}  // namespace stoss
