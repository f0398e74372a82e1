#pragma once

namespace stoss::bodies {

/// Amplitudes of a displacement at a depth: u_z goes with the shape along the surface, cos kx or J₀(kr), and u_x, u_r
/// with sin kx or J₁(kr).
struct DepthProfile {
  double lateral;
  double normal;
};

}  // namespace stoss::bodies
