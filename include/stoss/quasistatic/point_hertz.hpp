#pragma once

#include "stoss/cxx20.hpp"

namespace stoss::quasistatic {

/// Two bodies that touch at a point, as a small contact knows them. Lengths are in R and moduli in E of any body. A
/// ball at a hard wall is {1, 1 − ν²}; two equal balls are {2, 2(1 − ν²)}.
struct PointPair {
  double curvature = 1.0;  ///< 1/R₁ + 1/R₂, 0 for a flat one
  double softness = 1.0;   ///< 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂, 0 for a rigid one
};

/// Hertz' contact of round bodies. With curvature 1/R and softness 1/E*
///
///   a³ = ¾FR/E*,   δ = a²/R,   U = ⅖Fδ,   p₀ = 3F/(2πa²)
///
/// (K. L. Johnson, Contact Mechanics, eqs. 4.22 to 4.24).
struct PointHertz {
  double force = 0.0;     ///< F, ER²
  double radius = 0.0;    ///< a of the circle of contact, R
  double approach = 0.0;  ///< δ of distant points of the two bodies, R
  double energy = 0.0;    ///< U = ∫F dδ, ER³
  double pressure = 0.0;  ///< p₀ in the middle of the contact, E
};

/// Hertz' contact of round bodies under a force, to 1e-15.
/// @param force F in ER²: 1/m of it is in mc²/R of a ball, m = 4π/3; 0 to 1e100
/// @throws InvalidInput outside that range, and for curvature or softness outside 1e-100 … 1e100
[[nodiscard]] PointHertz point_hertz(const PointPair& pair, double force);

/// Hertz' contact of round bodies of a given approach, to 1e-15: F = (4/3) E* √R δ^{3/2}.
/// @param approach δ, 0 to 1e100 R. @throws InvalidInput as above
[[nodiscard]] PointHertz point_hertz_of_approach(const PointPair& pair, double approach);

/// Contact pressure, E: p₀ √(1 − r²/a²), 0 outside the contact. @param distance r ≥ 0 from the axis, R
/// @throws InvalidInput for a distance that is negative or not finite
[[nodiscard]] double point_hertz_pressure(const PointHertz& contact, double distance);

/// Axisymmetric stress in cylinder coordinates around the axis of a contact, E; tension is positive.
struct AxisymmetricStress {
  double radial = 0.0;  ///< σ_rr
  double hoop = 0.0;    ///< σ_φφ
  double axial = 0.0;   ///< σ_zz
  double shear = 0.0;   ///< σ_rz
};

/// Stress under Hertz' pressure in a half-space z ≥ 0, E, in closed form (Huber, Ann. Phys. 14, 153, 1904; on the axis
/// and on the surface Johnson, eqs. 3.42 to 3.45).
///
/// With u > 0 the root of r²/(a² + u) + z²/u = 1, w = z/√u, q = a²/(a² + u), h = u + a²z²/u and
/// e = 1 − (√u/a) arctan(a/√u)
///
///   σ_zz = −p₀ w³ a²/h,   σ_rz = −p₀ w² q r√u/h,   b = ⅓(1 − 2ν) q (1 + w + w²)/(1 + w)
///   σ_rr = p₀ {b + w³ a²/h − w [(1 − ν) q + (1 + ν) e]},   σ_φφ = −p₀ {b − w [(1 − ν) q − (1 + ν) e]}
///
/// which has no differences of large terms far from the contact. At the circle's edge σ_rr = −σ_φφ = ⅓(1 − 2ν) p₀.
/// On the axis each component is good to 1e-14 p₀.
/// @param poisson  of the half-space, −0.95 … 0.4999; it does not enter σ_zz and σ_rz
/// @param depth    z ≥ 0, R
/// @param distance r ≥ 0 from the axis, R
/// @throws InvalidInput outside these ranges
[[nodiscard]] AxisymmetricStress point_hertz_stress(const PointHertz& contact, double poisson, double depth,
                                                    double distance);

/// Where under the middle of a contact the shear stress is largest, and how large: ½(σ_rr − σ_zz) on the axis.
struct GreatestShear {
  double depth = 0.0;  ///< R; 0.481 a at ν = 0.3
  double shear = 0.0;  ///< E; 0.310 p₀ at ν = 0.3
};

/// The maximum shear stress below a contact, on the axis, to 1e-14 of the stress and 1e-7 of the depth.
/// @throws InvalidInput for a Poisson's ratio outside −0.95 … 0.4999
[[nodiscard]] GreatestShear greatest_shear(const PointHertz& contact, double poisson);

}  // namespace stoss::quasistatic
