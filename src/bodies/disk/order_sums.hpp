#pragma once

#include <numbers>
#include <vector>

#include "stoss/bodies/disk/modes.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::disk {

/// Mass of a disk.
inline constexpr double mass = std::numbers::pi;

/// A response between points of the edge as a sum over the angular orders,
///
///   (1/m) Σ_n [R^CC c_i c_j + R^CS (c_i s_j + s_i c_j) + R^SS s_i s_j],   c = cos nφ cos φ,   s = −sin nφ sin φ,
///
/// over the orders that the points resolve, n ≤ N, the last with weight ½. R_n are the given coefficients and, where
/// `with_static`, the static flexibilities of all orders, whose sums are closed.
struct OrderSum {
  double poisson = 0.0;
  bool with_static = false;
  std::vector<Flexibility> coefficients;  ///< of n = 0, 1, 2, …
};

/// At equally spaced angles, N = π/h: cos nφ_i cos nφ_j = ½[cos n(φ_i−φ_j) + cos n(φ_i+φ_j)] and similar identities
/// reduce the double sums over orders and points to three one-dimensional tables.
[[nodiscard]] std::vector<double> sum_at_equal_angles(const OrderSum& sum, const ContactPoints& points,
                                                      const Poll& poll);

/// At points that lie equally spaced on a smaller circle, N = π/(h dφ/dα).
[[nodiscard]] std::vector<double> sum_at_mapped_angles(const OrderSum& sum, const ContactPoints& points,
                                                       const Poll& poll);

/// Σ_n R^CC cos nθ, Σ_n R^CS sin nθ and Σ_n R^SS cos nθ of the static flexibilities.
struct StaticSums {
  double radial = 0.0;
  double mixed = 0.0;
  double tangential = 0.0;
};

/// The static sums from those of the harmonics: with partial fractions in n they consist of Σ cos kθ/k and Σ sin kθ/k.
class StaticOrders {
 public:
  explicit StaticOrders(double poisson);

  /// @param cosine_sum, sine_sum Σ cos kθ/k and Σ sin kθ/k up to the order N, the last with weight ½
  /// @param last ½ cos Nθ, the share of the last order; 0 for sums over all orders
  [[nodiscard]] StaticSums at(double theta, double cosine_sum, double sine_sum, double last, double highest) const;

 private:
  Flexibility zero_, one_;
  double low_, high_;  // n ≥ 2: F^CC = F^SS = low/(n−1) + high/(n+1), F^CS = −low/(n−1) + high/(n+1)
};

}  // namespace stoss::bodies::disk
