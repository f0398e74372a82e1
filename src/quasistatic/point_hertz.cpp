// Huber's stresses with the root u of u² + Du − a²z² = 0, D = a² − r² − z²: h = 2u + D is √(D² + 4a²z²), w² = (h +
// D)/2a², and (1 − w³)/r² = q (1 + w + w²)/(a² (1 + w)) has no division by r.
#include "stoss/quasistatic/point_hertz.hpp"

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "bodies/sphere/mode_search.hpp"
#include "check.hpp"

namespace stoss::quasistatic {
namespace {

using std::numbers::pi;
constexpr double most = 1e100;

void require_pair(const PointPair& pair) {
  require("curvature", pair.curvature, {1.0 / most, most, true, true, "1e-100 to 1e100"}, "1/R1 + 1/R2, in 1/R");
  require("softness", pair.softness, {1.0 / most, most, true, true, "1e-100 to 1e100"},
          "(1 - nu1^2)/E1 + (1 - nu2^2)/E2, in 1/E");
}

void require_distance(double distance) {
  require("distance", distance, {0.0, std::numeric_limits<double>::max(), true, true, "0 or more"},
          "from the axis of the contact, in R");
}

PointHertz of_radius(const PointPair& pair, double radius) {
  PointHertz contact;
  contact.radius = radius;
  contact.approach = radius * radius * pair.curvature;
  contact.pressure = 2.0 * radius * pair.curvature / (pi * pair.softness);
  contact.force = 2.0 / 3.0 * pi * radius * radius * contact.pressure;
  contact.energy = 0.4 * contact.force * contact.approach;
  return contact;
}

/// 1 − arctan(x)/x
double excess_of_arctan(double x) {
  if (x > 0.1) return 1.0 - std::atan(x) / x;
  const double s = x * x;
  return s * (1.0 / 3.0 - s * (1.0 / 5.0 - s * (1.0 / 7.0 - s * (1.0 / 9.0 - s * (1.0 / 11.0 - s / 13.0)))));
}

}  // namespace

PointHertz point_hertz(const PointPair& pair, double force) {
  require_pair(pair);
  require("force", force, {0.0, most, true, true, "0 to 1e100"}, "in E R^2");
  PointHertz contact = of_radius(pair, std::cbrt(0.75 * force * pair.softness / pair.curvature));
  contact.force = force;
  return contact;
}

PointHertz point_hertz_of_approach(const PointPair& pair, double approach) {
  require_pair(pair);
  require("approach", approach, {0.0, most, true, true, "0 to 1e100"}, "of distant points of the bodies, in R");
  PointHertz contact = of_radius(pair, std::sqrt(approach / pair.curvature));
  contact.approach = approach;
  return contact;
}

double point_hertz_pressure(const PointHertz& contact, double distance) {
  require_distance(distance);
  const double a = contact.radius;
  return distance < a ? contact.pressure * std::sqrt((1.0 - distance / a) * (1.0 + distance / a)) : 0.0;
}

AxisymmetricStress point_hertz_stress(const PointHertz& contact, double poisson, double depth, double distance) {
  bodies::sphere::require_poisson(poisson);
  require("depth", depth, {0.0, std::numeric_limits<double>::max(), true, true, "0 or more"},
          "below the surface of the half-space, in R");
  require_distance(distance);
  if (contact.radius == 0.0) return {};
  // In units of a.
  const double z = depth / contact.radius, r = distance / contact.radius;
  const double inside = (contact.radius - distance) / contact.radius * (1.0 + r) - z * z;  // D
  const double h = std::hypot(z, r + 1.0) * std::hypot(z, (contact.radius - distance) / contact.radius);
  double root, w;  // √u
  if (inside >= 0.0) {
    w = std::sqrt(0.5 * (h + inside));
    root = w > 0.0 ? z / w : 0.0;
  } else {
    root = std::sqrt(0.5 * (h - inside));
    w = z / root;
  }
  const double q = 1.0 / (1.0 + root * root);
  const double b = (1.0 - 2.0 * poisson) / 3.0 * q * (1.0 + w + w * w) / (1.0 + w);
  const double pressed = h > 0.0 ? w * w * w / h : 0.0;
  const double sheared = h > 0.0 ? w * w * q * r * root / h : 0.0;
  const double e = root > 0.0 ? excess_of_arctan(1.0 / root) : 1.0;
  const double p = contact.pressure;
  return {.radial = p * (b + pressed - w * ((1.0 - poisson) * q + (1.0 + poisson) * e)),
          .hoop = -p * (b - w * ((1.0 - poisson) * q - (1.0 + poisson) * e)),
          .axial = -p * pressed,
          .shear = -p * sheared};
}

GreatestShear greatest_shear(const PointHertz& contact, double poisson) {
  bodies::sphere::require_poisson(poisson);
  if (contact.radius == 0.0) return {};
  const auto negative = [&](double z) {
    const AxisymmetricStress stress = point_hertz_stress(contact, poisson, z * contact.radius, 0.0);
    return 0.5 * (stress.axial - stress.radial);
  };
  constexpr double deepest = 2.0;  // the shear falls beyond 0.7 a for every Poisson's ratio
  constexpr int bits = 26;         // of the depth, and twice as many of the stress
  const auto [depth, shear] = boost::math::tools::brent_find_minima(negative, 0.0, deepest, bits);
  return {.depth = depth * contact.radius, .shear = -shear};
}

}  // namespace stoss::quasistatic
