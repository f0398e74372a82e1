#include "dense.hpp"

#include <Eigen/Cholesky>

namespace stoss::dense {

bool factor(Eigen::Ref<Eigen::MatrixXd> matrix, const Poll& poll) {
  const Eigen::Index size = matrix.rows();
  bool positive = true;
  by_columns(size, poll, [&](Eigen::Index first, Eigen::Index count) {
    if (!positive) return;
    const Eigen::Index below = size - first - count;
    auto column = matrix.block(first, first, size - first, count);
    column.noalias() -= matrix.block(first, 0, size - first, first) * matrix.block(first, 0, count, first).transpose();
    Eigen::Ref<Eigen::MatrixXd> corner = column.topRows(count);
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> in_place(corner);
    positive = in_place.info() == Eigen::Success;
    if (!positive) return;
    auto rest = column.bottomRows(below);
    corner.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(rest);
  });
  return positive;
}

Eigen::MatrixXd inverse_of_lower(const Eigen::MatrixXd& lower, const Poll& poll) {
  const Eigen::Index size = lower.rows();
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(size, size);
  by_columns(size, poll, [&](Eigen::Index first, Eigen::Index count) {
    const Eigen::Index rest = size - first;
    auto columns = inverse.block(first, first, rest, count);
    columns.diagonal().setOnes();
    lower.bottomRightCorner(rest, rest).triangularView<Eigen::Lower>().solveInPlace(columns);
  });
  return inverse;
}

void solve(const Eigen::MatrixXd& lower, Eigen::MatrixXd& right, const Poll& poll) {
  by_columns(right.cols(), poll, [&](Eigen::Index first, Eigen::Index count) {
    auto columns = right.middleCols(first, count);
    lower.triangularView<Eigen::Lower>().solveInPlace(columns);
    if (poll) poll();
    lower.triangularView<Eigen::Lower>().transpose().solveInPlace(columns);
  });
}

}  // namespace stoss::dense
