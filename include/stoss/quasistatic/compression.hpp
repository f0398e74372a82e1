#pragma once

#include <variant>

#include "stoss/quasistatic/point_hertz.hpp"

namespace stoss::quasistatic {

/// Force against compression of a disk that is pressed slowly against a wall. With the force F in πRE and lengths in R
///
///   δ = F (ln(s/F) − b):   center    s = 1, b = (1 + ν)/4   (docs/theory/errata.md, E8)
///                          diameter  s = 4, b = 1           (E7)
///
/// to leading order in F. The paper prints 1 + ν for the latter b (eq. (56)). The exact static contact adds (3 + 3ν/2)
/// F² to the law of the centre (measured; docs/theory/quasistatic.md): 0.1 % of δ = 0.01 R, 0.4 … 0.6 % of δ = 0.03 R.
enum class CompressionLaw {
  center,   ///< approach of the centre of mass to the wall: the one that belongs in its equation of motion
  diameter  ///< shortening of the diameter through the point of contact
};

/// Force against compression of a sphere that is pressed slowly against a wall. With the radius a of the contact,
/// F = a³/(π(1 − ν²)) in mc²/R (which is (4/3)E*a³ in ER²), lengths in R and g = (1 − 2ν)²/(2(1 − ν))
///
///   hertz:   δ = a²
///   center:  δ = a² + (4/3π) a³ [g (19/12 − ln 2a) + K₁(ν) − (1 − 2ν)/(2(1 − ν))] + O(a⁴)
///
/// (docs/theory/points.md). At ν = 0.3 the exact static contact differs in δ from the law of the centre by 2e-5, 2e-4
/// and 2.7e-3 of it at δ = 1e-4, 1e-3 and 1e-2, from Hertz by 5e-3, 1.8e-2 and 6.2e-2.
enum class PointLaw {
  hertz,  ///< two half-spaces
  center  ///< approach of the centre of mass to the wall, to the first order beyond Hertz
};

/// A static law of a contact along a line, of disks, or at a point, of spheres. Poisson's ratio is 2-D for lines
/// (−0.95 … 0.995) and 3-D for points (−0.95 … 0.4999). Forces are in mc²/R: πRE of a disk, (4π/3)R²E of a sphere.
using StaticLaw = std::variant<CompressionLaw, PointLaw>;

/// Force at which a law ends, mc²/R: δ(F) has its maximum there, of a disk at F = s e^{−1−b}; or the contact of a
/// sphere has the radius R. A law means little from a tenth of it on.
/// @throws InvalidInput for a Poisson's ratio out of range
[[nodiscard]] double limit_force(StaticLaw law, double poisson);

/// Compression δ(F) by one of the laws, R.
/// @param force F, 0 … limit_force
/// @throws InvalidInput outside that range, and for a Poisson's ratio out of range
[[nodiscard]] double compression(StaticLaw law, double poisson, double force);

/// Force F(δ) by one of the laws, mc²/R: the inverse of `compression`, to a relative error of 1e-14.
/// @param compression δ, 0 … compression(law, poisson, limit_force)
/// @throws InvalidInput as compression
[[nodiscard]] double compression_force(StaticLaw law, double poisson, double compression);

/// Elastic energy ∫F dδ from first contact on, mc²; of a disk F² [½ ln(s/F) − ½b − ¼].
/// @param force F, as above
[[nodiscard]] double compression_energy(StaticLaw law, double poisson, double force);

/// Radius of the contact of a sphere under a force, R: a³ = π(1 − ν²)F for both laws.
/// @param force F in mc²/R, 0 … limit_force(law, poisson)
[[nodiscard]] double contact_radius(PointLaw law, double poisson, double force);

/// Hertz' contact of a sphere at a hard wall, in R and E of it. @param force as for contact_radius
[[nodiscard]] PointHertz point_hertz_at_wall(double poisson, double force);

/// K₁(ν) = D₀ + Σ_{n≥1} (D_n − g/n) of the law of the centre, to 1e-14: D_n is by how much a sphere yields to a load of
/// degree n beyond what a half-space would, F^UU_n/((4/3)(1 − ν²)) − 1. −1.540051 at ν = 0.3.
/// @param poisson −0.95 … 0.4999. @throws InvalidInput outside
[[nodiscard]] double center_constant(double poisson);

}  // namespace stoss::quasistatic
