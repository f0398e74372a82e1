#include "stoss/quasistatic/yield.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stoss::quasistatic {
namespace {

/// What Hertz' impact knows of one sphere; of two, what their series is.
struct Hertzian {
  double compliance;    ///< 1/E*
  double curvature;     ///< 1/R
  double inverse_mass;  ///< 1/m
};

Hertzian of_sphere(const Material& material, double radius) {
  (void)scales(material, Plane::stress, radius);  // refuses what is out of range
  const double volume = 4.0 * std::numbers::pi / 3.0 * radius * radius * radius;
  return {(1.0 - material.poisson * material.poisson) / material.young, 1.0 / radius,
          1.0 / (volume * material.density)};
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
  const Hertzian one = of_sphere(first, first_radius), other = of_sphere(second, second_radius);
  if (!first.yield_strength && !second.yield_strength) return std::nullopt;
  constexpr double unbreakable = std::numeric_limits<double>::infinity();
  const double strength =
      std::min(first.yield_strength.value_or(unbreakable), second.yield_strength.value_or(unbreakable));
  const Hertzian both{one.compliance + other.compliance, one.curvature + other.curvature,
                      one.inverse_mass + other.inverse_mass};
  return speed_at(both, yield_pressure_ratio * strength);
}

}  // namespace stoss::quasistatic
