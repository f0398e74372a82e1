#include "bodies/modal/point_modes.hpp"

#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <utility>

#include "bodies/half_space/lamb_kernel.hpp"
#include "bodies/half_space/surface_waves.hpp"
#include "bodies/sphere/along/along.hpp"
#include "bodies/sphere/along/toroidal.hpp"
#include "bodies/sphere/degree_sums.hpp"
#include "bodies/sphere/surface_points.hpp"
#include "bodies/surface/residual.hpp"
#include "stoss/bodies/sphere/modes.hpp"

namespace stoss::bodies::modal {
namespace {

constexpr double mass = 4.0 * std::numbers::pi / 3.0;
constexpr int terms = 20000;

/// Σ over the degrees of what falls as 1/n², `left`, by Euler and Maclaurin beyond the last.
template <typename Left>
double summed(double of_0, const Left& left) {
  double sum = of_0;
  for (int n = 1; n < terms; ++n) sum += left(n);
  const double last = left(terms);
  return sum + 0.5 * last + last * terms;
}

}  // namespace

double logarithm_share(double poisson) {
  const double incompressible = 1.0 - 2.0 * poisson;
  return incompressible * incompressible / (2.0 * (1.0 - poisson));
}

// The pole moves by (1/m) Σ (R^UU P_n − R^UV sin θ dP_n/dθ). With R^UU/m → A + B/n and R^UV/m → C/n these sums are
// A/θ − B ln(θ/2) + C, and what is left of R^UU falls as 1/n².
double sphere_constant(double poisson) {
  const double plain = (1.0 - poisson * poisson) / std::numbers::pi;
  const double slow = plain * logarithm_share(poisson);
  const auto left = [&](int n) { return sphere::static_flexibility(poisson, n).radial / mass - plain - slow / n; };
  const double sum = summed(sphere::static_flexibility(poisson, 0).radial / mass - plain, left);
  const double turning = terms * sphere::static_flexibility(poisson, terms).mixed / mass;
  return sum + slow * std::numbers::ln2 + turning;
}

double logarithm_share_along(double poisson) {
  return (3.0 - 2.0 * poisson + 4.0 * poisson * poisson) / (2.0 * (2.0 - poisson));
}

// Along y the pole moves by (1/m) Σ ½ [L (R^VV + R^WW) cos θ P_n − R^UV sin θ dP_n/dθ], but for what vanishes there.
double sphere_constant_along(double poisson) {
  const double plain = sphere::softness_along(poisson) / std::numbers::pi;
  const double slow = plain * logarithm_share_along(poisson);
  const auto left = [&](int n) {
    const double both = sphere::static_flexibility(poisson, n).tangential + sphere::toroidal_flexibility(poisson, n);
    return 0.5 * n * (n + 1.0) * both / mass - plain - slow / n;
  };
  const double turning = 0.5 * terms * sphere::static_flexibility(poisson, terms).mixed / mass;
  return summed(-plain, left) + slow * std::numbers::ln2 + turning;
}

double wave_speed(const ModalBody& body) { return std::sqrt(body.young / body.density); }

double moving_mass(const ModalBody& body) {
  constexpr double immovable = 1e12;
  return body.held ? immovable * body.mass : body.mass;
}

PointModes point_modes(const ModalBody& body, double cutoff) {
  const double length = own_length(body), frequency = wave_speed(body) / length;
  const double mass = moving_mass(body), root = std::sqrt(mass);
  PointModes its{mass / (body.density * length * length * length),
                 body.compliance * body.young * length,
                 body.tangent ? body.tangent->compliance * body.young * length : 0.0,
                 {}};
  const double bend = root * length * length;
  for (const PointMode& mode : body.modes) {
    if (mode.omega > cutoff * frequency) break;
    its.kept.push_back({mode.omega / frequency, root * mode.displacement, bend * mode.bend, root * mode.tangential,
                        bend * mode.tangential_bend});
  }
  return its;
}

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
