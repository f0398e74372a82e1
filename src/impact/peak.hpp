#pragma once

#include <algorithm>
#include <limits>

namespace stoss {

/// Maximum value of a smooth quantity that is sampled at equal times: the top of the parabola through the maximum
/// sample and its neighbours.
class Peak {
 public:
  void add(double sample) {
    if (before_ <= last_ && last_ > sample) {
      const double bend = before_ - 2.0 * last_ + sample, slope = sample - before_;
      top_ = std::max(top_, last_ - slope * slope / (8.0 * bend));
    }
    top_ = std::max(top_, sample);
    before_ = last_;
    last_ = sample;
  }

  /// `otherwise` if there was no sample.
  [[nodiscard]] double value(double otherwise) const { return top_ > lowest ? top_ : otherwise; }

 private:
  static constexpr double lowest = std::numeric_limits<double>::lowest();
  double before_ = std::numeric_limits<double>::infinity();  // so that a first sample is no top
  double last_ = std::numeric_limits<double>::infinity();
  double top_ = lowest;
};

}  // namespace stoss
