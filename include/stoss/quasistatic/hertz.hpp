#pragma once

#include "stoss/cxx20.hpp"

namespace stoss::quasistatic {

/// Maximum force for which Hertz' contact is evaluated, πRE: its half-width is the radius. It is meant for much less.
inline constexpr double max_hertz_force = 0.25;

/// Stress in the plane, E; tension is positive.
struct PlaneStress {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
};

/// Half-width of the contact of a disk with a wall, R: a = 2√F (paper section V, a² = 4PR/πE).
/// @param force F, 0 … 0.25 πRE
/// @throws InvalidInput outside that range
[[nodiscard]] double hertz_half_width(double force);

/// Contact pressure, E: p(y) = ½√(a² − y²), 0 outside the contact (paper eq. (45)).
/// @param y along the wall from the middle of the contact, R
/// @throws InvalidInput as hertz_half_width, and for a y that is not finite
[[nodiscard]] double hertz_pressure(double force, double y);

/// Stress under the Hertz pressure in a half-plane x ≥ 0, E (paper eqs. (46) and, on the axis,
/// (47)).
///
/// With m + in = √(a² + (x + iy)²) (McEwen; K. L. Johnson, Contact Mechanics, eqs. 4.49)
///
///   σ_xx = −½m (m² − x²)/(m² + n²),   σ_xy = −½n (m² − x²)/(m² + n²),   σ_xx + σ_yy = −(m − x),
///
/// evaluated without the differences: they cancel far from the contact. The relative error of each component is below
/// 1e-14, from a 1e-14th of the half-width at the ends of the contact to any distance.
/// @param depth x ≥ 0, R
/// @param y     along the wall, R
/// @throws InvalidInput as hertz_pressure, and for a negative depth
[[nodiscard]] PlaneStress hertz_stress(double force, double depth, double y);

}  // namespace stoss::quasistatic
