#pragma once

#include <cmath>
#include <vector>

#include "bodies/kept_sums.hpp"
#include "stoss/bodies/round.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies {

/// What is summed over the orders for a response between contact points: coefficients of the orders 0, 1, 2, … and,
/// where `with_static`, the static flexibilities of all orders.
struct OrderSum {
  double poisson = 0.0;
  bool with_static = false;
  std::vector<Flexibility> coefficients;
};

/// Static response of the modes of a disk or a sphere that are not kept, between contact points.
/// @tparam Shape tells the two apart: its static_flexibility and static_second_moment of an order, its `sum` over the
///               orders, and its stable_share
template <typename Shape>
class Residual {
 public:
  /// @param kept modes, sorted by order
  Residual(double poisson, double cutoff, const std::vector<Mode>& kept)
      : poisson_(poisson), highest_order_(static_cast<int>(std::lround(8.0 * cutoff))), kept_(kept) {}

  /// W_ij: the sum of R_n = Σ_{not kept} (radial, tangential)(radial, tangential)ᵀ/ω².
  [[nodiscard]] std::vector<double> compliance(const ContactPoints& points, const Poll& poll = {}) const {
    return Shape::sum({poisson_, true, kept_.missing_compliance()}, points, poll);
  }

  /// V_ij: the same with ω⁴ for ω². Orders that follow any force that the time steps can resolve are left out.
  [[nodiscard]] std::vector<double> second_moment(const ContactPoints& points, const Poll& poll = {}) const {
    const auto whole = [this](int n) { return Shape::static_second_moment(poisson_, n); };
    return Shape::sum({poisson_, false, kept_.remaining_second_moment(highest_order_, whole)}, points, poll);
  }

  /// Δt for which Δt² Σ_kept radial² is a share of the radial R_n in the worst order.
  [[nodiscard]] double stable_step() const {
    return kept_.stable_step(Shape::stable_share, [this](int n) { return Shape::static_flexibility(poisson_, n); });
  }

 private:
  double poisson_;
  int highest_order_;  // in the second moment
  KeptSums kept_;
};

}  // namespace stoss::bodies
