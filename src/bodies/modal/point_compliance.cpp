#include "bodies/modal/point_compliance.hpp"

#include <cmath>
#include <numbers>

#include "bodies/sphere/along/toroidal.hpp"
#include "bodies/sphere/degree_sums.hpp"
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

}  // namespace stoss::bodies::modal
