#pragma once

#include "stoss/body/body.hpp"
#include "stoss/material.hpp"

namespace stoss {

/// A thin rod as a value: size and material relative to other bodies, in any consistent units.
struct Rod {
  double length = 1.0;   ///< L
  double young = 1.0;    ///< E
  double density = 1.0;  ///< ρ
  double area = 1.0;     ///< of the cross-section, A
  /// η of a Kelvin–Voigt material, stress = (1 + η ∂/∂t) elastic stress: in the unit of time that the others imply,
  /// that of length √(density/young); 0 … 1e5 L/c of the rod.
  double loss_time = 0.0;
};

/// A thin elastic rod that meets a wall or another rod with one end, in units of its length L, bar speed c and mass:
/// ω_l = lπ, end amplitude √2. At a hard wall ε = 1, contact time 2L/c, force mvc/L throughout, exactly; for two rods
/// see docs/theory/pairs.md.
/// @param cutoff c/L, above 0 to 1e6; below π the rod keeps no mode
/// @throws InvalidInput outside that range, and for a size or material that is not positive and finite, or a loss time
/// out of range
[[nodiscard]] Body rod(const Rod& rod, double cutoff);

/// A rod by itself. @param cutoff c/L, from π to 1e6
[[nodiscard]] Body rod(double cutoff);

/// SI values of the units of a rod that is given in SI: L, c = √(E/ρ), L/c, c/L, and the force EA.
/// @throws InvalidInput for a size or material that is not positive and finite
[[nodiscard]] Scales scales(const Rod& rod);

/// Makes rods at any cutoff, for `restitution`, which chooses the cutoffs.
[[nodiscard]] BodyMaker rod(const Rod& rod = {});

}  // namespace stoss
