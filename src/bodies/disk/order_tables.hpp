#pragma once

#include <cstddef>
#include <vector>

#include "bodies/residual.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::disk {

/// Σ cos kθ/k and Σ sin kθ/k.
struct HarmonicSums {
  double cosine = 0.0;
  double sine = 0.0;
};

/// Over k = 1 … N, the last term with weight ½, at θ = mπ/N, 0 ≤ m ≤ 2N. Error O(N⁻³).
[[nodiscard]] HarmonicSums harmonic_sums(std::size_t m, std::size_t highest);

/// Over all k, 0 < θ < 2π: −ln(2 sin ½θ) and ½(π − θ).
[[nodiscard]] HarmonicSums infinite_harmonic_sums(double theta);

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

/// Sums over the orders at the difference and at the sum of two angles.
struct PairSums {
  StaticSums apart, sum;
};

/// Σ_n R_n cos nθ for R^CC and R^SS and Σ_n R^CS_n sin nθ at the angles θ = mh, m < 2 · points: the sums over the
/// orders that equally spaced angles resolve, the last of them with weight ½.
class OrderTables {
 public:
  OrderTables(const OrderSum& sum, const ContactPoints& points, const Poll& poll);

  /// At the angles of two points, j ≤ i.
  [[nodiscard]] PairSums at(std::size_t i, std::size_t j) const { return {entry(i - j), entry(i + j + 1)}; }

 private:
  [[nodiscard]] StaticSums entry(std::size_t m) const { return {radial_[m], mixed_[m], tangential_[m]}; }
  void add_static(double poisson, double h);
  void add_orders(const std::vector<Flexibility>& coefficients, double h, const Poll& poll);

  std::vector<double> radial_, mixed_, tangential_;
};

/// The static flexibilities of all orders, summed between points on a smaller circle.
class MappedOrders {
 public:
  MappedOrders(double poisson, const ContactPoints& points);

  /// At the angles of two points, j ≤ i.
  [[nodiscard]] PairSums at(std::size_t i, std::size_t j) const;

  /// φ of a point.
  [[nodiscard]] double angle(std::size_t i) const { return angle_[i]; }

 private:
  /// @param m distance of the two points in spacings
  [[nodiscard]] StaticSums sums(std::size_t m, double theta, double stretch) const;

  StaticOrders orders_;
  std::size_t resolved_;  // on the circle of the points
  double highest_;        // on the edge, at the foremost point
  std::vector<double> angle_, stretch_;
  std::vector<HarmonicSums> lack_;
};

}  // namespace stoss::bodies::disk
