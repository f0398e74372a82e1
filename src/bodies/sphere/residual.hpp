#pragma once

#include <vector>

#include "bodies/kept_sums.hpp"
#include "bodies/sphere/degree_sums.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies::sphere {

/// Static response of the modes of a sphere that are not kept, between rings.
class Residual {
 public:
  /// @param kept modes, sorted by degree
  Residual(double poisson, double cutoff, const std::vector<Mode>& kept);

  /// W_ij: the DegreeSum of R_n = Σ_{not kept} (U,V)(U,V)ᵀ/ω².
  [[nodiscard]] std::vector<double> compliance(const ContactPoints& points, const Poll& poll = {}) const;

  /// V_ij: the same with ω⁴ for ω². Degrees that follow any force that the time steps can resolve are left out.
  [[nodiscard]] std::vector<double> second_moment(const ContactPoints& points, const Poll& poll = {}) const;

  /// Δt for which Δt² Σ_kept U² = 0.9 R^UU in the worst degree: half of what a disk is allowed, because rings also feel
  /// V. Above 1.8 the edge of the contact chatters (ν = 0.49, ω_c = 256).
  [[nodiscard]] double stable_step() const;

 private:
  double poisson_;
  int highest_degree_;  // in the second moment
  KeptSums<Mode, Flexibility> kept_;
};

}  // namespace stoss::bodies::sphere
