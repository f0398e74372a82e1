#pragma once

#include <functional>
#include <vector>

#include "stoss/encounter/solid.hpp"
#include "stoss/impact/replay.hpp"

namespace stoss::web {

/// Points of a body: every radius with every angle; of a rod places along it.
struct Points {
  std::vector<double> radius, angle;
  bool operator==(const Points&) const = default;
};

/// What is inside a body at one instant, in its own units: radii × angles, row-major.
struct Interior {
  std::vector<double> radial, tangential, von_mises, fringes;
};

using Inside = std::function<Interior(const BodyFrame&)>;

/// The inside of a body at given points. @param rest the body at rest @throws InvalidInput for a half-space
[[nodiscard]] Inside inside(const Solid& solid, const BodyFrame& rest, const Points& points);

}  // namespace stoss::web
