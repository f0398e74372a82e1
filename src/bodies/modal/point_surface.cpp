#include "bodies/modal/point_surface.hpp"

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

#include "bodies/half_space/surface_waves.hpp"
#include "bodies/modal/point_compliance.hpp"
#include "bodies/sphere/along/along.hpp"
#include "bodies/sphere/degree_sums.hpp"
#include "bodies/sphere/surface_points.hpp"
#include "bodies/surface/residual.hpp"

namespace stoss::bodies::modal {
namespace {

/// Of a mode: its displacement at the point, and how that changes with r².
std::pair<double, double> motion(const KeptMode& mode, Direction direction) {
  if (direction == Direction::along) return {mode.tangential, mode.tangential_bend};
  return {mode.displacement, mode.bend};
}

}  // namespace

Surface point_surface(const PointSurroundings& its, Direction direction, const ContactPoints& points) {
  Surface surface = direction == Direction::along ? sphere::surface_along(its.poisson, 0, points)
                                                  : sphere::axial_surface(its.poisson, 0, points);
  if (its.plane) {
    const half_space::Medium medium = half_space::medium(Contour::ball, its.poisson, direction);
    for (std::size_t i = 0; i < points.count; ++i) {
      const double inner = points.radius * std::sin(static_cast<double>(i) * points.spacing);
      const double outer = points.radius * std::sin(static_cast<double>(i + 1) * points.spacing);
      surface.recess[i] = 0.0;
      surface.measure[i] = medium.measure(inner, outer);
      surface.impedance[i] = surface.measure[i] * medium.leaving_speed;
    }
  }
  surface.shape.assign(points.count, 1.0);
  for (std::size_t i = 0; i < points.count; ++i) {
    const double distance = lateral_distance(points, i);
    surface.shape.push_back(distance * distance);
  }
  return surface;
}

std::vector<double> local_compliance(const PointSurroundings& its, Direction direction, const ContactPoints& points,
                                     const Poll& poll) {
  if (its.plane) {
    const auto none = std::make_shared<const std::vector<SurfaceWaves>>();
    const half_space::Medium medium = half_space::medium(Contour::ball, its.poisson, direction);
    return WaveResidual(medium, 1.0, 0.0, none).compliance(points, poll);
  }
  const bool along = direction == Direction::along;
  std::vector<double> compliance = sphere::sum_over_degrees({{its.poisson, true, {}}, along}, points, poll);
  const double constant = along ? sphere_constant_along(its.poisson) : sphere_constant(its.poisson);
  for (double& each : compliance) each -= constant;
  return compliance;
}

void take_kept(const PointModes& modes, Direction direction, const ContactPoints& points, std::size_t stride,
               std::vector<double>& matrix) {
  std::vector<double> row(points.count);
  for (const KeptMode& mode : modes.kept) {
    const auto [displacement, bend] = motion(mode, direction);
    if (displacement == 0.0 && bend == 0.0) continue;
    const double weight = 1.0 / (modes.mass * mode.omega * mode.omega);
    for (std::size_t i = 0; i < points.count; ++i) {
      const double distance = lateral_distance(points, i);
      row[i] = displacement + bend * distance * distance;
    }
    for (std::size_t i = 0; i < points.count; ++i) {
      for (std::size_t j = 0; j < points.count; ++j) matrix[i * stride + j] -= weight * row[i] * row[j];
    }
  }
}

std::vector<ModeGroup> groups_of(const PointModes& modes, Direction direction) {
  ModeGroup group{0, {}, {}, {}, 0, 1, {}, 0.0};
  for (const KeptMode& mode : modes.kept) {
    const auto [displacement, bend] = motion(mode, direction);
    if (direction == Direction::along && displacement == 0.0 && bend == 0.0) continue;
    group.omega.push_back(mode.omega);
    group.upper.push_back(displacement);
    group.lower.push_back(bend);
  }
  if (group.omega.empty()) return {};
  return {std::move(group)};
}

}  // namespace stoss::bodies::modal
