#include "stoss/quasistatic/oblique/maw.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "check.hpp"
#include "quasistatic/oblique/tangential_contact.hpp"
#include "stoss/errors.hpp"

namespace stoss::quasistatic {
namespace {

/// With steps doubled until the error of the impulse, the larger one of what extrapolation adds and of what the last
/// doubling changed its result by, meets the tolerance.
MawImpact refined(double psi1, double chi, double tolerance) {
  constexpr int max_steps = 1 << 20;
  const double allowed = tolerance * std::min(psi1, 1.0) / std::max(4.0 * chi, 1.0);
  int steps = 64 * static_cast<int>(std::ceil(std::sqrt(1.0 + chi)));  // frequencies grow as √χ
  double coarse = maw_path(psi1, chi, steps).impulse;
  steps *= 2;
  double fine = maw_path(psi1, chi, steps).impulse, extrapolated = fine + (fine - coarse) / 3.0;
  for (steps *= 2; steps <= max_steps; steps *= 2) {
    MawImpact impact = maw_path(psi1, chi, steps);
    const double before = extrapolated, added = (impact.impulse - fine) / 3.0;
    fine = impact.impulse;
    extrapolated = impact.impulse = fine + added;
    impact.impulse_error = std::max(std::abs(added), std::abs(extrapolated - before));
    if (impact.impulse_error <= allowed) return impact;
  }
  std::ostringstream message;
  message << "psi2 of psi1 = " << psi1 << " and chi = " << chi << " does not converge to " << tolerance
          << ": raise the tolerance";
  throw NotConverged(message.str());
}

}  // namespace

double sliding_limit(double chi) {
  require("chi", chi, {0.0, 1e3, false, true, "above 0 to 1000"}, "kappa (1 + 1/K^2)/2 with K^2 = I/(m R^2)");
  return std::max(1.0, 4.0 * chi - 1.0);
}

MawImpact maw(double psi1, double chi, double tolerance) {
  const double limit = sliding_limit(chi), size = std::abs(psi1);
  require("psi1", psi1, {-1e6, 1e6, true, true, "-1e6 to 1e6"}, "kappa s/(mu v_n) with the speed of sliding s");
  require("tolerance", tolerance, {1e-8, 0.1, true, true, "1e-8 to 0.1"},
          "error of psi2 and impulse, over psi1 where that is below 1");
  MawImpact impact{.impulse = 1.0, .sliding = 1.0};
  if (size < limit) impact = refined(size, chi, tolerance);
  impact.psi1 = psi1;
  impact.chi = chi;
  impact.impulse *= std::copysign(1.0, psi1);
  impact.psi2 = psi1 - 4.0 * chi * impact.impulse;
  impact.psi2_error = 4.0 * chi * impact.impulse_error;
  impact.friction_loss = 4.0 * impact.impulse * (psi1 - 2.0 * chi * impact.impulse);
  return impact;
}

}  // namespace stoss::quasistatic
