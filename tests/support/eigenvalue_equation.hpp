#pragma once

#include <boost/math/special_functions/bessel.hpp>
#include <cmath>

namespace stoss::test {

/// The left side of the paper's eigenvalue equations as printed, R = 1: eq. (24) for n ≥ 1, eq. (20) for n = 0,
/// from J_{n−1} and J_n (J_0 and J_1 for n = 0) at κ and κ′.
template <typename Real>
Real eigenvalue_equation(const Real& poisson, int n, const Real& kappa, const Real& kappa_shear, const Real& below,
                         const Real& here, const Real& below_shear, const Real& here_shear) {
  if (n == 0) return kappa * below - here + poisson * here;
  const Real soft = 1 - poisson;
  const Real square = kappa * kappa;
  const Real order = n;
  const Real x = kappa * below;
  const Real y = kappa_shear * below_shear;
  return soft * soft * (1 - order * order) * x * y +
         soft * (square - soft * (1 - order * order) * order) * (x * here_shear + y * here) +
         (square * square - 2 * (order * order + order) * soft * square) * here * here_shear;
}

/// The same with the Bessel functions of Boost in the precision of Real.
template <typename Real>
Real eigenvalue_equation(const Real& poisson, int n, const Real& omega) {
  using boost::math::cyl_bessel_j;
  using std::sqrt;
  const Real kappa = omega * sqrt(Real(1 - poisson * poisson));
  const Real kappa_shear = omega * sqrt(Real(2 * (1 + poisson)));
  const int lower = n == 0 ? 0 : n - 1;
  return eigenvalue_equation<Real>(poisson, n, kappa, kappa_shear, cyl_bessel_j(lower, kappa),
                                   cyl_bessel_j(lower + 1, kappa), cyl_bessel_j(lower, kappa_shear),
                                   cyl_bessel_j(lower + 1, kappa_shear));
}

}  // namespace stoss::test
