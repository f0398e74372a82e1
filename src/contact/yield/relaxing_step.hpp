#pragma once

#include <vector>

#include "stoss/contact/contact.hpp"

namespace stoss {

/// How materials that relax answer to a compression within a time step, to first order in what relaxes of two bodies:
///
///   f = ∫ E(t − s)/E(0) dc(s) + η dc/dt = answer · c − missing,
///
/// with what is missing known from before, c going straight from one step to the next.
class RelaxingStep {
 public:
  RelaxingStep(const Contact& contact, double step);

  /// Whether there is anything to answer for.
  [[nodiscard]] bool relaxes() const { return !branches_.empty() || lag_ > 0.0; }

  /// c before the step, and what has relaxed of it in each part of the modulus.
  struct Memory {
    double before = 0.0;
    std::vector<double> relaxed{};
  };

  [[nodiscard]] Memory none() const { return {0.0, std::vector<double>(branches_.size())}; }
  [[nodiscard]] double answer() const { return answer_; }
  [[nodiscard]] double missing(const Memory& memory) const;
  void keep(Memory& memory, double now) const;

 private:
  /// A part of the modulus: its share of E(0), what it keeps over a step, and the weights of c before and after the
  /// step in ∫ (1 − e^{−(t−s)/τ}) dc(s).
  struct Branch {
    double share, kept, begin, end;
  };

  std::vector<Branch> branches_;
  double lag_;  // η over the step
  double answer_ = 1.0;
};

}  // namespace stoss
