#include "bodies/modal/point_modes.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "bodies/half_space/lamb_kernel.hpp"
#include "bodies/half_space/surface_waves.hpp"
#include "bodies/sphere/along/along.hpp"
#include "bodies/sphere/along/toroidal.hpp"
#include "bodies/sphere/degree_sums.hpp"
#include "bodies/sphere/surface_points.hpp"
#include "bodies/surface/residual.hpp"
#include "check.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/errors.hpp"

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

namespace {

constexpr double most = std::numeric_limits<double>::max();
constexpr Range positive{0.0, most, false, true, "a positive finite number"};
constexpr Range not_negative{0.0, most, true, true, "0 or a positive finite number"};
constexpr Range finite{-most, most, true, true, "a finite number"};

double wave_speed(const ModalBody& body) { return std::sqrt(body.young / body.density); }

/// Local law of Weyl: Σ φ² over the modes up to ω of a large body is that of a half-space, (2/3π) C ω³/(ρ c_s³).
double expected_sum(const ModalBody& body, double omega) {
  const double shear = std::sqrt(0.5 * body.young / (body.density * (1.0 + body.poisson)));
  const double radiated = half_space::radiation_coefficient(half_space::lamb_kernel(body.poisson));
  return 2.0 / (3.0 * std::numbers::pi) * radiated / body.density * std::pow(omega / shear, 3.0);
}

void require_modes(const ModalBody& body) {
  double last = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < body.modes.size(); ++i) {
    const PointMode& mode = body.modes[i];
    const std::string name = "mode " + std::to_string(i + 1) + " ";
    require(name + "frequency", mode.omega, positive, "of an elastic mode: rigid motion is not among them");
    require(name + "displacement", mode.displacement, finite, "along the normal at the point");
    require(name + "bend", mode.bend, finite, "of the displacement around the point");
    require(name + "frequency error", mode.omega_error, not_negative, "of the mode");
    require(name + "displacement error", mode.displacement_error, not_negative, "of the mode");
    require(name + "tangential displacement", mode.tangential, finite, "along the surface at the point");
    require(name + "tangential bend", mode.tangential_bend, finite, "of the displacement along the surface");
    require(name + "tangential displacement error", mode.tangential_error, not_negative, "of the mode");
    if (mode.omega < last) {
      throw InvalidInput::out_of_range(name + "frequency", shown(mode.omega) + " after " + shown(last),
                                       "modes in rising order");
    }
    last = mode.omega;
    if (mode.omega <= body.complete_to) sum += mode.displacement * mode.displacement;
  }
  // Below some ten modes the law says nothing, and where bodies are slender there are fewer than in a large one.
  constexpr double share = 0.1, enough = 30.0;
  const double expected = expected_sum(body, body.complete_to);
  if (expected * body.mass > enough && sum < share * expected) {
    throw InvalidInput::out_of_range(
        "modes",
        std::to_string(body.modes.size()) + " with " + rounded(sum) + " as the sum of their squared displacements",
        "about " + rounded(expected) + " up to complete_to",
        "modes are missing, or are not normalised to unit modal mass");
  }
}

void require_tangent(const PointTangent& its) {
  require("tangential mass", its.mass, positive, "of the body along its surface");
  require("tangential inertia", its.inertia, not_negative, "of the body as friction turns it; 0: it does not turn");
  require("tangential arm", its.arm, not_negative, "from the centre of mass to the point; 0: it does not turn");
  if ((its.inertia > 0.0) != (its.arm > 0.0)) {
    throw InvalidInput::out_of_range("tangential arm", shown(its.arm) + " with inertia " + shown(its.inertia),
                                     "both above 0, or both 0", "it does not turn");
  }
  require("tangential cross", its.cross, finite, "by which the normal force turns the point along the surface");
  require("tangential compliance", its.compliance, finite, "c_t at the point");
  require("tangential compliance_error", its.compliance_error, not_negative, "of c_t");
}

}  // namespace

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

void require_body(const ModalBody& body) {
  require("mass", body.mass, positive, "of the body, as its point feels it");
  require("poisson", body.poisson, {-0.95, 0.4999, true, true, "-0.95 to 0.4999"}, "Poisson's ratio at the point");
  require("young", body.young, positive, "Young's modulus at the point");
  require("density", body.density, positive, "at the point");
  require("curvature", body.curvature, not_negative, "mean curvature at the point; a hollow one is not computed");
  require("curvature_difference", body.curvature_difference,
          {0.0, 2.0 * body.curvature, true, true, "0 to twice the mean curvature"}, "of the principal curvatures");
  require("compliance", body.compliance, finite, "c0 at the point");
  require("compliance_error", body.compliance_error, not_negative, "of c0");
  require("complete_to", body.complete_to, positive, "highest frequency up to which all modes are there");
  require_loss_time(body.loss_time * wave_speed(body) / own_length(body));
  require_modes(body);
  if (body.tangent) require_tangent(*body.tangent);
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
