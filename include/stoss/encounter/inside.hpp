#pragma once

#include <functional>
#include <vector>

#include "stoss/bodies/half_space/field.hpp"
#include "stoss/bodies/round.hpp"
#include "stoss/encounter/solid.hpp"
#include "stoss/impact/replay.hpp"
#include "stoss/poll.hpp"

/// What a film shows of an impact, one instant after another: what takes long is done once.
namespace stoss {

/// Displacement and stress at one instant, in the units of the body: radii × angles, of a half-space or a
/// plate depths × distances, row-major.
struct Interior {
  std::vector<double> radial;      ///< along the radius; of a rod towards what it meets; into a half-space or a plate
  std::vector<double> tangential;  ///< along the angle; of these away from the axis
  std::vector<double> von_mises, principal_difference;
};

using Inside = std::function<Interior(const BodyFrame&)>;

/// What is inside a body, a half-space or a plate, seen by it (seen_by). Of one of which only the near side is
/// computed, as it is at rest. In these contact points are put together into at least eight rings, about 0.006 of the
/// unit of length wide, which is as fine as a picture.
/// @param rest   at any instant, for its modes and contact points
/// @param points of a body; of a rod its radii are places along it, 0 at the struck end, and angles do not count
/// @param below  of a half-space or a plate, at least three depths and distances
/// @throws InvalidInput for points that are not inside
[[nodiscard]] Inside inside(const Solid& solid, const BodyFrame& rest, const bodies::PolarGrid& points,
                            const bodies::half_space::PlaneGrid& below, const Poll& poll = {});

/// Displacement by a mode of a body, maximum 1; without stress.
/// @throws InvalidInput for a mode that the body does not have below cutoffs that are computed at once
[[nodiscard]] Interior mode_shape(const Solid& solid, int order, int index, const bodies::PolarGrid& points);

}  // namespace stoss
