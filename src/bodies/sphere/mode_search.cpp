// The modes of a free sphere: those of n = 0 directly, all others by the search that round bodies share.
#include "bodies/sphere/mode_search.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "bodies/mode_checks.hpp"
#include "bodies/mode_search.hpp"
#include "bodies/sphere/edge_problem.hpp"
#include "check.hpp"
#include "numeric/bessel.hpp"

namespace stoss::bodies::sphere {
namespace {

/// A Rayleigh wave runs at 0.68 c_s or more (ν → −1), at 0.55 c or more (ν → ½), and ω_{n,0} > n c_R / R.
double slowest_surface_wave(double poisson) {
  const double shear = wave_speeds(poisson).shear;
  return poisson < 0.0 ? 0.68 * shear : 0.87 * shear;
}

/// n = 0: Yβ = 2γ. κ j_0/j_1 falls from 3 between its poles, so there is exactly one root before each zero of j_1.
std::vector<Mode> breathing_modes(double poisson, double cutoff) {
  const WaveSpeeds speed = wave_speeds(poisson);
  const double stiffness = 0.5 * speed.pressure * speed.pressure / (speed.shear * speed.shear);  // Y/κ²
  std::vector<numeric::BesselPair> pairs(1);
  const auto f = [&](double kappa) {
    numeric::bessel_pairs(kappa, pairs, numeric::BesselKind::spherical);
    return stiffness * kappa * kappa * pairs[0].value - 2.0 * pairs[0].next;
  };
  std::vector<Mode> modes;
  for (const double root : breathing_roots(f, 1.0 / speed.pressure, cutoff)) {
    numeric::bessel_pairs(root, pairs, numeric::BesselKind::spherical);
    const double radial = std::abs(pairs[0].next) / std::sqrt(3.0 * gradient_norm_rest(0, root, pairs[0]));
    modes.push_back({0, static_cast<int>(modes.size()), root * speed.pressure, radial, 0.0});
  }
  return modes;
}

}  // namespace

WaveSpeeds wave_speeds(double poisson) {
  return {std::sqrt((1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson))),
          1.0 / std::sqrt(2.0 * (1.0 + poisson))};
}

void require_poisson(double poisson) {
  require("poisson", poisson, {min_poisson, max_poisson, true, true, "-0.95 to 0.4999"},
          "Poisson's ratio of the material; at 0.5 it would be incompressible");
}

std::vector<Mode> find_modes(double poisson, double cutoff, const Poll& poll) {
  // The roots lie above ω = 1 for every ν, the zeros of j_n and of (x j_n)' (n ≥ 1) more than 2.7 from 0 and each
  // other.
  const WaveSpeeds speed = wave_speeds(poisson);
  const WaveNumbers wave{1.0 / speed.pressure, 1.0 / speed.shear};
  const auto orders = static_cast<std::size_t>(std::ceil(cutoff / slowest_surface_wave(poisson))) + 2;
  std::vector<Mode> modes = breathing_modes(poisson, cutoff);
  for (const auto& found : modes_by_order<EdgeProblem>(wave, cutoff, orders, poll)) {
    modes.insert(modes.end(), found.begin(), found.end());
  }
  return modes;
}

std::vector<Mode> checked_modes(double poisson, double cutoff, const Poll& poll) {
  auto modes = find_modes(poisson, cutoff, poll);
  constexpr double rounding = 1e-11;
  const WaveSpeeds speed = wave_speeds(poisson);
  const KeptSums kept(modes);
  for (int order = 0; order < kept.orders(); ++order) {
    // What the modes above the cutoff can carry, about (2n+1)/3 (2/πω_c)(1/c_p + 1/c_s).
    const double tail =
        (2.0 * order + 1.0) / 3.0 * 2.0 / (std::numbers::pi * cutoff) * (1.0 / speed.pressure + 1.0 / speed.shear);
    check_sum_rule(order, static_flexibility(poisson, order), kept.compliance(order), rounding, tail, cutoff);
  }
  return modes;
}

}  // namespace stoss::bodies::sphere
