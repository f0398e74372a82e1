#pragma once

#include <Eigen/Core>

namespace stoss::bodies::sphere {

/// P_n(cos θ) at fixed angles for n = 0, 1, 2, …, by the recurrence of their differences
///
///   (n+1)(P_{n+1} − P_n) = n (P_n − P_{n−1}) − (2n+1) 2 sin²(θ/2) P_n,
///
/// which is good to rounding at the smallest angles too.
class LegendreSequence {
 public:
  explicit LegendreSequence(const Eigen::ArrayXd& angle);

  /// P_n of the present n, from 0.
  [[nodiscard]] const Eigen::ArrayXd& value() const { return value_; }
  [[nodiscard]] int degree() const { return degree_; }

  /// dP_n/dx at x = cos θ, by P_{n+1}' = P_{n−1}' + (2n+1) P_n.
  [[nodiscard]] const Eigen::ArrayXd& slope() const { return slope_; }

  /// Goes on to n + 1.
  void advance();

 private:
  Eigen::ArrayXd fall_;  // 2 sin²(θ/2)
  Eigen::ArrayXd value_, rise_;
  Eigen::ArrayXd slope_, slope_below_;
  int degree_ = 0;
};

/// P_ν(cos θ) at small angles, 0 < θ ≤ 0.1, for any real degree ν ≥ 32: three terms of the expansion in Bessel
/// functions of Bogaert, Michiels and Fostier (SIAM J. Sci. Comput. 34, C83, 2012). Absolute error below 1e-4 (θ/ν)³ +
/// 1e-15.
class LegendreOfRealDegree {
 public:
  explicit LegendreOfRealDegree(const Eigen::ArrayXd& angle);

  [[nodiscard]] Eigen::ArrayXd operator()(double degree) const;

 private:
  Eigen::ArrayXd angle_, zeroth_, first_, second_;  // θ and the factors of J_0, J_1/(ν+½), J_2/(ν+½)²
};

}  // namespace stoss::bodies::sphere
