// The modes of a free disk: those of n = 0 directly, all others by the search that round bodies share.
#include "bodies/disk/mode_search.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "bodies/disk/edge_problem.hpp"
#include "bodies/mode_checks.hpp"
#include "bodies/mode_search.hpp"
#include "numeric/bessel.hpp"

namespace stoss::bodies::disk {
namespace {

/// The slowest Rayleigh wave on any disk with −0.95 ≤ ν ≤ 0.995 runs at 0.478 c, and ω_{n,0} > n c_R / R.
constexpr double slowest_edge_wave = 0.47;

/// n = 0 (paper eq. (20)): κ J_1' + ν J_1 = 0. κ J_1'/J_1 falls from 1 between its poles, so there is exactly
/// one root before each zero of J_1.
std::vector<Mode> radial_modes(double poisson, double cutoff) {
  const double per_omega = std::sqrt(1.0 - poisson * poisson);
  std::vector<numeric::BesselPair> pairs(2);
  const auto f = [&](double kappa) {
    numeric::bessel_pairs(kappa, pairs);
    return slope(1, pairs[1]) + poisson * pairs[1].value;
  };
  std::vector<Mode> modes;
  for (const double root : breathing_roots(f, per_omega, cutoff)) {
    const double radial = 1.0 / std::sqrt(1.0 - (1.0 - poisson * poisson) / (root * root));
    modes.push_back({0, static_cast<int>(modes.size()), root / per_omega, radial, 0.0});
  }
  return modes;
}

/// What the modes above the cutoff can carry, about (2/πω_c)(κ + κ′)/ω.
double tail(double poisson, double cutoff) {
  return 2.0 / (std::numbers::pi * cutoff) * (std::sqrt(1.0 - poisson * poisson) + std::sqrt(2.0 * (1.0 + poisson)));
}

}  // namespace

std::vector<Mode> find_modes(double poisson, double cutoff, const Poll& poll) {
  // The roots lie above ω = 1 for every ν, and the zeros of J_n and of J_n' (n ≥ 1) more than 3 apart.
  const WaveNumbers wave{std::sqrt(1.0 - poisson * poisson), std::sqrt(2.0 * (1.0 + poisson))};
  const auto orders = static_cast<std::size_t>(std::ceil(cutoff / slowest_edge_wave)) + 2;
  std::vector<Mode> modes = radial_modes(poisson, cutoff);
  for (const auto& found : modes_by_order<EdgeProblem>(wave, cutoff, orders, poll)) {
    modes.insert(modes.end(), found.begin(), found.end());
  }
  return modes;
}

std::vector<Mode> checked_modes(double poisson, double cutoff, const Poll& poll) {
  auto modes = find_modes(poisson, cutoff, poll);
  constexpr double rounding = 1e-12;
  const KeptSums kept(modes);
  for (int order = 0; order < kept.orders(); ++order) {
    check_sum_rule(order, static_flexibility(poisson, order), kept.compliance(order), rounding, tail(poisson, cutoff),
                   cutoff);
  }
  return modes;
}

}  // namespace stoss::bodies::disk
