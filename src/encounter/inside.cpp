#include "stoss/encounter/inside.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "encounter/field_of.hpp"
#include "encounter/ground.hpp"
#include "stoss/bodies/disk/field.hpp"
#include "stoss/bodies/rod/field.hpp"
#include "stoss/bodies/sphere/field.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using bodies::PolarGrid;
using bodies::half_space::PlaneGrid;

/// Contact points that make one ring of a picture, each of which costs as much as a frame.
std::size_t points_in_ring(const ContactPoints& points) {
  constexpr double width = 0.006, fewest = 8.0, most = 24.0;
  const double reach = points.radius * points.spacing * static_cast<double>(points.count);
  const auto rings = static_cast<std::size_t>(std::clamp(reach / width, fewest, most));
  return (points.count + rings - 1) / rings;
}

ContactPoints merged(const ContactPoints& points, std::size_t number) {
  return {points.radius, points.spacing * static_cast<double>(number), (points.count + number - 1) / number};
}

/// What has no end sideways. Its field is linear in what moves it: the answers to the forces of single rings are
/// computed once, so that an instant costs the kept waves only.
class Block {
 public:
  Block(Solid solid, const BodyFrame& rest, PlaneGrid points, Poll poll)
      : solid_(std::move(solid)),
        points_(std::move(points)),
        poll_(std::move(poll)),
        in_ring_(points_in_ring(rest.points)),
        rings_(merged(rest.points, in_ring_).count),
        field_(ground::field_below(solid_, *rest.body, merged(rest.points, in_ring_), points_, poll_)) {
    const std::vector<double> still(mode_count(*rest.body));
    std::vector<double> force(rings_);
    for (std::size_t i = 0; i < rings_; ++i) {
      force[i] = 1.0;
      answers_.push_back(field_(still, force, poll_));
      force[i] = 0.0;
    }
  }

  Interior operator()(const BodyFrame& seen) const {
    const bodies::half_space::Field waves = field_(seen.coordinate, std::vector<double>(rings_), poll_);
    auto [von_mises, difference] = ground::stress_below(solid_, points_, with(waves, seen.node_force));
    bodies::half_space::Field now = with(waves, seen.crept_force);
    return {std::move(now.normal), std::move(now.lateral), std::move(von_mises), std::move(difference)};
  }

 private:
  /// The same with the static answer to forces on the contact points.
  [[nodiscard]] bodies::half_space::Field with(bodies::half_space::Field now,
                                               const std::vector<double>& node_force) const {
    std::vector<double> force(rings_);
    for (std::size_t i = 0; i < node_force.size(); ++i) force[i / in_ring_] += node_force[i];
    for (std::size_t i = 0; i < rings_; ++i) {
      if (force[i] == 0.0) continue;
      for (std::size_t k = 0; k < now.normal.size(); ++k) {
        now.lateral[k] += force[i] * answers_[i].lateral[k];
        now.normal[k] += force[i] * answers_[i].normal[k];
      }
    }
    return now;
  }

  Solid solid_;
  PlaneGrid points_;
  Poll poll_;
  std::size_t in_ring_, rings_;
  ground::FieldBelow field_;
  std::vector<bodies::half_space::Field> answers_;  // to a unit force on each ring
};

template <typename Field>
Inside round_inside(Field field, Poll poll) {
  return [field = std::move(field), poll = std::move(poll)](const BodyFrame& seen) {
    auto now = field_of(field, seen, poll);
    std::vector<double> stress = von_mises(now), difference = principal_difference(now);
    return Interior{std::move(now.radial), std::move(now.tangential), std::move(stress), std::move(difference)};
  };
}

/// Each of some values as often as there are angles.
std::vector<double> repeated(const std::vector<double>& values, std::size_t times) {
  std::vector<double> all;
  for (const double each : values) all.insert(all.end(), times, each);
  return all;
}

/// @param count of points
Inside at_rest(std::size_t count) {
  const std::vector<double> still(count);
  return [still](const BodyFrame&) { return Interior{still, still, still, still}; };
}

/// Makes the inside of a solid; one whose field is not known is shown at rest.
struct MakeInside {
  const BodyFrame& rest;
  const PolarGrid& points;
  const PlaneGrid& below;
  const Poll& poll;

  Inside operator()(const Disk& disk) const {
    return round_inside(bodies::disk::DiskField(disk.poisson, *rest.body, rest.points, points, poll), poll);
  }
  Inside operator()(const Sphere& sphere) const {
    return round_inside(bodies::sphere::SphereField(sphere.poisson, *rest.body, rest.points, points, poll), poll);
  }
  Inside operator()(const Rod&) const {
    return [place = points.radius, sides = points.angle.size()](const BodyFrame& seen) {
      const auto under = [&](double force) { return bodies::rod::field(*seen.body, seen.coordinate, force, place); };
      // Along a rod there is one stress.
      auto now = under(seen.node_force.front());
      for (double& each : now.stress) each = std::abs(each);
      const std::vector<double> stress = repeated(now.stress, sides);
      const std::vector<double> moved = repeated(under(seen.crept_force.front()).displacement, sides);
      return Interior{moved, std::vector<double>(stress.size()), stress, stress};
    };
  }
  template <typename Other>
  Inside operator()(const Other& other) const {
    if (ground::is_unbounded(other)) return Block(other, rest, below, poll);
    return is_unbounded(*rest.body) ? at_rest(below.depth.size() * below.distance.size())
                                    : at_rest(points.radius.size() * points.angle.size());
  }
};

/// Number of a mode among those that a body keeps.
std::optional<std::size_t> number_of(const Body& body, int order, int index) {
  std::size_t k = 0;
  for (const ModeGroup& group : body.groups) {
    for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
      const int its_index = group.index.empty() ? static_cast<int>(l) : group.index[l];
      if (group.order == order && its_index == index) return k;
    }
  }
  return std::nullopt;
}

}  // namespace

Inside inside(const Solid& solid, const BodyFrame& rest, const PolarGrid& points, const PlaneGrid& below,
              const Poll& poll) {
  if (!is_unbounded(*rest.body) && rest.body->part.size < 1.0) {
    return at_rest(points.radius.size() * points.angle.size());
  }
  return std::visit(MakeInside{rest, points, below, poll}, solid);
}

Interior mode_shape(const Solid& solid, int order, int index, const PolarGrid& points) {
  if (std::holds_alternative<ModalBody>(solid)) {
    throw InvalidInput::conflict("mode",
                                 "no shape is known of a modal body, which is known at its contact point alone");
  }
  if (std::holds_alternative<HollowSphere>(solid)) {
    throw InvalidInput::conflict("mode", "no shape is computed of a hollow sphere, of which the outer face is known");
  }
  constexpr double lowest = 8.0, highest = 400.0;
  const BodyMaker make = maker(solid);
  BodyFrame alone;
  std::optional<std::size_t> number;
  for (double cutoff = lowest; cutoff < highest && !number; cutoff *= 2.0) {
    alone.body = std::make_shared<const Body>(make(cutoff, {}));
    number = number_of(*alone.body, order, index);
  }
  if (!number)
    throw InvalidInput::conflict("mode", "above the highest one that a call computes", "lower order or index");
  // No force, so that nothing but the mode moves.
  alone.points = {.radius = 1.0, .spacing = std::holds_alternative<Rod>(solid) ? 0.0 : 0.1, .count = 1};
  alone.coordinate.assign(mode_count(*alone.body), 0.0);
  alone.coordinate[*number] = 1.0;
  alone.node_force = alone.crept_force = {0.0};
  Interior shape = inside(solid, alone, points, {})(alone);
  double greatest = 0.0;
  for (std::size_t i = 0; i < shape.radial.size(); ++i) {
    greatest = std::max(greatest, std::hypot(shape.radial[i], shape.tangential[i]));
  }
  for (std::size_t i = 0; i < shape.radial.size(); ++i) {
    shape.radial[i] /= greatest;
    shape.tangential[i] /= greatest;
  }
  shape.von_mises = shape.principal_difference = {};
  return shape;
}

}  // namespace stoss
