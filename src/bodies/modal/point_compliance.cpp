#include "bodies/modal/point_compliance.hpp"

#include <cmath>
#include <numbers>

#include "stoss/bodies/sphere/modes.hpp"

namespace stoss::bodies::modal {

double logarithm_share(double poisson) {
  const double incompressible = 1.0 - 2.0 * poisson;
  return incompressible * incompressible / (2.0 * (1.0 - poisson));
}

// The pole moves by (1/m) Σ (R^UU P_n − R^UV sin θ dP_n/dθ). With R^UU/m → A + B/n and R^UV/m → C/n these sums are
// A/θ − B ln(θ/2) + C, and what is left of R^UU falls as 1/n².
double sphere_constant(double poisson) {
  constexpr double mass = 4.0 * std::numbers::pi / 3.0;
  constexpr int terms = 20000;
  const double plain = (1.0 - poisson * poisson) / std::numbers::pi;
  const double slow = plain * logarithm_share(poisson);
  const auto left = [&](int n) { return sphere::static_flexibility(poisson, n).radial / mass - plain - slow / n; };
  double sum = sphere::static_flexibility(poisson, 0).radial / mass - plain;
  for (int n = 1; n < terms; ++n) sum += left(n);
  const double last = left(terms);
  sum += 0.5 * last + last * terms;  // Euler and Maclaurin of 1/n²
  const double turning = terms * sphere::static_flexibility(poisson, terms).mixed / mass;
  return sum + slow * std::numbers::ln2 + turning;
}

}  // namespace stoss::bodies::modal
