#pragma once

#include "stoss/body/body.hpp"
#include "stoss/material.hpp"

namespace stoss {

/// A sphere as a value: its Poisson's ratio, and its size and material relative to other bodies, in any consistent
/// units.
struct Sphere {
  double poisson = 0.0;  ///< ν, −0.95 … 0.4999
  double radius = 1.0;   ///< R
  double young = 1.0;    ///< E
  double density = 1.0;  ///< ρ
  /// η of a Kelvin–Voigt material, stress = (1 + η ∂/∂t) elastic stress: in the unit of time that the others imply,
  /// that of length √(density/young); 0 … 1e5 R/c of the sphere.
  double loss_time = 0.0;
};

/// An elastic sphere with all axisymmetric spheroidal modes up to a cutoff, in its own units R = c = ρ = E = 1,
/// c = √(E/ρ), m = 4π/3 (docs/theory/spheres.md). It meets walls and spheres centrally and without friction.
/// @param cutoff c/R, above 0 to 1000; below the lowest mode the sphere keeps none
/// @throws InvalidInput outside these ranges, and for a radius, modulus or density that is not positive and finite
[[nodiscard]] Body sphere(const Sphere& sphere, double cutoff, const Poll& poll = {});
[[nodiscard]] Body sphere(double poisson, double cutoff, const Poll& poll = {});

/// SI values of the units of a sphere that is given in SI: R, c = √(E/ρ), R/c, c/R, and the force mc²/R = (4π/3)R²E.
/// @throws InvalidInput as above
[[nodiscard]] Scales scales(const Sphere& sphere);

/// Makes spheres at any cutoff, for `restitution`, which chooses the cutoffs. @throws InvalidInput as above
[[nodiscard]] BodyMaker sphere(const Sphere& sphere);
[[nodiscard]] BodyMaker sphere(double poisson);

}  // namespace stoss
