// Hooke's law with the strains of a field of displacements, by differences between the points of its grid.
#include "block.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "alive.hpp"

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

/// Derivative at a place of what is known there and at its neighbours: that of the parabola through three of them.
class Slope {
 public:
  Slope(const std::vector<double>& places, std::size_t at)
      : first_(std::clamp<std::size_t>(at, 1, places.size() - 2) - 1) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double a = places[first_ + (i + 1) % 3], b = places[first_ + (i + 2) % 3], own = places[first_ + i];
      weight_[i] = (2.0 * places[at] - a - b) / ((own - a) * (own - b));
    }
  }

  /// @param values with a distance of `stride` between neighbours
  [[nodiscard]] double of(const double* values, std::size_t stride) const {
    values += first_ * stride;
    return weight_[0] * values[0] + weight_[1] * values[stride] + weight_[2] * values[2 * stride];
  }

 private:
  std::size_t first_;
  std::array<double, 3> weight_{};
};

}  // namespace

Block::Block(double poisson, const BodyFrame& rest, PlaneGrid points)
    : poisson_(poisson),
      solid_(rest.body->contour == Contour::ball),
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
  return with_stress(std::move(now));
}

Interior Block::with_stress(Field displacement) const {
  const auto& [distance, depth] = points_;
  const std::size_t columns = distance.size();
  const double shear = 0.5 / (1.0 + poisson_);
  Interior inside;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const Slope down(depth, i);
    for (std::size_t j = 0; j < columns; ++j) {
      const Slope out(distance, j);
      const double *const lateral = displacement.lateral.data(), *const normal = displacement.normal.data();
      const double rr = out.of(lateral + i * columns, 1), zz = down.of(normal + j, columns);
      const double rz = shear * (down.of(lateral + j, columns) + out.of(normal + i * columns, 1));
      // Around the axis of a half-space, and across a half-plane, where it has no stress.
      const double pp = !solid_              ? -poisson_ / (1.0 - poisson_) * (rr + zz)
                        : distance[j] == 0.0 ? rr
                                             : lateral[i * columns + j] / distance[j];
      inside.fringes.push_back(2.0 * std::hypot(shear * (rr - zz), rz));
      const double a = 2.0 * shear * (rr - zz), b = 2.0 * shear * (zz - pp), c = 2.0 * shear * (pp - rr);
      inside.von_mises.push_back(std::sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * rz * rz));
    }
  }
  inside.radial = std::move(displacement.normal);
  inside.tangential = std::move(displacement.lateral);
  return inside;
}

}  // namespace stoss::web
