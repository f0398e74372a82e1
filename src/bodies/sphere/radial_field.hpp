#pragma once

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

}  // namespace stoss::bodies::sphere
