#pragma once

#include "stoss/body/body.hpp"

namespace stoss {

/// A disk as a value: its 2-D Poisson's ratio, and its size and material relative to other bodies, in any consistent
/// units.
struct Disk {
  double poisson = 0.0;  ///< ν, −0.95 … 0.995 (plane strain: Material)
  double radius = 1.0;   ///< R
  double young = 1.0;    ///< E
  double density = 1.0;  ///< ρ
  /// η of a Kelvin–Voigt material, stress = (1 + η ∂/∂t) elastic stress: in the unit of time that the others imply,
  /// that of length √(density/young); 0 … 1e5 R/c of the disk.
  double loss_time = 0.0;
};

/// An elastic disk with all symmetric modes up to a cutoff (paper, section II), in its own units R = c = ρ = 1, m = π.
/// @param cutoff c/R, above 0 to 1000; below the lowest mode the disk keeps none
/// @throws InvalidInput outside these ranges, and for a radius, modulus or density that is not positive and finite
[[nodiscard]] Body disk(const Disk& disk, double cutoff, const Poll& poll = {});
[[nodiscard]] Body disk(double poisson, double cutoff, const Poll& poll = {});

/// Makes disks at any cutoff, for `restitution`, which chooses the cutoffs. @throws InvalidInput as above
[[nodiscard]] BodyMaker disk(const Disk& disk);
[[nodiscard]] BodyMaker disk(double poisson);

}  // namespace stoss
