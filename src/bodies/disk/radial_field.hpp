#pragma once

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

}  // namespace stoss::bodies::disk
