#include "bodies/disk/parity/torsion.hpp"

#include <cmath>

#include "bodies/mode_search.hpp"
#include "numeric/bessel.hpp"

namespace stoss::bodies::disk {

Torsion::Torsion(double poisson, double cutoff)
    : missing_compliance_((1.0 + poisson) / 6.0), missing_second_moment_((1.0 + poisson) * (1.0 + poisson) / 144.0) {
  const double per_omega = std::sqrt(2.0 * (1.0 + poisson));
  std::vector<numeric::BesselPair> pairs(3);
  const auto second_order = [&](double k) {
    numeric::bessel_pairs(k, pairs);
    return std::ldexp(pairs[2].value, pairs[2].exponent);
  };
  for (const double k : breathing_roots(second_order, per_omega, cutoff)) {
    const double omega = k / per_omega, compliance = 1.0 / (omega * omega);
    omega_.push_back(omega);
    missing_compliance_ -= compliance;
    missing_second_moment_ -= compliance * compliance;
  }
}

}  // namespace stoss::bodies::disk
