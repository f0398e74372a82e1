#include "inside.hpp"

#include <cmath>
#include <utility>
#include <variant>

#include "stoss/bodies/disk/field.hpp"
#include "stoss/bodies/rod/field.hpp"
#include "stoss/bodies/sphere/field.hpp"
#include "stoss/errors.hpp"

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

/// Makes the inside of a solid.
struct Make {
  const BodyFrame& rest;
  const Points& points;

  Inside operator()(const Disk& disk) const {
    return round(bodies::disk::DiskField(disk.poisson, *rest.body, rest.points, {points.radius, points.angle}));
  }
  Inside operator()(const Sphere& sphere) const {
    return round(bodies::sphere::SphereField(sphere.poisson, *rest.body, rest.points, {points.radius, points.angle}));
  }
  Inside operator()(const Rod&) const {
    return [place = points.radius](const BodyFrame& seen) {
      auto now = bodies::rod::field(*seen.body, seen.coordinate, seen.node_force.front(), place);
      // Along a rod there is one stress.
      for (double& each : now.stress) each = std::abs(each);
      return Interior{std::move(now.displacement), std::vector<double>(place.size()), now.stress, now.stress};
    };
  }
  template <typename Unbounded>
  Inside operator()(const Unbounded&) const {
    throw InvalidInput("body: got a half-space, allowed one with modes");
  }
};

}  // namespace

Inside inside(const Solid& solid, const BodyFrame& rest, const Points& points) {
  return std::visit(Make{rest, points}, solid);
}

}  // namespace stoss::web
