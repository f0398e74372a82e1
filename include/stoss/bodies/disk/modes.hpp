#pragma once

#include <vector>

#include "stoss/bodies/round.hpp"
#include "stoss/poll.hpp"
#include "stoss/quantity.hpp"

namespace stoss::bodies::disk {

/// Range of the 2-D Poisson's ratio in which the modes are tested.
inline constexpr double min_poisson = -0.95;
inline constexpr double max_poisson = 0.995;

/// Highest cutoff that `modes` accepts, in c/R (about 450 000 modes at ν = 0.33).
inline constexpr double max_cutoff = 1000.0;

/// One symmetric in-plane vibration of a free disk.
///
/// Inside the disk u = (u_r(r) cos nφ, u_φ(r) sin nφ), normalised to ∫ r (u_r² + u_φ²) dr = 1 for n ≥ 1
/// and ½ for n = 0 (paper eq. (25)), so that its modal mass is the mass of the disk. The amplitudes at the edge,
/// `radial` C and `tangential` S, have an error of at most 1e-10 max(|C|, |S|).
using bodies::Displacement;
using bodies::Flexibility;
using bodies::Mode;

/// Which displacement dominates at the edge (paper, figure of the mode frequencies).
enum class ModeFamily { radial, tangential };

/// Family of a mode: radial where C > |S|, tangential otherwise.
[[nodiscard]] ModeFamily family(const Mode& mode);

/// All symmetric modes of a free disk with 0 < ω ≤ cutoff, sorted by order, then by frequency.
///
/// The eigenvalue equation is paper eq. (24) for n ≥ 1 and eq. (20) for n = 0. No root is missed: the roots below
/// any frequency are counted exactly (Wittrick and Williams, docs/theory/modes.md), every bracket holds one root,
/// and the list is checked against that count and against static_flexibility.
/// @param poisson 2-D Poisson's ratio, −0.95 … 0.995
/// @param cutoff  highest frequency in c/R, from the lowest mode to 1000
/// @throws InvalidInput outside these ranges; NotConverged if the list fails its own check
[[nodiscard]] std::vector<Mode> modes(double poisson, double cutoff, const Poll& poll = {});

/// Displacement (u_r, u_φ) of a mode inside the disk at radii 0 ≤ r ≤ 1 (paper eq. (19)).
/// @throws InvalidInput for a radius or a Poisson's ratio out of range
[[nodiscard]] std::vector<Displacement> displacement(double poisson, const Mode& mode, const std::vector<double>& radii,
                                                     const Poll& poll = {});

/// Static flexibility of a disk in closed form, with inertia relief for n = 1
/// (docs/theory/modes.md).
[[nodiscard]] Flexibility static_flexibility(double poisson, int order);

/// Second moment Σ_l (C,S)(C,S)ᵀ/ω⁴ over all modes of one order, in closed form: ∫ r u·u dr of the
/// static solutions u, whose coordinates are their projections on the modes (docs/theory/modes.md).
/// The response of the edge to a slowly varying load is static_flexibility − d²/dt²
/// static_second_moment.
[[nodiscard]] Flexibility static_second_moment(double poisson, int order);

/// Quantities of one vibration of a free disk.
[[nodiscard]] const Quantities<Mode>& mode_quantities();

}  // namespace stoss::bodies::disk
