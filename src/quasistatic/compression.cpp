// The kernel of a sphere is that of a half-space and Σ_n D_n P_n(cos θ) = −g ln(θ/2) + K₁ + O(θ). From the closed
// flexibilities, n ≥ 2,
//
//   D_n = r/(n − 1) + (αn + β)/(n² + (1 + 2ν) n + 1 + ν),   r = 1/(4(1 − ν)), α = g − r, β = (1 + ν)(D₀ + r),
//
// so that D_n − g/n is a series in 1/n from n⁻² on. K₁ is summed up to a degree and from there by that series.
#include "stoss/quasistatic/compression.hpp"

#include <algorithm>
#include <boost/math/special_functions/polygamma.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "bodies/sphere/mode_search.hpp"
#include "check.hpp"
#include "quasistatic/laws.hpp"
#include "stoss/bodies/sphere/modes.hpp"

namespace stoss::quasistatic {
namespace {

using std::numbers::pi;
constexpr double rounding = std::numeric_limits<double>::epsilon();

/// The root u ≥ 1 of u − ln u = 1 + η, which is −W₋₁(−e^{−1−η}). It is convex, so that Newton's method descends to the
/// root from the bound u ≤ 1 + √(2η) + η (Chatzigeorgiou, IEEE Commun. Lett. 17, 1505, 2013).
double lower_branch(double eta) {
  double u = 1.0 + std::sqrt(2.0 * eta) + eta;
  constexpr int max_steps = 60;
  for (int step = 0; step < max_steps && u > 1.0; ++step) {
    const double next = u - (u - 1.0 - std::log(u) - eta) * u / (u - 1.0);
    if (!(next < u)) break;
    u = next;
  }
  return u;
}

/// Coefficient of the logarithm.
double log_factor(double poisson) { return 0.5 * (1.0 - 2.0 * poisson) * (1.0 - 2.0 * poisson) / (1.0 - poisson); }

/// D_n
double excess_flexibility(double poisson, int degree) {
  return 0.75 * bodies::sphere::static_flexibility(poisson, degree).radial / (1.0 - poisson * poisson) - 1.0;
}

/// The x > 0 at which a growing function with the given slope vanishes.
template <typename Function>
double root(Function function, double guess, double highest) {
  constexpr int digits = std::numeric_limits<double>::digits - 2;
  std::uintmax_t steps = 100;
  return boost::math::tools::newton_raphson_iterate(function, std::min(guess, highest), 0.0, highest, digits, steps);
}

/// What a function has of a law and a Poisson's ratio.
template <typename Function>
double with(StaticLaw law, double poisson, Function function) {
  if (const auto* line = std::get_if<CompressionLaw>(&law)) return function(LineLaw(*line, poisson));
  return function(RadiusLaw(std::get<PointLaw>(law), poisson));
}

/// The size of the contact under a force.
template <typename Law>
double size(const Law& law, double force) {
  require("force", force,
          {0.0, law.force(law.limit()) * (1.0 + 8.0 * rounding), true, true, "0 to limit_force(law, poisson)"},
          "in units of m c^2/R; there the law has a maximum, or the contact is as wide as the sphere");
  return std::min(law.at_force(force), law.limit());
}

}  // namespace

double center_constant(double poisson) {
  bodies::sphere::require_poisson(poisson);
  const double g = log_factor(poisson);
  constexpr int first = 32;  // degree of the series
  constexpr int terms = 14;
  double sum = excess_flexibility(poisson, 0);
  const double r = 0.25 / (1.0 - poisson), beta = (1.0 + poisson) * (sum + r);
  for (int n = 1; n < first; ++n) sum += excess_flexibility(poisson, n) - g / n;
  double before = 0.0, here = g - r;  // of (αn + β)/(n² + …) in 1/n
  double factorial = 1.0;
  for (int k = 2; k <= terms; ++k) {
    const double next = (k == 2 ? beta : 0.0) - (1.0 + 2.0 * poisson) * here - (1.0 + poisson) * before;
    before = here, here = next;
    factorial *= k - 1;
    const double sign = k % 2 == 0 ? 1.0 : -1.0;
    sum += (r + here) * sign * boost::math::polygamma(k - 1, static_cast<double>(first)) / factorial;
  }
  return sum;
}

LineLaw::LineLaw(CompressionLaw law, double poisson) {
  require_poisson(poisson);
  limit_ = law == CompressionLaw::center ? std::exp(-1.0 - 0.25 * (1.0 + poisson)) : 4.0 * std::exp(-2.0);
}

double LineLaw::compression(double x) const { return x > 0.0 ? x * (1.0 + std::log(limit_ / x)) : 0.0; }

double LineLaw::energy(double x) const { return x > 0.0 ? x * x * (0.25 + 0.5 * std::log(limit_ / x)) : 0.0; }

double LineLaw::at_compression(double compression) const {
  return compression > 0.0 ? compression / lower_branch(std::fmax(0.0, std::log(limit_ / compression))) : 0.0;
}

RadiusLaw::RadiusLaw(PointLaw law, double poisson) : RadiusLaw(law, poisson, 1.0 - poisson * poisson) {}

RadiusLaw::RadiusLaw(PointLaw law, double poisson, double softness) : scale_(1.0 / (pi * softness)) {
  bodies::sphere::require_poisson(poisson);
  if (law == PointLaw::hertz) return;
  const double factor = 4.0 / (3.0 * pi) * ((1.0 - poisson * poisson) / softness);
  const double g = log_factor(poisson);
  logarithm_ = factor * g;
  constant_ = factor * (g * (19.0 / 12.0 - std::numbers::ln2) + center_constant(poisson) -
                        0.5 * (1.0 - 2.0 * poisson) / (1.0 - poisson));
  // The slope rises from a while the logarithm wins and then falls: it vanishes once at most.
  if (half_slope(1.0) >= 0.0) return;
  double low = 0.0, high = 1.0;
  while (high - low > rounding) {
    const double middle = 0.5 * (low + high);
    (middle > 0.0 && half_slope(middle) < 0.0 ? high : low) = middle;
  }
  limit_ = low;
}

double RadiusLaw::half_slope(double a) const {
  return 1.0 + 0.5 * a * (3.0 * constant_ - logarithm_ * (1.0 + 3.0 * std::log(a)));
}

double RadiusLaw::at_force(double force) const { return std::min(std::cbrt(force / scale_), limit_); }

double RadiusLaw::compression(double a) const {
  return a > 0.0 ? a * a * (1.0 + a * (constant_ - logarithm_ * std::log(a))) : 0.0;
}

double RadiusLaw::energy(double a) const {
  if (!(a > 0.0)) return 0.0;
  const double beyond = 0.5 * constant_ - logarithm_ / 12.0 - 0.5 * logarithm_ * std::log(a);
  return scale_ * a * a * a * a * a * (0.4 + a * beyond);
}

double RadiusLaw::stiffness(double a) const { return a > 0.0 ? 1.5 * scale_ * a / half_slope(a) : 0.0; }

double RadiusLaw::at_compression(double compression) const {
  if (!(compression > 0.0)) return 0.0;
  const double unit = std::sqrt(compression);
  // a = unit x, and √(δ/a²) x − 1 = 0 is nearly linear.
  const auto function = [&](double x) {
    const double a = unit * x;
    const double reached = this->compression(a) / compression;
    return std::pair{reached - 1.0, x > 0.0 ? 2.0 * x * half_slope(a) : 0.0};
  };
  return std::min(unit * root(function, 1.0, limit_ / unit), limit_);
}

double RadiusLaw::at_energy(double energy) const {
  if (!(energy > 0.0)) return 0.0;
  const double unit = std::pow(2.5 * energy / scale_, 0.2);
  const auto function = [&](double x) {
    const double a = unit * x;
    const double x4 = x * x * x * x;
    return std::pair{this->energy(a) / energy - 1.0, x > 0.0 ? 5.0 * x4 * half_slope(a) : 0.0};
  };
  return std::min(unit * root(function, 1.0, limit_ / unit), limit_);
}

double limit_force(StaticLaw law, double poisson) {
  return with(law, poisson, [](const auto& its) { return its.force(its.limit()); });
}

double compression(StaticLaw law, double poisson, double force) {
  return with(law, poisson, [force](const auto& its) { return its.compression(size(its, force)); });
}

double compression_force(StaticLaw law, double poisson, double compression) {
  return with(law, poisson, [compression](const auto& its) {
    require("compression", compression,
            {0.0, its.compression(its.limit()) * (1.0 + 8.0 * rounding), true, true,
             "0 to compression(law, poisson, limit_force)"},
            "in units of R; the law ends there");
    return its.force(its.at_compression(compression));
  });
}

double compression_energy(StaticLaw law, double poisson, double force) {
  return with(law, poisson, [force](const auto& its) { return its.energy(size(its, force)); });
}

double contact_radius(PointLaw law, double poisson, double force) { return size(RadiusLaw(law, poisson), force); }

PointHertz point_hertz_at_wall(double poisson, double force) {
  const double radius = contact_radius(PointLaw::hertz, poisson, force);
  return point_hertz_of_approach({1.0, 1.0 - poisson * poisson}, radius * radius);
}

}  // namespace stoss::quasistatic
