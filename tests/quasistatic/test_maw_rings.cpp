// Maw's oblique impact by Maw's own method, tractions on rings of a half-space: that the law of the contact is exact.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "stoss/quasistatic/oblique/maw.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

constexpr double pi = std::numbers::pi;

/// Displacement at r under unit pressure within b, E* = 1 (Johnson, eqs. 3.29).
double under_disk(double b, double r) {
  if (r <= b) return 4.0 * b / pi * boost::math::ellint_2(r / b);
  const double k = b / r;
  return 4.0 * r / pi * (boost::math::ellint_2(k) - (1.0 - k * k) * boost::math::ellint_1(k));
}

/// Rings of equal width up to the largest contact, of radius 1, with uniform traction, in steps √d = sin θ.
class Rings {
 public:
  explicit Rings(int count) : count_(count), flexibility_(count, count), area_(count) {
    for (int j = 0; j < count; ++j) {
      area_[j] = pi * (edge(j + 1) * edge(j + 1) - edge(j) * edge(j));
      for (int i = 0; i < count; ++i) {
        const double r = 0.5 * (edge(i) + edge(i + 1));
        flexibility_(i, j) = under_disk(edge(j + 1), r) - (j > 0 ? under_disk(edge(j), r) : 0.0);
      }
    }
  }

  /// ψ₂
  [[nodiscard]] double impact(double psi1, double chi) const {
    const int steps = 6 * count_;
    Eigen::VectorXd displaced = Eigen::VectorXd::Zero(count_);
    std::vector<int> slip(static_cast<std::size_t>(count_), 0);
    double velocity = psi1, share = std::min(psi1, 1.0), last_velocity = 1.0;
    for (int i = 1; i <= steps; ++i) {
      const double a = i < steps ? std::sin(pi * i / steps) : 0.0, middle = pi * (i - 0.5) / steps;
      const double speed = std::sqrt(1.0 - std::pow(a, 5)) * (2 * i < steps ? 1.0 : -1.0);
      const double rate =
          2.0 * std::sin(middle) * std::abs(std::cos(middle)) / std::sqrt(1.0 - std::pow(std::sin(middle), 5));
      const double kick = chi * (last_velocity - speed);
      velocity -= kick * share;
      displaced = flexibility_ * tractions(a, rate * velocity * pi / steps, displaced, slip, share);
      velocity -= kick * share;
      last_velocity = speed;
    }
    return velocity;
  }

 private:
  int count_;
  Eigen::MatrixXd flexibility_;
  Eigen::VectorXd area_;

  [[nodiscard]] double edge(int j) const { return static_cast<double>(j) / count_; }

  /// Mean of Hertz' pressure on a ring, 0 outside of the contact.
  [[nodiscard]] double pressure(int j, double a) const {
    const auto load = [a](double r) { return 4.0 / 3.0 * (a * a * a - std::pow(std::max(a * a - r * r, 0.0), 1.5)); };
    return (load(edge(j + 1)) - load(edge(j))) / area_[j];
  }

  /// After the bodies have moved along the wall: rings that stick have moved alike, others have the limit of friction
  /// against their slip. Active sets; `share` becomes T/N.
  [[nodiscard]] Eigen::VectorXd tractions(double a, double move, const Eigen::VectorXd& displaced,
                                          std::vector<int>& slip, double& share) const {
    Eigen::VectorXd traction = Eigen::VectorXd::Zero(count_);
    const int inside = std::min(count_, static_cast<int>(std::ceil(a * count_)));
    std::fill(slip.begin() + inside, slip.end(), 0);
    bool changed = inside > 0;
    for (int round = 0; changed && round < 100; ++round) {
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(inside, inside);
      Eigen::VectorXd right(inside);
      for (int j = 0; j < inside; ++j) {
        const int sign = slip[static_cast<std::size_t>(j)];
        if (sign == 0) matrix.row(j) = flexibility_.row(j).head(inside);
        right[j] = sign == 0 ? displaced[j] + move : sign * pressure(j, a);
      }
      traction.head(inside) = matrix.partialPivLu().solve(right);
      const Eigen::VectorXd slipped = (displaced - flexibility_ * traction).array() + move;
      changed = false;
      for (int j = 0; j < inside; ++j) {
        int& sign = slip[static_cast<std::size_t>(j)];
        const int before = sign;
        if (sign == 0) {
          if (std::abs(traction[j]) > pressure(j, a) * (1.0 + 1e-10)) sign = traction[j] > 0.0 ? 1 : -1;
        } else if (sign * slipped[j] < -1e-13) {
          sign = 0;
        }
        changed = changed || sign != before;
      }
    }
    EXPECT_FALSE(changed) << "the sets of rings that stick and slip cycle at a = " << a;
    if (inside > 0) share = traction.dot(area_) / (4.0 / 3.0 * a * a * a);
    return traction;
  }
};

TEST(MawRings, TendToTheExactContact) {
  // Their error falls as their width: extrapolated to none.
  constexpr double chi = 1.75 * 1.4 / 1.7;
  const Rings coarse(30), fine(60);
  for (const double psi1 : {0.5, 1.0, 2.0, 3.0, 4.0}) {
    const double first = coarse.impact(psi1, chi), second = fine.impact(psi1, chi), exact = maw(psi1, chi).psi2;
    EXPECT_NEAR(second, exact, 0.005) << psi1;
    EXPECT_NEAR(2.0 * second - first, exact, 0.001) << psi1;
  }
}

}  // namespace
}  // namespace stoss
