#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "bodies/residual.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::disk {

/// A response between points of the edge as a sum over the angular orders,
///
///   (1/m) Σ_n [R^CC c_i c_j + R^CS (c_i s_j + s_i c_j) + R^SS s_i s_j],   c = cos nφ cos φ,   s = −sin nφ sin φ,
///
/// over the orders that the points resolve, n ≤ N, the last with weight ½. The sums of the static flexibilities are
/// closed.
///
/// At equally spaced angles, N = π/h: cos nφ_i cos nφ_j = ½[cos n(φ_i−φ_j) + cos n(φ_i+φ_j)] and similar identities
/// reduce the double sums over orders and points to three one-dimensional tables. At points that lie equally spaced on
/// a smaller circle, N = π/(h dφ/dα).
[[nodiscard]] std::vector<double> sum_over_orders(const OrderSum& sum, const ContactPoints& points, const Poll& poll);

/// What tells the residual response of a disk from that of other round bodies.
struct ResidualShape {
  /// A single order at a rigid wall is unstable from 4 on; on a grid, which mixes the orders, trouble begins above 2
  /// (docs/developer/numerics.md).
  static constexpr double stable_share = 1.8;

  static Flexibility static_flexibility(double poisson, int n) { return disk::static_flexibility(poisson, n); }
  static Flexibility static_second_moment(double poisson, int n) { return disk::static_second_moment(poisson, n); }
  static std::vector<double> sum(const OrderSum& sum, const ContactPoints& points, const Poll& poll) {
    return sum_over_orders(sum, points, poll);
  }
  static constexpr double mass = std::numbers::pi;

  /// c and s of each point.
  class Loads {
   public:
    explicit Loads(const ContactPoints& points);
    [[nodiscard]] double radial(std::size_t point) const { return std::cos(order_ * angle_[point]) * cosine_[point]; }
    [[nodiscard]] double tangential(std::size_t point) const {
      return -std::sin(order_ * angle_[point]) * sine_[point];
    }
    void advance() { order_ += 1.0; }

   private:
    double order_ = 0.0;
    std::vector<double> angle_, cosine_, sine_;
  };
};

using Residual = bodies::Residual<ResidualShape>;

}  // namespace stoss::bodies::disk
