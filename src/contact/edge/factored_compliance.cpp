#include "contact/edge/factored_compliance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numeric/dense.hpp"
#include "numeric/kernels.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

// Products go in blocks, so that most of the zeros of the triangles are passed over, and to whole vectors, of which the
// excess is void.
constexpr std::size_t block = 32;
constexpr std::size_t vector = 8;

}  // namespace

FactoredCompliance::FactoredCompliance(std::vector<double> matrix, std::size_t size, const Poll& poll)
    : size_(size), matrix_(std::move(matrix)), band_(3 * size) {
  const auto n = static_cast<Eigen::Index>(size);
  Eigen::MatrixXd factor = numeric::dense::square(matrix_.data(), n, poll);
  const bool finite = std::all_of(matrix_.begin(), matrix_.end(), [](double w) { return std::isfinite(w); });
  if (!finite || !numeric::dense::factor(factor, poll)) {
    throw NotConverged("contact: the compliance between the nodes is not positive definite", "nodes",
                       "use fewer nodes");
  }
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = i - std::min<std::size_t>(i, 2); j <= i; ++j) {
      band_[3 * i + (i - j)] = factor(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
  }
  inverse_transposed_ = numeric::dense::zeros(size * size, poll);
  Eigen::Map<Eigen::MatrixXd> inverse(inverse_transposed_.data(), n, n);
  numeric::dense::invert_lower(factor, inverse, poll);
  inverse_ = numeric::dense::zeros(size * size, poll);
  numeric::dense::by_columns(n, poll, [&](Eigen::Index first, Eigen::Index count) {
    Eigen::Map<Matrix>(inverse_.data(), n, n).middleCols(first, count) = inverse.middleCols(first, count);
  });
}

Eigen::Map<const FactoredCompliance::Matrix> FactoredCompliance::matrix() const {
  const auto n = static_cast<Eigen::Index>(size_);
  return {matrix_.data(), n, n};
}

void FactoredCompliance::forward(std::size_t count, const std::vector<double>& q, std::vector<double>& y) const {
  const std::size_t end = std::min((count + vector - 1) / vector * vector, size_);
  for (std::size_t i = 0; i < end; i += block) {
    numeric::kernels::multiply_transposed(inverse_transposed_.data(), size_, std::min(count, i + block), i,
                                          std::min(end, i + block), q.data(), y.data());
  }
}

void FactoredCompliance::backward(std::size_t count, const std::vector<double>& y, std::vector<double>& f) const {
  const std::size_t end = std::min((count + vector - 1) / vector * vector, size_);
  for (std::size_t j = 0; j < end; j += block) {
    numeric::kernels::multiply_transposed(inverse_.data() + j * size_, size_, count - std::min(count, j), j,
                                          std::min(end, j + block), y.data() + j, f.data());
  }
}

void FactoredCompliance::multiply(std::size_t begin, std::size_t count, const std::vector<double>& x,
                                  std::vector<double>& result) const {
  numeric::kernels::multiply_transposed(matrix_.data(), size_, count, begin, size_, x.data(), result.data());
}

}  // namespace stoss
