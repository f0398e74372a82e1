#pragma once

#include <span>
#include <vector>

#include "bodies/kept_profiles.hpp"
#include "stoss/bodies/disk/modes.hpp"

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

/// Displacement and stress of a free vibration inside the disk. With the potentials β = A J_n(κr), β′ = B J_n(κ′r),
/// their slopes α = rβ_r = nβ − γ (paper eq. (19)), M = n(n−1) and y = κ′²r²/2,
///
///   r u_r = n(β + β′) − γ             (1+ν) r² σ_rr  =  M(β + β′) − yβ + γ − nγ′
///   r u_φ = γ′ − n(β + β′)            (1+ν) r² σ_rφ  = −M(β + β′) + yβ′ + nγ − γ′
///                                     (1+ν) r² σ_φφ  = −M(β + β′) − νyβ − γ + nγ′
///
/// where σ_rr + σ_φφ = div u/(1−ν), div u = −κ²β. The tractions are those of EdgeProblem with κr for κ. In this form
/// what is large for n ≫ κ′r occurs only in the one sum β + β′, and every term vanishes at the centre as the whole
/// does.
/// @param radii 0 … 1; the centre by its limit
/// @throws InvalidInput for a Poisson's ratio, a mode or a radius out of range
[[nodiscard]] std::vector<RadialField> mode_field(double poisson, const Mode& mode, std::span<const double> radii,
                                                  const Poll& poll);

}  // namespace stoss::bodies::disk
