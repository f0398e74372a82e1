#pragma once

#include <cmath>

#include "stoss/quasistatic/hertz.hpp"

namespace stoss::test {

/// Contact of a disk with the wall on which it stands in a gravitational field.
enum class HeavyDiskContact {
  point,  ///< on one point: exact (Michell)
  hertz   ///< on a Hertz contact of half-width 2√F: the paper's superposition, for small F
};

/// Stress in a disk that stands on a wall under its weight F = ρgR/E (in πRE), E; a disk that the force accelerates has
/// the same. The origin is the point of contact, x points through the centre (1, 0), y along the wall:
///
///   σ = σ_contact + F (½x, 1 − ½x, ½y)    for (xx, yy, xy): gravity (paper eq. (49)) and a tension of ½F
///   σ_contact = −2F x/(x²+y²)² (x², y², xy)   point: a radial stress −2F cos φ/r (paper eq. (50))
///             = hertz_stress                  hertz (paper section V)
///
/// div σ = (F, 0). With the point contact all components vanish on the whole edge. With Hertz' contact the edge keeps
/// tractions that should not be there: F²/(1 − cos φ) at most at the angle φ from the contact, a share F of what the
/// load makes there; and up to 0.7 F^¾ next to its ends, where the edge has left the surface of the half-plane by ½a².
inline quasistatic::PlaneStress heavy_disk_stress(HeavyDiskContact contact, double force, double x, double y) {
  quasistatic::PlaneStress stress;
  if (contact == HeavyDiskContact::point) {
    const double r = std::hypot(x, y), c = x / r, s = y / r;
    const double radial = -2.0 * force * c / r;
    stress = {radial * c * c, radial * s * s, radial * c * s};
  } else {
    stress = quasistatic::hertz_stress(force, std::fmax(x, 0.0), y);
  }
  stress.xx += 0.5 * force * x;
  stress.yy += force * (1.0 - 0.5 * x);
  stress.xy += 0.5 * force * y;
  return stress;
}

}  // namespace stoss::test
