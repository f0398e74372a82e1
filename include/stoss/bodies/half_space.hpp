#pragma once

#include "stoss/body/body.hpp"

namespace stoss {

/// An elastic half-space as a value, which a sphere meets: its Poisson's ratio, and its material relative to other
/// bodies, in any consistent units.
struct HalfSpace {
  double poisson = 0.0;    ///< ν, −0.95 … 0.4999
  double young = 1.0;      ///< E
  double density = 1.0;    ///< ρ
  double loss_time = 0.0;  ///< η (docs/theory/loss.md), in the unit of time that goes with the others
};

/// An elastic half-plane, which a disk meets.
struct HalfPlane {
  double poisson = 0.0;    ///< 2-D ν, −0.95 … 0.995 (plane strain: Material)
  double young = 1.0;      ///< 2-D E
  double density = 1.0;    ///< ρ
  double loss_time = 0.0;  ///< η
};

/// An elastic half-space with the waves of its surface up to a cutoff, for contacts of limited duration.
///
/// Lamb's response of the surface has a positive spectrum (docs/theory/half_space.md), so a half-space is a body of
/// ordinary undamped modes: for each wave number k one Rayleigh wave and a continuum of faster ones, with the shape
/// J₀(kr). Their sums are quadratures, good while the contact lasts; the body has no translation and takes energy only
/// as waves that run away. It has no size: its unit of length is any, that of the first body where it meets one.
/// Its other units are c = √(E/ρ) and ρ.
/// @param cutoff   highest frequency, above 0
/// @param duration longest contact, in its units of time, above 0
/// @throws InvalidInput outside these ranges, for a modulus or density that is not positive and finite, and where it
///         would have more modes than are computed
[[nodiscard]] Body half_space(const HalfSpace& half_space, double cutoff, double duration, const Poll& poll = {});

/// An elastic half-plane for a disk: as a half-space, with the shapes cos kx.
[[nodiscard]] Body half_plane(const HalfPlane& half_plane, double cutoff, double duration, const Poll& poll = {});

/// Makes half-spaces at any cutoff, which `RefinableContact` and `contact` adapt to the impact.
/// @throws InvalidInput as above
[[nodiscard]] BodyMaker half_space(const HalfSpace& half_space);
[[nodiscard]] BodyMaker half_plane(const HalfPlane& half_plane);

}  // namespace stoss
