#include "bodies/sphere/legendre.hpp"

#include <cmath>

#include "numeric/bessel.hpp"

namespace stoss::bodies::sphere {

LegendreSequence::LegendreSequence(const Eigen::ArrayXd& angle)
    : fall_(2.0 * (0.5 * angle).sin().square()),
      value_(Eigen::ArrayXd::Ones(angle.size())),
      rise_(Eigen::ArrayXd::Zero(angle.size())),
      slope_(rise_),
      slope_below_(rise_) {}

void LegendreSequence::advance() {
  const double n = degree_++;
  slope_below_ += (2.0 * n + 1.0) * value_;
  slope_.swap(slope_below_);
  rise_ = (n * rise_ - (2.0 * n + 1.0) * fall_ * value_) / (n + 1.0);
  value_ += rise_;
}

LegendreOfRealDegree::LegendreOfRealDegree(const Eigen::ArrayXd& angle) : angle_(angle) {
  const Eigen::ArrayXd square = angle.square();
  zeroth_ = (angle / angle.sin()).sqrt();
  // (θ cot θ − 1)/8θ and [6θ cot θ − 15 + θ²(9/sin²θ − 1)]/128θ² in powers of θ.
  first_ = -zeroth_ * angle / 8.0 * (1.0 / 3.0 + square * (1.0 / 45.0 + square * (2.0 / 945.0 + square / 4725.0)));
  second_ = zeroth_ * square / 128.0 * (7.0 / 15.0 + square * (26.0 / 315.0 + square * (19.0 / 1575.0)));
}

Eigen::ArrayXd LegendreOfRealDegree::operator()(double degree) const {
  const double middle = degree + 0.5;
  Eigen::ArrayXd result(angle_.size());
  for (Eigen::Index i = 0; i < angle_.size(); ++i) {
    const double x = middle * angle_(i);
    const auto [j0, j1] = numeric::bessel_j01(x);
    const double j2 = x > 1e-3 ? 2.0 * j1 / x - j0 : 0.125 * x * x;
    result(i) = zeroth_(i) * j0 + (first_(i) * j1 + second_(i) * j2 / middle) / middle;
  }
  return result;
}

}  // namespace stoss::bodies::sphere
