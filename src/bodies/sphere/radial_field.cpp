#include "bodies/sphere/radial_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bodies/sphere/mode_search.hpp"
#include "check.hpp"

namespace stoss::bodies::sphere {
namespace {

/// n = 1: a translation, and the field r² that the inertia of the accelerated sphere and the load make.
StaticField accelerated(double poisson, double normal, double shear) {
  const double load = (normal + 2.0 * shear) / (1.0 - poisson);
  const double s = 0.1 * load * (1.0 + poisson) * (1.0 - 2.0 * poisson);
  const double a = 0.5 * shear - s / (1.0 + poisson);
  StaticField field;
  field.radial_low = field.tangential_low = -(2.0 * a + s);
  field.radial_high = 2.0 * (4.0 * poisson - 1.0) * a + 3.0 * s;
  field.tangential_high = (6.0 - 4.0 * poisson) * a + s;
  field.rr_edge = normal;
  field.rt_edge = shear;
  field.hoop_edge = (2.0 * s - (8.0 + 8.0 * poisson) * a) / (1.0 + poisson) + poisson * load;
  return field;
}

}  // namespace

StaticField static_field(double poisson, int order, double normal, double shear) {
  StaticField field;
  if (order == 0) {
    field.radial_high = (1.0 - 2.0 * poisson) * normal;
    field.rr_edge = field.hoop_edge = normal;
    return field;
  }
  if (order == 1) return accelerated(poisson, normal, shear);
  const double n = order;
  const double soft = 1.0 + poisson;
  const double a = -soft * (normal - n * shear) / (2.0 * (n * n + n + 1.0 + (2.0 * n + 1.0) * poisson));
  const double low = soft * shear - a * (n * n + 2.0 * n - 1.0 + 2.0 * poisson);  // (n−1)B
  const double b = low / (n - 1.0);
  field.radial_low = n * b;
  field.tangential_low = b;
  field.radial_high = (n + 1.0) * (n - 2.0 + 4.0 * poisson) * a;
  field.tangential_high = (n + 5.0 - 4.0 * poisson) * a;
  field.rr_below = n * low / soft;
  field.rr_edge = normal;
  field.rt_below = field.hoop_below = low / soft;
  field.rt_edge = shear;
  field.hoop_edge = shear - a * (4.0 * n + 6.0 + poisson * n * (4.0 * n + 6.0)) / soft;
  field.bend_below = b / soft;
  field.bend_edge = (soft * shear + 2.0 * a * (n - 2.0 - poisson * (2.0 * n - 1.0))) / (soft * (n - 1.0));
  return field;
}

namespace {

using numeric::BesselKind;
using numeric::BesselPair;

/// A j_n(κr) and A κr j_{n+1}(κr), for A in units of the scale at the surface.
struct Wave {
  double value, next;
};

Wave wave_inside(double x, double amplitude, const BesselPair& surface, std::vector<BesselPair>& pairs) {
  numeric::bessel_pairs(x, pairs, BesselKind::spherical);
  const BesselPair& inside = pairs.back();
  const int shift = inside.exponent - surface.exponent;
  return {amplitude * std::ldexp(inside.value, shift), amplitude * std::ldexp(inside.next, shift)};
}

/// @param y κ′²r²/2
RadialField field_of(double n, double poisson, double r, double y, const Wave& p, const Wave& s) {
  const double volume = poisson / (1.0 - poisson) * y * p.value;  // −λ/2μ r² div u
  const double factor = 1.0 / ((1.0 + poisson) * r * r);
  if (n == 0.0) {
    return {-p.next / r, 0.0, factor * (2.0 * p.next - y * p.value), 0.0, -factor * (volume + p.next), 0.0};
  }
  const double m = n * (n - 1.0);
  const double sum = p.value + (n + 1.0) * s.value;
  const double slide = (n - 1.0) * sum - p.next + s.next;  // r(u_r − u_θ)
  RadialField field;
  field.radial = (n * sum - p.next) / r;
  field.tangential = (sum - s.next) / r;
  field.stress_rr = factor * (m * sum - y * p.value + 2.0 * p.next - n * (n + 1.0) * s.next);
  field.stress_rt = factor * (slide - y * s.value);
  field.hoop = factor * (slide - volume);
  field.bend = n > 1.0 ? factor * (sum - s.next) : 0.0;
  return field;
}

}  // namespace

std::vector<RadialField> mode_field(double poisson, const Mode& mode, std::span<const double> radii, const Poll& poll) {
  require_poisson(poisson);
  require("order", static_cast<long>(mode.order), 0, 1'000'000, "degree of the mode");
  require("omega", mode.omega, {0.0, max_cutoff, false, true, "above 0 and up to 1000"},
          "frequency of the mode in c/R");
  constexpr Range inside{0.0, 1.0, true, true, "0 to 1"};
  for (const double radius : radii) require("radius", radius, inside, "in units of the radius of the sphere");
  const WaveSpeeds speed = wave_speeds(poisson);
  const double kappa = mode.omega / speed.pressure, kappa_shear = mode.omega / speed.shear;

  std::vector<BesselPair> pairs(static_cast<std::size_t>(mode.order) + 1);
  // Scaled to about 1: the norm of a vibration is of the fourth degree in them.
  const BesselPair pressure = numeric::last_pair(kappa, pairs, BesselKind::spherical);
  const BesselPair shear = numeric::last_pair(kappa_shear, pairs, BesselKind::spherical);
  double a = -mode.radial / pressure.next;  // n = 0: u_r = A κ j_0'(κr)
  double b = 0.0;
  if (mode.order > 0) {
    const auto vibration = EdgeProblem{mode.order, kappa, kappa_shear, pressure, shear}.vibration();
    a = vibration.pressure;
    b = vibration.shear;
  }
  std::vector<RadialField> field;
  field.reserve(radii.size());
  for (const double radius : radii) {
    if (poll) poll();
    const double r = std::max(radius, 1e-30);  // the limit at the centre: evaluate next to it
    const double y = 0.5 * kappa_shear * kappa_shear * r * r;
    field.push_back(field_of(mode.order, poisson, r, y, wave_inside(kappa * r, a, pressure, pairs),
                             wave_inside(kappa_shear * r, b, shear, pairs)));
  }
  return field;
}

}  // namespace stoss::bodies::sphere
