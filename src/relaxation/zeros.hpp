#pragma once

#include <cstddef>
#include <vector>

#include "stoss/relaxation.hpp"

namespace stoss {

/// A zero s = −rate of a + M with its slope, for inertia a.
struct RealZero {
  double rate;
  double slope;  ///< M′(−rate) = Σ e_j κ_j/(κ_j − rate)², with the digits of the differences
  double below;  ///< κ_j − rate, with its digits
};

/// The rates κ_j = 1/τ_j in rising order with their shares of E(0); terms of the same rate are one.
struct Rates {
  Rates() = default;
  explicit Rates(const Relaxation& relaxation);

  double relaxed = 1.0;  ///< E∞/E(0), above 0: what flows without end does so in 10¹² times its longest τ_j
  std::vector<double> rate, share;
  double viscous = 0.0;  ///< η/E(0) of a dashpot beside them: M + ηs
};

/// Layers that lose energy in different ways, as the rates of a mode that they share.
class MixedRates {
 public:
  /// @param unit of time of the losses, in that of the rates
  MixedRates(const std::vector<MaterialLoss>& layers, double unit);

  /// Rates of Σ weight_l (M_l + η_l s), whose moduli need not add up to 1. @param weight of each layer
  [[nodiscard]] Rates of(const double* weight) const;

  /// The most rates that a mode has.
  [[nodiscard]] std::size_t terms() const { return terms_.size(); }

 private:
  struct Term {
    double rate;
    std::size_t layer;
    double share;
  };
  std::vector<Term> terms_;                // in rising order of the rates
  std::vector<double> relaxed_, viscous_;  // of each layer
};

/// One real zero of M(s) + s² inertia in each interval between 0 and the poles −κ_j of M: there it falls from its
/// greatest to its least value. In an interval with three of them, any. @param inertia 1/ω² of a mode, 0 for M itself
[[nodiscard]] std::vector<RealZero> real_zeros(const Rates& rates, double inertia);

/// M′(−rate) away from all κ_j.
[[nodiscard]] double modulus_slope(const Rates& rates, double rate);

}  // namespace stoss
