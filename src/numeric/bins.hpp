#pragma once

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace stoss::numeric {

/// Finds the interval x_k … x_{k+1} of a place by bins of equal width, as many as there are intervals: it is that in
/// which the bin begins, or one of the next.
class Bins {
 public:
  /// @param x rising, two or more
  explicit Bins(std::vector<double> x) : x_(std::move(x)), begin_(x_.front()) {
    constexpr double rounding = 1e-6;  // of a bin: it begins no later than a place that is found in it
    const std::size_t intervals = x_.size() - 1;
    per_unit_ = static_cast<double>(intervals) / (x_.back() - begin_);
    for (std::size_t k = 0; k < intervals; ++k) ends_.push_back(x_[k + 1]);
    ends_.back() = std::numeric_limits<double>::infinity();
    std::size_t k = 0;
    for (std::size_t bin = 0; bin <= intervals + 1; ++bin) {
      const double begin = begin_ + (static_cast<double>(bin) - rounding) / per_unit_;
      while (ends_[k] <= begin) ++k;
      first_.push_back(k);
    }
  }

  /// k of a place between the first and the last x, but for rounding.
  [[nodiscard]] std::size_t interval(double at) const {
    std::size_t k = first_[static_cast<std::size_t>(static_cast<int>((at - begin_) * per_unit_))];
    while (at >= ends_[k]) ++k;
    return k;
  }

  [[nodiscard]] const std::vector<double>& x() const { return x_; }

  [[nodiscard]] double per_unit() const { return per_unit_; }

  /// Interval in which each bin begins.
  [[nodiscard]] const std::vector<std::size_t>& first() const { return first_; }

 private:
  std::vector<double> x_;
  double begin_, per_unit_ = 0.0;
  std::vector<double> ends_{};  ///< of the intervals; the last is infinite
  std::vector<std::size_t> first_{};
};

}  // namespace stoss::numeric
