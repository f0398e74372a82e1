#include "bodies/disk/radial_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bodies/disk/mode_search.hpp"
#include "check.hpp"
#include "numeric/bessel.hpp"

namespace stoss::bodies::disk {

StaticField static_field(double poisson, int order, double normal, double shear) {
  StaticField field;
  if (order == 0) {
    field.radial_high = (1.0 - poisson) * normal;
    field.rr_edge = field.pp_edge = normal;
    return field;
  }
  field.rr_edge = normal;
  field.rp_edge = shear;
  field.pp_edge = normal + 2.0 * shear;
  if (order == 1) {
    const double b = 0.25 * (normal + shear), g = normal - shear;
    field.radial_high = (1.0 - 3.0 * poisson) * b + 0.25 * (1.0 + poisson) * g;
    field.tangential_high = (5.0 + poisson) * b - 0.75 * (1.0 + poisson) * g;
    field.radial_low = 0.25 * (field.tangential_high - field.radial_high);
    field.tangential_low = -field.radial_low;
    return field;
  }
  const double n = order;
  const double b = 0.5 * (normal + shear) / (n + 1.0);
  const double below = 0.5 * ((2.0 - n) * shear - n * normal);  // n(n−1)a
  field.radial_low = -(1.0 + poisson) * below / (n - 1.0);
  field.tangential_low = -field.radial_low;
  field.radial_high = -((n - 2.0) + poisson * (n + 2.0)) * b;
  field.tangential_high = (n + 4.0 + poisson * n) * b;
  field.rr_below = -below;
  field.pp_below = field.rp_below = below;
  return field;
}

namespace {

/// Ratio of the same Bessel function at two arguments, given as scaled pairs.
struct Ratio {
  double value;  // J_n(κr)/J_n(κ) times the edge value
  double next;
};

Ratio rescaled(const numeric::BesselPair& inside, const numeric::BesselPair& edge) {
  const int shift = inside.exponent - edge.exponent;
  return {std::ldexp(inside.value, shift), std::ldexp(inside.next, shift)};
}

}  // namespace

std::vector<RadialField> mode_field(double poisson, const Mode& mode, std::span<const double> radii, const Poll& poll) {
  require_poisson(poisson);
  require("order", static_cast<long>(mode.order), 0, 1'000'000, "angular order of the mode");
  require("omega", mode.omega, {0.0, max_cutoff, false, true, "above 0 and up to 1000"},
          "frequency of the mode in c/R");
  constexpr Range inside{0.0, 1.0, true, true, "0 to 1"};
  for (const double radius : radii) require("radius", radius, inside, "in units of the radius of the disk");
  const double kappa = std::sqrt(1.0 - poisson * poisson) * mode.omega;
  const double kappa_shear = std::sqrt(2.0 * (1.0 + poisson)) * mode.omega;
  const double n = mode.order;
  const double m = n * (n - 1.0);

  std::vector<numeric::BesselPair> pairs(static_cast<std::size_t>(mode.order) + 1);
  // Scaled to about 1: the norm of a vibration is of the fourth degree in them.
  const numeric::BesselPair pressure = numeric::last_pair(kappa, pairs);
  const numeric::BesselPair shear = numeric::last_pair(kappa_shear, pairs);
  double a = -mode.radial / pressure.next;  // n = 0: u_r = A κ J_0'(κr)
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
    // The limit at the centre: evaluate next to it.
    const double r = std::max(radius, 1e-30);
    numeric::bessel_pairs(kappa * r, pairs);
    const Ratio p = rescaled(pairs.back(), pressure);
    numeric::bessel_pairs(kappa_shear * r, pairs);
    const Ratio s = rescaled(pairs.back(), shear);
    const double y = 0.5 * kappa_shear * kappa_shear * r * r;
    const double sum = a * p.value + b * s.value;
    const double large = m * sum;
    const double factor = 1.0 / ((1.0 + poisson) * r * r);
    field.push_back({(n * sum - a * p.next) / r, (b * s.next - n * sum) / r,
                     factor * (large - y * a * p.value + a * p.next - n * b * s.next),
                     factor * (-large - poisson * y * a * p.value - a * p.next + n * b * s.next),
                     factor * (-large + y * b * s.value + n * a * p.next - b * s.next)});
  }
  return field;
}

}  // namespace stoss::bodies::disk
