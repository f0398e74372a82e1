#pragma once

#include <cstddef>
#include <vector>

#include "bodies/disk/harmonic_sums.hpp"
#include "bodies/residual.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::disk {

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
