// δ(F) has its maximum at F* = s e^{−1−b}, where δ = F*. Written with F*, both laws are one:
//
//   δ = F u,   U = F² (½u − ¼),   u = 1 + ln(F*/F) ≥ 1.
#include "stoss/quasistatic/compression.hpp"

#include <cmath>
#include <limits>

#include "check.hpp"

namespace stoss::quasistatic {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

void require_force(double force, double limit) {
  require("force", force, {0.0, limit, true, true, "0 to limit_force(law, poisson)"},
          "in units of pi R E; the law ends where its compression has a maximum");
}

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

}  // namespace

double limit_force(CompressionLaw law, double poisson) {
  require_poisson(poisson);
  return law == CompressionLaw::center ? std::exp(-1.0 - 0.25 * (1.0 + poisson)) : 4.0 * std::exp(-2.0);
}

double compression(CompressionLaw law, double poisson, double force) {
  const double limit = limit_force(law, poisson);
  require_force(force, limit);
  return force == 0.0 ? 0.0 : force * (1.0 + std::log(limit / force));
}

double compression_force(CompressionLaw law, double poisson, double compression) {
  const double limit = limit_force(law, poisson);
  require("compression", compression,
          {0.0, limit * (1.0 + 8.0 * epsilon), true, true, "0 to compression(law, poisson, limit_force)"},
          "in units of R; the law has no force beyond its maximum");
  if (compression == 0.0) return 0.0;
  return compression / lower_branch(std::fmax(0.0, std::log(limit / compression)));
}

double compression_energy(CompressionLaw law, double poisson, double force) {
  const double limit = limit_force(law, poisson);
  require_force(force, limit);
  return force == 0.0 ? 0.0 : force * force * (0.25 + 0.5 * std::log(limit / force));
}

}  // namespace stoss::quasistatic
