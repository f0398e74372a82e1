#include "contact/edge/kept_factor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numeric/kernels.hpp"

namespace stoss {

namespace kernels = numeric::kernels;

namespace {

std::size_t whole(std::size_t count) { return (count + kernels::lanes - 1) / kernels::lanes * kernels::lanes; }

}  // namespace

KeptFactor::KeptFactor(std::shared_ptr<const FactoredCompliance> compliance)
    : compliance_(std::move(compliance)),
      size_(compliance_->size()),
      stride_(whole(size_)),
      lower_(size_ * stride_),
      inverse_(size_ * stride_),
      inverse_transposed_(size_ * stride_),
      known_(size_),
      diagonal_(size_),
      left_(size_),
      row_(stride_) {}

void KeptFactor::give_up(std::size_t count) {
  if (count >= kept_) return;
  kept_ = count;
  for (std::size_t& each : known_) each = std::min(each, count);
}

void KeptFactor::extend(std::size_t i) {
  constexpr std::size_t few = 3;
  if (known_[i] == kept_) return;
  const double* const w = compliance_->matrix().data() + i * size_;
  double* const row = lower_.data() + i * stride_;
  if (kept_ - known_[i] > few) {
    kernels::multiply_transposed(inverse_transposed_.data(), stride_, kept_, 0, whole(kept_), w, row);
  } else {
    for (std::size_t j = known_[i]; j < kept_; ++j) row[j] = kernels::dot(inverse_.data() + j * stride_, w, j + 1);
  }
  known_[i] = kept_;
}

bool KeptFactor::add(double diagonal) {
  const std::size_t i = kept_;
  extend(i);
  const double* const row = lower_.data() + i * stride_;
  const double left = compliance_->matrix().data()[i * size_ + i] - kernels::dot(row, row, i);
  const double square = left + diagonal;
  if (!(square > 0.0) || !std::isfinite(square)) return false;
  diagonal_[i] = diagonal, left_[i] = left;
  const double reciprocal = 1.0 / std::sqrt(square);
  if (i > 0) kernels::multiply_transposed(inverse_.data(), stride_, i, 0, whole(i), row, row_.data());
  double* const inverse = inverse_.data() + i * stride_;
  for (std::size_t j = 0; j < i; ++j) {
    inverse[j] = -row_[j] * reciprocal;
    inverse_transposed_[j * stride_ + i] = inverse[j];
  }
  inverse[i] = inverse_transposed_[i * stride_ + i] = reciprocal;
  ++kept_;
  return true;
}

void KeptFactor::remainder(std::size_t end, std::vector<double>& matrix) {
  const double* const w = compliance_->matrix().data();
  const std::size_t count = end - kept_;
  matrix.resize(count * count);
  for (std::size_t a = 0; a < count; ++a) {
    const std::size_t i = kept_ + a;
    extend(i);
    for (std::size_t b = 0; b <= a; ++b) {
      const double* const other = lower_.data() + (kept_ + b) * stride_;
      matrix[a * count + b] = w[i * size_ + kept_ + b] - kernels::dot(lower_.data() + i * stride_, other, kept_);
    }
  }
}

void KeptFactor::forward(std::size_t end, const std::vector<double>& x, std::vector<double>& y) const {
  kernels::multiply_transposed(inverse_transposed_.data(), stride_, kept_, 0, whole(kept_), x.data(), y.data());
  for (std::size_t i = kept_; i < end; ++i) {
    y[i] = x[i] - kernels::dot(lower_.data() + i * stride_, y.data(), kept_);
  }
}

void KeptFactor::backward(std::size_t end, std::vector<double>& y, std::vector<double>& x) const {
  kernels::take_transposed(lower_.data() + kept_ * stride_, stride_, end - kept_, kept_, x.data() + kept_, y.data());
  kernels::multiply_transposed(inverse_.data(), stride_, kept_, 0, kept_, y.data(), x.data());
}

}  // namespace stoss
