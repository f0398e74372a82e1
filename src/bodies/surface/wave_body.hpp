#pragma once

#include <vector>

#include "bodies/parity.hpp"
#include "bodies/surface/medium_surface.hpp"
#include "bodies/surface/residual.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies {

/// What all bodies without end have in common, to which waves are given: no translation, a plane surface.
[[nodiscard]] Body unbounded_body(const MediumSurface& medium, double cutoff, double loss_time, double duration);

/// Gives a body these waves of its surface: they are its modes, of which each wave number is a group, and all its
/// functions follow from them.
/// @param highest_kept wave number up to which waves are kept
void set_waves(const MediumSurface& medium, std::vector<SurfaceWaves> waves, double highest_kept, Body& body);

/// A body without end against forces of these parities: in the plane as those of a disk, (x even | y odd),
/// (y even | x odd); on rings, alike all around the axis, with J₀(kr) for cos ky and J₁(kr) for sin ky.
/// @param body all but its waves and functions
[[nodiscard]] std::vector<Body> plane_bodies(const Body& body, const PlaneSurface& surface,
                                             std::vector<PlaneWaves> waves, const std::vector<Parity>& parities);

}  // namespace stoss::bodies
