// 1 − (1 − x)^p is −expm1(p log1p(−x)), without a difference where x is small.
#include "stoss/quasistatic/oblique/mindlin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bodies/sphere/mode_search.hpp"
#include "check.hpp"

namespace stoss::quasistatic {
namespace {

constexpr double any_finite = std::numeric_limits<double>::max();

void require_tangential(double tangential) {
  require("tangential", tangential, {-1.0, 1.0, true, true, "-1 to 1"}, "T/(mu N); beyond, the contact slides");
}

/// 1 − (1 − |x|)^power with the sign of x.
double complement(double x, double power) {
  return std::copysign(-std::expm1(power * std::log1p(-std::min(std::abs(x), 1.0))), x);
}

/// √(a² − r²)
double half_ellipse(double radius, double distance) {
  return distance < radius ? std::sqrt((radius - distance) * (radius + distance)) : 0.0;
}

}  // namespace

double mindlin_ratio(double poisson) {
  bodies::sphere::require_poisson(poisson);
  return 2.0 * (1.0 - poisson) / (2.0 - poisson);
}

double mindlin_force(double displacement) {
  require("displacement", displacement, {-any_finite, any_finite, true, true, "any finite number"},
          "over that at which the contact slides");
  return complement(displacement, 1.5);
}

double mindlin_displacement(double tangential) {
  require_tangential(tangential);
  return complement(tangential, 2.0 / 3.0);
}

double mindlin_stick_radius(double tangential) {
  require_tangential(tangential);
  return std::cbrt(1.0 - std::abs(tangential));
}

double mindlin_traction(double tangential, double distance) {
  const double stick = mindlin_stick_radius(tangential);
  require("distance", distance, {0.0, any_finite, true, true, "0 or more"}, "from the axis, over the radius");
  return std::copysign(half_ellipse(1.0, distance) - half_ellipse(stick, distance), tangential);
}

}  // namespace stoss::quasistatic
