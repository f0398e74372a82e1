#include "stoss/material.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

// Far beyond any material, and so that no scale overflows.
constexpr Range positive{1e-30, 1e30, true, true, "above 0, 1e-30 to 1e30"};

void validate(const Material& material) {
  require("young", material.young, positive, "Young's modulus in Pa; steel has 2.1e11");
  require("density", material.density, positive, "in kg/m^3; steel has 7850");
  require("poisson", material.poisson, {-1.0, 0.5, false, false, "above -1 and below 0.5"},
          "Poisson's ratio of the material; steel has 0.3");
  constexpr double any = 1.0;
  require("yield_strength", material.yield_strength.value_or(any), positive, "in Pa; steel has 2e8 to 2e9");
  require("surface_energy", material.surface_energy.value_or(0.0), {0.0, 1e6, true, true, "0 to 1e6"},
          "in J/m^2; glass has 0.02 to 0.3");
}

}  // namespace

double plane_poisson(const Material& material, Plane plane) {
  validate(material);
  return plane == Plane::stress ? material.poisson : material.poisson / (1.0 - material.poisson);
}

double loss_time_of_quality(double quality, double frequency) {
  require("quality", quality, positive,
          "1/Q is the tangent of the angle of loss; steel has 1e3 to 1e4, rubber 5 to 20");
  require("frequency", frequency, positive, "at which the material has this quality, in radians per unit of time");
  return 1.0 / (quality * frequency);
}

Material material_of_wave_speeds(double c_p, double c_s, double density) {
  require("c_s", c_s, positive, "speed of transverse waves, m/s; steel has 3200");
  require("density", density, positive, "in kg/m^3; steel has 7850");
  const double least = std::sqrt(4.0 / 3.0) * c_s;
  if (!(c_p > least) || !(c_p <= positive.high)) {
    throw InvalidInput::out_of_range("c_p", shown(c_p), "above sqrt(4/3) c_s, " + shown_least(least) + " m/s",
                                     "speed of longitudinal waves; steel has 5900");
  }
  const double p = c_p * c_p, s = c_s * c_s;
  return {.young = density * s * (3.0 * p - 4.0 * s) / (p - s),
          .poisson = 0.5 * (p - 2.0 * s) / (p - s),
          .density = density};
}

Scales scales(const Material& material, Plane plane, double radius) {
  validate(material);
  require("radius", radius, positive, "in m");
  const double nu = material.poisson;
  const double modulus = plane == Plane::stress ? material.young : material.young / (1.0 - nu * nu);
  const double speed = std::sqrt(modulus / material.density);
  return {radius, speed, radius / speed, speed / radius, std::numbers::pi * radius * modulus};
}

}  // namespace stoss
