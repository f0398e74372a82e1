#pragma once

#include "bodies/disk/radial_field.hpp"

namespace stoss::bodies::disk {

/// r^{n−2} − r^n, r^{n−1}, r^n and r^{n+1}, with 0 for a negative power.
struct RadialPowers {
  double below, low, here, high;
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
