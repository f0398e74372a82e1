#pragma once

#include <vector>

#include "stoss/bodies/sphere.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/body/body.hpp"
#include "stoss/material.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// A hollow sphere as a value: a shell of one material with two concentric free faces, in any consistent units.
struct HollowSphere {
  double poisson = 0.0;    ///< ν, −0.95 … 0.4999
  double inner = 0.0;      ///< b, radius of the hole over that of the sphere, 0 … 0.99; 0: a solid sphere
  double radius = 1.0;     ///< R, of the outer face
  double young = 1.0;      ///< E
  double density = 1.0;    ///< ρ
  double loss_time = 0.0;  ///< η of a Kelvin–Voigt material, as that of a Sphere
};

/// Makes hollow spheres at any cutoff up to 400 c/R: all axisymmetric spheroidal modes below it, with a proof that none
/// is missing, and the exact response of all others (docs/theory/spheres.md); units R = c = ρ = E = 1, m = 4π/3 (1−b³).
/// They meet what spheres meet, are solid spheres where b = 0, and turn with the inertia (2/5) m (1−b⁵)/(1−b³).
/// @throws InvalidInput outside these ranges, and for a radius, modulus or density that is not positive and finite
[[nodiscard]] BodyMaker hollow_sphere(const HollowSphere& hollow);

/// SI values of the units of a hollow sphere that is given in SI: as of a Sphere, the force mc²/R with its own mass.
/// @throws InvalidInput as above
[[nodiscard]] Scales scales(const HollowSphere& hollow);

namespace bodies::sphere {

/// All spheroidal axisymmetric modes of a free hollow sphere with 0 < ω ≤ cutoff, sorted by degree, then by frequency.
/// Normalised as those of a solid sphere to ∫ r² (u_r² + n(n+1) u_θ²) dr = (2n+1)/3, now from b to 1: their modal mass
/// is 4π/3. Where the field of a degree is below rounding at the hole, its modes are those of the solid sphere.
/// @param inner  b, 0 … 0.99
/// @param cutoff highest frequency in c/R, from the lowest mode to 400
/// @throws InvalidInput outside these ranges, and for a Poisson's ratio outside −0.95 … 0.4999
[[nodiscard]] std::vector<Mode> hollow_modes(double poisson, double inner, double cutoff, const Poll& poll = {});

}  // namespace bodies::sphere

}  // namespace stoss
