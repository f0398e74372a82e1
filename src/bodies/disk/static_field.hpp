#pragma once

#include "bodies/radial_powers.hpp"

namespace stoss::bodies::disk {

/// Displacement and stress of one angular order n at one radius, E = 1: `radial`, `stress_rr` and `stress_pp` are to be
/// multiplied by cos nφ, `tangential` and `stress_rp` by sin nφ.
struct RadialField {
  double radial = 0.0;      ///< u_r
  double tangential = 0.0;  ///< u_φ
  double stress_rr = 0.0;   ///< σ_rr
  double stress_pp = 0.0;   ///< σ_φφ
  double stress_rp = 0.0;   ///< σ_rφ
};

/// Static field of a disk under the edge tractions σ_rr = p cos nφ and σ_rφ = t sin nφ (Michell's solution;
/// docs/theory/modes.md), for n = 1 with inertia relief: the disk accelerates by p − t, its centre of mass stays.
///
///   u = low r^{n−1} + high r^{n+1},   σ = below (r^{n−2} − r^n) + edge r^n
///
/// for each component. In the stresses the powers r^{n−2} and r^n have factors of order n, which cancel at the edge;
/// this form has no such difference.
struct StaticField {
  double radial_low = 0.0, radial_high = 0.0;
  double tangential_low = 0.0, tangential_high = 0.0;
  double rr_below = 0.0, rr_edge = 0.0;
  double pp_below = 0.0, pp_edge = 0.0;
  double rp_below = 0.0, rp_edge = 0.0;

  [[nodiscard]] RadialField at(const RadialPowers& power) const {
    return {radial_low * power.low + radial_high * power.high,
            tangential_low * power.low + tangential_high * power.high, rr_below * power.below + rr_edge * power.here,
            pp_below * power.below + pp_edge * power.here, rp_below * power.below + rp_edge * power.here};
  }
};

/// The field for the tractions p = normal and t = shear (of no effect for n = 0), in E.
[[nodiscard]] StaticField static_field(double poisson, int order, double normal, double shear);

}  // namespace stoss::bodies::disk
