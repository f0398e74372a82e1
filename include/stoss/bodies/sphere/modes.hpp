#pragma once

#include <vector>

#include "stoss/bodies/round.hpp"
#include "stoss/poll.hpp"
#include "stoss/quantity.hpp"

namespace stoss::bodies::sphere {

/// Range of the Poisson's ratio in which the modes are tested.
inline constexpr double min_poisson = -0.95;
inline constexpr double max_poisson = 0.4999;

/// Highest cutoff that `modes` accepts, in c/R (about 420 000 modes at ν = 0.3).
inline constexpr double max_cutoff = 1000.0;

/// One axisymmetric spheroidal vibration of a free sphere.
///
/// Inside the sphere u = (u_r(r) P_n(cos θ), u_θ(r) dP_n(cos θ)/dθ), normalised to
/// ∫ r² (u_r² + n(n+1) u_θ²) dr = (2n+1)/3, so that its modal mass is the mass of the sphere, 4π/3. The amplitudes at
/// the surface are `radial` U, with an error of at most 1e-10 max(|U|, √L |V|), L = n(n+1), and `tangential` V;
/// √L V has the same error. Torsional vibrations do not couple to a frictionless central impact and are left out
/// (docs/theory/spheres.md).
using bodies::Displacement;
using bodies::Flexibility;
using bodies::Mode;

/// All spheroidal axisymmetric modes of a free sphere with 0 < ω ≤ cutoff, sorted by degree, then by frequency.
///
/// No root is missed: the roots below any frequency are counted exactly (Wittrick and Williams,
/// docs/theory/spheres.md), every bracket holds one root, and the list is checked against that count and against
/// static_flexibility.
/// @param poisson Poisson's ratio, −0.95 … 0.4999
/// @param cutoff  highest frequency in c/R, from the lowest mode to 1000
/// @throws InvalidInput outside these ranges; NotConverged if the list fails its own check
[[nodiscard]] std::vector<Mode> modes(double poisson, double cutoff, const Poll& poll = {});

/// Displacement (u_r, u_θ) of a mode inside the sphere at radii 0 ≤ r ≤ 1.
/// @throws InvalidInput for a radius or a Poisson's ratio out of range
[[nodiscard]] std::vector<Displacement> displacement(double poisson, const Mode& mode, const std::vector<double>& radii,
                                                     const Poll& poll = {});

/// Static flexibility of a sphere in closed form, with inertia relief for n = 1 (docs/theory/spheres.md). The load
/// σ_rr = p P_n, σ_rθ = t dP_n/dθ moves the surface by (u_r, u_θ) = 3/(2n+1) · F (p, L t), L = n(n+1).
[[nodiscard]] Flexibility static_flexibility(double poisson, int order);

/// Second moment Σ_l (U,V)(U,V)ᵀ/ω⁴ over all modes of one degree, in closed form: the mass integrals of the static
/// solutions, whose coordinates are their projections on the modes (docs/theory/spheres.md). The response of the
/// surface to a slowly varying load is static_flexibility − d²/dt² static_second_moment.
[[nodiscard]] Flexibility static_second_moment(double poisson, int order);

/// Quantities of one vibration of a free sphere.
[[nodiscard]] const Quantities<Mode>& mode_quantities();

}  // namespace stoss::bodies::sphere
