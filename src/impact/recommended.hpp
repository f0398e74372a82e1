#pragma once

#include "stoss/impact/impact.hpp"
#include "stoss/impact/resolution.hpp"

namespace stoss {

inline constexpr int most_nodes = 4096;

/// Half-width of the first contact grid of an impact, R: it must cover the contact with room to spare, and with a soft
/// wall the gap in which it still pushes.
[[nodiscard]] double initial_half_width(const Contact& contact, double speed);

/// Nodes at which the Nyquist order π/h of a grid is the highest kept order.
[[nodiscard]] int nyquist_nodes(const Contact& contact, double half_width);

/// Nodes that the bodies ask for across the half-width of a hard contact (Body::sampling).
[[nodiscard]] double sampled_nodes(const Contact& contact, double half_width);

/// Recommended nodes of a grid.
[[nodiscard]] int nodes_within(const Contact& contact, Tail tail, double half_width);

/// Maximum half-width of a contact for the grid of a finer run. One narrower than the spacing of its grid tells
/// nothing, as a sheet touches here and there: a share of the usual width does for it.
/// @param coarser run, or an empty one if there was none
[[nodiscard]] double known_half_width(const Contact& contact, double speed, const Impact& coarser);

/// Resolution of an impact at a hard wall for `restitution`: finer in time and in space with the
/// cutoff.
/// @param half_width maximum of the contact in a coarser run, or 0 if there was none
[[nodiscard]] Resolution refined_resolution(const Contact& contact, double speed, double half_width);

/// A wider grid of the same node spacing, at most as wide as the edge that can touch.
[[nodiscard]] FixedResolution widened(const Contact& contact, const FixedResolution& resolution);

}  // namespace stoss
