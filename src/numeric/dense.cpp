#include "numeric/dense.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "numeric/kernels.hpp"

namespace stoss::numeric::dense {
namespace {

constexpr std::size_t block = std::size_t{1} << 20;  // of values

}  // namespace

std::vector<double> zeros(std::size_t size, const Poll& poll) {
  std::vector<double> result;
  result.reserve(size);
  while (result.size() < size) {
    if (poll) poll();
    result.resize(std::min(size, result.size() + block));
  }
  return result;
}

std::vector<double> copy(const std::vector<double>& values, const Poll& poll) {
  std::vector<double> result;
  result.reserve(values.size());
  while (result.size() < values.size()) {
    if (poll) poll();
    const auto next = values.begin() + static_cast<std::ptrdiff_t>(result.size());
    result.insert(result.end(), next,
                  next + static_cast<std::ptrdiff_t>(std::min(values.size() - result.size(), block)));
  }
  return result;
}

Eigen::MatrixXd square(const double* values, Eigen::Index size, const Poll& poll) {
  const Eigen::Map<const Eigen::MatrixXd> from(values, size, size);
  Eigen::MatrixXd result(size, size);
  by_columns(size, poll, [&](Eigen::Index first, Eigen::Index count) {
    result.middleCols(first, count) = from.middleCols(first, count);
  });
  return result;
}

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

void invert_lower(const Eigen::MatrixXd& lower, Eigen::Ref<Eigen::MatrixXd> inverse, const Poll& poll) {
  const Eigen::Index size = lower.rows();
  by_columns(size, poll, [&](Eigen::Index first, Eigen::Index count) {
    const Eigen::Index rest = size - first;
    inverse.middleCols(first, count).setZero();
    auto columns = inverse.block(first, first, rest, count);
    columns.diagonal().setOnes();
    lower.bottomRightCorner(rest, rest).triangularView<Eigen::Lower>().solveInPlace(columns);
  });
}

void solve(const Eigen::MatrixXd& lower, Eigen::MatrixXd& right, const Poll& poll) {
  by_columns(right.cols(), poll, [&](Eigen::Index first, Eigen::Index count) {
    auto columns = right.middleCols(first, count);
    lower.triangularView<Eigen::Lower>().solveInPlace(columns);
    if (poll) poll();
    lower.triangularView<Eigen::Lower>().transpose().solveInPlace(columns);
  });
}

}  // namespace stoss::numeric::dense

namespace stoss::numeric {
namespace {

constexpr std::size_t block = 64;  // pairs of rows at a time: few enough for the first cache, with their products

std::size_t whole_vectors(std::size_t size) { return (size + kernels::lanes - 1) / kernels::lanes * kernels::lanes; }

}  // namespace

SymmetricProducts::SymmetricProducts(std::size_t size, const Poll& poll)
    : size_(size),
      stride_(whole_vectors(size)),
      shape_(block * stride_),
      load_(block * stride_),
      sum_(dense::zeros(stride_ * stride_, poll)),
      poll_(poll) {}

void SymmetricProducts::start() {
  if (rows_ == block) flush();
  ++rows_;
}

void SymmetricProducts::flush() {
  constexpr std::size_t at_once = 64;  // rows of the sum, between which there is time to look up
  for (std::size_t first = 0; first < stride_; first += at_once) {
    if (poll_) poll_();
    kernels::add_lower_products(shape_.data(), load_.data(), stride_, rows_, first, std::min(first + at_once, stride_),
                                sum_.data());
  }
  rows_ = 0;
}

SymmetricProducts::Matrix SymmetricProducts::sum() {
  flush();
  const auto stride = static_cast<Eigen::Index>(stride_);
  const Eigen::Map<const Matrix> whole(sum_.data(), stride, stride);
  Matrix result = whole.topLeftCorner(size(), size()).triangularView<Eigen::Lower>();
  result.triangularView<Eigen::StrictlyUpper>() = result.transpose();
  return result;
}

}  // namespace stoss::numeric
