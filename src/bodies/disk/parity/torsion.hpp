#pragma once

#include <vector>

namespace stoss::bodies::disk {

/// The vibrations of a free disk with u_r = 0 and u_φ = J₁(kr)/J₁(k) at all angles, scaled as bodies::Mode: modal mass
/// that of the disk, amplitude 1 at the edge. They are free of stress there where J₂(k) = 0, and ω = k c_S.
class Torsion {
 public:
  /// Those up to a cutoff.
  Torsion(double poisson, double cutoff);

  [[nodiscard]] const std::vector<double>& omega() const { return omega_; }

  /// Σ 1/ω² over those beyond the cutoff: over all of them it is the static flexibility (1 + ν)/6, without the rotation
  /// of the disk.
  [[nodiscard]] double missing_compliance() const { return missing_compliance_; }

  /// Σ 1/ω⁴ over the same; over all of them (1 + ν)²/144.
  [[nodiscard]] double missing_second_moment() const { return missing_second_moment_; }

 private:
  std::vector<double> omega_;
  double missing_compliance_, missing_second_moment_;
};

}  // namespace stoss::bodies::disk
