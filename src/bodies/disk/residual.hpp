#pragma once

#include <vector>

#include "bodies/disk/order_sums.hpp"
#include "bodies/kept_sums.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies::disk {

/// Static response of the modes of a disk that are not kept, between contact points.
class Residual {
 public:
  /// @param kept modes, sorted by order
  Residual(double poisson, double cutoff, const std::vector<Mode>& kept);

  /// W_ij: the OrderSum of R_n = Σ_{not kept} (C,S)(C,S)ᵀ/ω².
  [[nodiscard]] std::vector<double> compliance(const ContactPoints& points, const Poll& poll = {}) const;

  /// V_ij: the same with ω⁴ for ω². Orders that follow any force that the time steps can resolve are left out.
  [[nodiscard]] std::vector<double> second_moment(const ContactPoints& points, const Poll& poll = {}) const;

  /// Δt for which Δt² Σ_kept C² = 1.8 R^CC in the worst order. A single order at a rigid wall is unstable from 4 on; on
  /// a grid, which mixes the orders, trouble begins above 2 (docs/numerics.md).
  [[nodiscard]] double stable_step() const;

 private:
  double poisson_;
  int highest_order_;  // in the second moment
  KeptSums<Mode, Flexibility> kept_;
};

}  // namespace stoss::bodies::disk
