#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "bodies/residual.hpp"
#include "bodies/sphere/legendre.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::sphere {

/// static_flexibility for n ≥ 2 as a function of a real degree.
[[nodiscard]] inline Flexibility flexibility_of_degree(double poisson, double n) {
  const double factor =
      (2.0 * n + 1.0) / 3.0 * (1.0 + poisson) / ((n - 1.0) * (n * n + n + 1.0 + (2.0 * n + 1.0) * poisson));
  return {factor * (2.0 * n * n - 1.0 - poisson * (2.0 * n * n - n - 2.0)),
          factor * (2.0 - n + poisson * (2.0 * n - 1.0)),
          factor * (2.0 * n * n - n + 1.0 - poisson * (2.0 * n * n - 3.0 * n - 1.0)) / (n * (n + 1.0))};
}

/// What is summed over the degrees of a sphere: along its axis, or along y with the coefficients R^WW of toroidal
/// modes, or along its axis and out from it.
struct DegreeSum : OrderSum {
  bool along = false;
  std::vector<double> toroidal{};  ///< as `coefficients`
  bool outward = false;
};

/// A response between rings as a sum over the degrees,
///
///   (1/m) Σ_n [R^UU a_i a_j − R^UV (a_i b_j + b_i a_j) + R^VV b_i b_j],   a = cos θ P_n,   b = sin θ dP_n/dθ,
///
/// over those that the rings resolve, n ≤ N = π/h, the last with weight ½: a matrix, rings × rings, symmetric.
///
/// Low degrees are added up one by one. Where there are many more than rings, the higher ones go by Gauss quadrature of
/// a sum over blocks of degrees, in which the products turn by at most 18 to either side: an error of 1e-14, and as
/// many terms for any N.
///
/// Along y the rows are the means over rings of what moves along y: −√(L/2)/(2n+1) (P_{n+1} − P_{n−1}) for a,
/// −√(L/2)/(2n+1) [n P_{n+1} + (n+1) P_{n−1}] for b and √(L/2) P_n for R^WW; n = 0 has none.
///
/// Outward the rows are twice as long: those of the axis, then sin θ P_n for a and −cos θ dP_n/dθ for b.
[[nodiscard]] std::vector<double> sum_over_degrees(const DegreeSum& sum, const ContactPoints& points, const Poll& poll);

/// Weights of a degree n ≥ 1 on the rows P_{n+1} and P_{n−1} where rings move along y, over those along the axis.
struct AlongShare {
  double upper, lower;
};
[[nodiscard]] inline AlongShare along_share(double n) {
  return {-std::sqrt(n / (2.0 * (n + 1.0))), std::sqrt((n + 1.0) / (2.0 * n))};
}

/// Softness of the surface along itself, (1+ν)(2−ν)/2, against 1 − ν² along the normal: of forces along y on rings,
/// the mean over the ring (Cerruti).
[[nodiscard]] inline double softness_along(double poisson) { return 0.5 * (1.0 + poisson) * (2.0 - poisson); }

/// What tells the residual response of a sphere from that of other round bodies.
struct ResidualShape {
  /// Half of what a disk is allowed, because rings also feel V. Above 1.8 the edge of the contact chatters (ν = 0.49,
  /// ω_c = 256).
  static constexpr double stable_share = 0.9;

  static Flexibility static_flexibility(double poisson, int n) { return sphere::static_flexibility(poisson, n); }
  static Flexibility static_second_moment(double poisson, int n) { return sphere::static_second_moment(poisson, n); }
  static std::vector<double> sum(const OrderSum& sum, const ContactPoints& points, const Poll& poll) {
    return sum_over_degrees({sum}, points, poll);
  }
  static constexpr double mass = 4.0 * std::numbers::pi / 3.0;

  /// a and −b of each ring.
  class Loads {
   public:
    explicit Loads(const ContactPoints& points);
    [[nodiscard]] double radial(std::size_t ring) const { return at(cosine_, sequence_.value(), ring); }
    [[nodiscard]] double tangential(std::size_t ring) const { return at(square_, sequence_.slope(), ring); }
    void advance() { sequence_.advance(); }

   private:
    static double at(const Eigen::ArrayXd& one, const Eigen::ArrayXd& other, std::size_t ring) {
      const auto i = static_cast<Eigen::Index>(ring);
      return one(i) * other(i);
    }

    Eigen::ArrayXd cosine_, square_;  // cos θ, sin² θ
    LegendreSequence sequence_;
  };
};

using Residual = bodies::Residual<ResidualShape>;

}  // namespace stoss::bodies::sphere
