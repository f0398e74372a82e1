#include "block.hpp"

#include <algorithm>
#include <utility>

#include "alive.hpp"
#include "stoss/bodies/half_space/stress.hpp"

namespace stoss::web {
namespace {

using bodies::half_space::Field;
using bodies::half_space::HalfSpaceField;
using bodies::half_space::PlaneGrid;

/// Contact points that make one ring: a picture needs no narrower ones than this, in the unit of length, but some in
/// every contact; and each costs as much as a frame.
std::size_t points_in_ring(const ContactPoints& points) {
  constexpr double width = 0.006, fewest = 8.0, most = 24.0;
  const double reach = points.radius * points.spacing * static_cast<double>(points.count);
  const auto rings = static_cast<std::size_t>(std::clamp(reach / width, fewest, most));
  return (points.count + rings - 1) / rings;
}

ContactPoints merged(const ContactPoints& points, std::size_t number) {
  return {points.radius, points.spacing * static_cast<double>(number), (points.count + number - 1) / number};
}

}  // namespace

Block::Block(double poisson, const BodyFrame& rest, PlaneGrid points)
    : poisson_(poisson),
      contour_(rest.body->contour),
      points_(std::move(points)),
      in_ring_(points_in_ring(rest.points)),
      rings_(merged(rest.points, in_ring_).count),
      field_(poisson, *rest.body, merged(rest.points, in_ring_), points_) {
  const std::vector<double> still(mode_count(*rest.body));
  std::vector<double> force(rings_);
  for (std::size_t i = 0; i < rings_; ++i) {
    force[i] = 1.0;
    answers_.push_back(field_.at(still, force, say_alive));
    force[i] = 0.0;
  }
}

std::vector<double> Block::on_rings(const std::vector<double>& node_force) const {
  std::vector<double> force(rings_);
  for (std::size_t i = 0; i < node_force.size(); ++i) force[i / in_ring_] += node_force[i];
  return force;
}

Interior Block::at(const BodyFrame& seen) const {
  const std::vector<double> none(rings_), force = on_rings(seen.node_force);
  Field now = field_.at(seen.coordinate, none, say_alive);
  for (std::size_t i = 0; i < rings_; ++i) {
    if (force[i] == 0.0) continue;
    for (std::size_t k = 0; k < now.normal.size(); ++k) {
      now.lateral[k] += force[i] * answers_[i].lateral[k];
      now.normal[k] += force[i] * answers_[i].normal[k];
    }
  }
  auto [von_mises, difference] = bodies::half_space::stress(contour_, poisson_, points_, now);
  return {std::move(now.normal), std::move(now.lateral), std::move(von_mises), std::move(difference)};
}

}  // namespace stoss::web
