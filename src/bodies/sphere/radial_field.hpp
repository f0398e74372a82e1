#pragma once

#include <span>
#include <vector>

#include "bodies/kept_profiles.hpp"
#include "stoss/bodies/sphere/modes.hpp"

namespace stoss::bodies::sphere {

/// Displacement and stress of one degree n at one radius, E = 1. With P = P_n(cos θ), P′ = dP/dθ, L = n(n+1) and
/// H = P + cot θ P′ (0 for n = 1),
///
///   u_r = radial · P         σ_rr = stress_rr · P         σ_φφ = hoop · P + bend · H
///   u_θ = tangential · P′    σ_rθ = stress_rt · P′        σ_θθ = hoop · P − bend · [(L−2) P + H]
struct RadialField {
  double radial = 0.0;
  double tangential = 0.0;
  double stress_rr = 0.0;
  double stress_rt = 0.0;
  double hoop = 0.0;  ///< λ div u + 2μ (u_r − u_θ)/r
  double bend = 0.0;  ///< 2μ u_θ/r; 0 for n = 1, where H = 0
};

/// Static field of a sphere under the surface tractions σ_rr = p P_n and σ_rθ = t dP_n/dθ (docs/theory/spheres.md), for
/// n = 1 with inertia relief: the sphere accelerates, its centre of mass stays.
///
///   u = low r^{n−1} + high r^{n+1},   σ = below (r^{n−2} − r^n) + edge r^n
///
/// for each component. In the stresses the powers r^{n−2} and r^n have large factors, which cancel at the surface; this
/// form has no such difference.
struct StaticField {
  double radial_low = 0.0, radial_high = 0.0;
  double tangential_low = 0.0, tangential_high = 0.0;
  double rr_below = 0.0, rr_edge = 0.0;
  double rt_below = 0.0, rt_edge = 0.0;
  double hoop_below = 0.0, hoop_edge = 0.0;
  double bend_below = 0.0, bend_edge = 0.0;

  [[nodiscard]] RadialField at(const RadialPowers& power) const {
    return {
        radial_low * power.low + radial_high * power.high, tangential_low * power.low + tangential_high * power.high,
        rr_below * power.below + rr_edge * power.here,     rt_below * power.below + rt_edge * power.here,
        hoop_below * power.below + hoop_edge * power.here, bend_below * power.below + bend_edge * power.here};
  }
};

/// The field for the tractions p = normal and t = shear (of no effect for n = 0), in E.
[[nodiscard]] StaticField static_field(double poisson, int order, double normal, double shear);

/// Displacement and stress of a free vibration inside the sphere: the formulas of EdgeProblem with κr for κ and, at
/// r = 0, their limits.
/// @param radii 0 … 1
/// @throws InvalidInput for a Poisson's ratio, a mode or a radius out of range
[[nodiscard]] std::vector<RadialField> mode_field(double poisson, const Mode& mode, std::span<const double> radii,
                                                  const Poll& poll);

}  // namespace stoss::bodies::sphere
