#include "numeric/symmetric_products.hpp"

#include <algorithm>

#include "numeric/dense.hpp"
#include "numeric/kernels.hpp"

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
