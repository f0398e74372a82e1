#include "inside.hpp"

#include <cmath>
#include <memory>
#include <utility>

#include "stoss/bodies/disk/field.hpp"
#include "stoss/bodies/rod/field.hpp"
#include "stoss/bodies/sphere/field.hpp"

namespace stoss::web {
namespace {

template <typename Field>
Inside round(Field field) {
  return [field = std::move(field)](const BodyFrame& seen) {
    auto now = field.at(seen.coordinate, seen.node_force);
    std::vector<double> stress = von_mises(now), difference = principal_difference(now);
    return Interior{std::move(now.radial), std::move(now.tangential), std::move(stress), std::move(difference)};
  };
}

Inside along(const Points& points) {
  return [place = points.radius](const BodyFrame& seen) {
    auto now = bodies::rod::field(*seen.body, seen.coordinate, seen.node_force.front(), place);
    // Along a rod there is one stress.
    for (double& each : now.stress) each = std::abs(each);
    return Interior{std::move(now.displacement), std::vector<double>(place.size()), now.stress, now.stress};
  };
}

}  // namespace

Inside inside(BodyKind kind, double poisson, const BodyFrame& rest, const Points& points) {
  switch (kind) {
    case BodyKind::disk:
      return round(bodies::disk::DiskField(poisson, *rest.body, rest.points, {points.radius, points.angle}));
    case BodyKind::sphere:
      return round(bodies::sphere::SphereField(poisson, *rest.body, rest.points, {points.radius, points.angle}));
    case BodyKind::rod:
      break;
  }
  return along(points);
}

}  // namespace stoss::web
