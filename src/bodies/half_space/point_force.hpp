#pragma once

#include <vector>

#include "bodies/half_space/lamb_kernel.hpp"

namespace stoss::bodies::half_space {

/// Displacement of a half-space at a point: into the depth, and away from the axis.
struct Displaced {
  double normal = 0.0, radial = 0.0;
};

/// The answer of a half-space at one point to a normal force of 1 on a point of its surface that acts from t = 0 on, in
/// units of μ and c_s (docs/theory/half_space.md).
///
/// Inside, by Cagniard's and de Hoop's method (L. R. Johnson, Geophys. J. R. Astron. Soc. 37, 99, 1974): with the
/// slownesses q along the surface and p across, ξ² = p² − q² and η_c = √(1/c² + ξ²), the waves P and S each give
///
///   G = 1/(π²R) ∫₀^{π/2} Re{f η} dφ,   q = (t r + i z √(t² − R²(1/c² + p²)))/R²,   p = √(t²/R² − 1/c²) sin φ,
///
/// f_P = (η_p, q)(2ξ² + 1)/Δ, f_S = −(2ξ² η_p, 2q η_p η_s)/Δ, Δ = (2ξ² + 1)² − 4ξ² η_p η_s, and S also the head wave,
/// with real q. On the surface the integral over the wave number of the oscillators of Lamb's kernel is known, ∫J₀(kr)
/// cos(kxt) dk = 1/√(r² − x²t²), and one over their speeds x is left: that of C. L. Pekeris (1955) and C. C. Chao
/// (1960).
class PointForce {
 public:
  /// @param distance, depth ≥ 0, not both 0
  PointForce(double poisson, double distance, double depth);

  /// @param time at which no wave front just arrives
  [[nodiscard]] Displaced at(double time) const;

  /// Instants at which the answer has a kink or is singular, ascending; before the first it is 0.
  [[nodiscard]] const std::vector<double>& arrivals() const { return arrivals_; }

  /// For long afterwards: J. Boussinesq's answer (1885).
  [[nodiscard]] Displaced at_rest() const;

 private:
  [[nodiscard]] Displaced on_surface(double time) const;
  [[nodiscard]] Displaced of_front(double time, bool shear) const;
  [[nodiscard]] Displaced of_head_wave(double time) const;

  LambKernel kernel_;
  double distance_, depth_, range_;
  double slowness_;         ///< of pressure waves, √η̂
  double radial_weight_;    ///< of the Rayleigh wave in the radial answer
  double head_ = -1.0;      ///< arrival of the head wave; below 0: there is none
  double head_end_ = -1.0;  ///< when it has passed
  std::vector<double> arrivals_;
};

}  // namespace stoss::bodies::half_space
