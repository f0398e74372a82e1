#pragma once

#include <vector>

#include "bodies/half_space/spectrum.hpp"
#include "bodies/modal/point_modes.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::modal {

using half_space::Direction;

/// What is local to a point: a sphere of radius 1, or a half-space.
struct PointSurroundings {
  double poisson;
  bool plane;
};

/// Its surface, with the rows 1 and r².
[[nodiscard]] Surface point_surface(const PointSurroundings& its, Direction direction, const ContactPoints& points);

/// Its static compliance without the constant of the sphere.
[[nodiscard]] std::vector<double> local_compliance(const PointSurroundings& its, Direction direction,
                                                   const ContactPoints& points, const Poll& poll);

/// Takes the kept modes from a static compliance, whose rows are `stride` long and begin with those of the points.
void take_kept(const PointModes& modes, Direction direction, const ContactPoints& points, std::size_t stride,
               std::vector<double>& matrix);

/// The kept modes as one group of these rows; none, if there are none.
[[nodiscard]] std::vector<ModeGroup> groups_of(const PointModes& modes, Direction direction);

}  // namespace stoss::bodies::modal
