#include "stoss/quasistatic/yield.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss::quasistatic {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What Hertz' impact knows of one sphere; of two, what their series is.
struct Hertzian {
  double compliance;    ///< 1/E*, 0 of a rigid sphere
  double curvature;     ///< 1/R, 0 of a half-space
  double inverse_mass;  ///< 1/m, 0 of a half-space
};

Hertzian of_sphere(const Material& material, double radius) {
  (void)scales(material, Plane::stress, radius);  // refuses what is out of range
  const double volume = 4.0 * std::numbers::pi / 3.0 * radius * radius * radius;
  return {(1.0 - material.poisson * material.poisson) / material.young, 1.0 / radius,
          1.0 / (volume * material.density)};
}

/// A sphere, or what is the limit of spheres.
Hertzian of_any(const Material& material, double radius) {
  constexpr double any = 1.0;
  Material elastic = material;
  if (material.young == infinity) elastic.young = any;
  Hertzian hertzian = of_sphere(elastic, radius == infinity ? any : radius);
  if (material.young == infinity) hertzian.compliance = 0.0;
  if (radius == infinity) hertzian.curvature = hertzian.inverse_mass = 0.0;
  return hertzian;
}

double strength_of(const Material& material) {
  return material.young == infinity ? infinity : material.yield_strength.value_or(infinity);
}

/// The power is taken last, so that no material overflows.
double speed_at(const Hertzian& hertzian, double pressure) {
  const double& curvature = hertzian.curvature;
  const double strain = 0.5 * std::numbers::pi * pressure * hertzian.compliance;  // a/R
  const double square = hertzian.inverse_mass / (hertzian.compliance * curvature * curvature * curvature);
  return std::sqrt(16.0 / 15.0 * square) * std::pow(strain, 2.5);
}

}  // namespace

std::optional<double> yield_speed(const Material& material, double radius) {
  const Hertzian hertzian = of_sphere(material, radius);
  if (!material.yield_strength) return std::nullopt;
  return speed_at(hertzian, yield_pressure_ratio * *material.yield_strength);
}

std::optional<double> yield_speed(const Material& first, double first_radius, const Material& second,
                                  double second_radius) {
  const Hertzian one = of_any(first, first_radius), other = of_any(second, second_radius);
  const Hertzian both{one.compliance + other.compliance, one.curvature + other.curvature,
                      one.inverse_mass + other.inverse_mass};
  if (both.curvature == 0.0) throw InvalidInput::conflict("radius", "both are infinite, and one must be a sphere");
  if (both.compliance == 0.0)
    throw InvalidInput::conflict("young", "both bodies are rigid, and one of them must deform");
  const double strength = std::min(strength_of(first), strength_of(second));
  if (strength == infinity) return std::nullopt;
  return speed_at(both, yield_pressure_ratio * strength);
}

double yield_speed(const PointPair& pair, double mass, double yield_strength) {
  (void)point_hertz(pair, 0.0);  // refuses what is out of range
  constexpr Range positive{1e-100, 1e100, true, true, "1e-100 to 1e100"};
  require("mass", mass, positive, "reduced mass");
  require("yield_strength", yield_strength, positive, "in simple tension");
  return speed_at({pair.softness, pair.curvature, 1.0 / mass}, yield_pressure_ratio * yield_strength);
}

}  // namespace stoss::quasistatic
