// The modes of a free sphere: those of n = 0 directly, all others by the search that round bodies share.
#include "bodies/sphere/mode_search.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "bodies/mode_search.hpp"
#include "check.hpp"
#include "numeric/bessel.hpp"

namespace stoss::bodies::sphere {

double gradient_norm_rest(int order, double kappa, const numeric::BesselPair& pair) {
  const double beta = pair.value, gamma = pair.next;
  return 0.5 * (gamma * gamma + kappa * kappa * beta * beta) - (order + 1.5) * beta * gamma;
}

double EdgeProblem::determinant() const {
  const double n = order;
  const double y = 0.5 * kappa_shear * kappa_shear;
  const double beta = pressure.value, gamma = pressure.next;
  const double beta_s = shear.value, gamma_s = shear.next;
  return beta * (y * (y - (2.0 * n + 1.0) * (n - 1.0)) * beta_s + ((n + 2.0) * n * (n - 1.0) - y) * gamma_s) +
         gamma * (((n + 2.0) * (n * n - 1.0) - 2.0 * y) * beta_s - (n - 1.0) * (n + 2.0) * gamma_s);
}

int EdgeProblem::roots_below(int poles) const {
  const double n = order;
  const double y = 0.5 * kappa_shear * kappa_shear;
  const double beta = pressure.value, gamma = pressure.next;
  const double beta_s = shear.value, gamma_s = shear.next;

  // Clamped surface: u = 0 where h = α/β − Lβ′/(α′+β′) = 0. Both terms fall with ω between their poles, so there is
  // exactly one root between neighbouring poles, and none before the first.
  const double det_displacement = gamma * gamma_s - n * beta * gamma_s - (n + 1.0) * gamma * beta_s;
  const bool h_negative = std::signbit(det_displacement) != std::signbit(beta * shear_pole());
  const int clamped = poles - 1 + (h_negative ? 1 : 0);

  // Signs of the dynamic stiffness K (traction = K displacement) from its determinant and first element.
  const double det_stiffness = determinant() * det_displacement;
  const double k_rr =
      ((2.0 * n + y) * beta * gamma_s + (n + 1.0) * (2.0 * gamma - y * beta) * beta_s - 2.0 * gamma * gamma_s) *
      det_displacement;
  const int negative = det_stiffness < 0.0 ? 1 : (k_rr < 0.0 ? 2 : 0);

  const int rigid = order == 1 ? 1 : 0;  // the translation, at ω = 0
  return clamped + negative - rigid;
}

EdgeProblem::Vibration EdgeProblem::vibration() const {
  const double n = order;
  const double m = n * (n - 1.0);
  const double y = 0.5 * kappa_shear * kappa_shear;
  const double beta = pressure.value, gamma = pressure.next;
  const double beta_s = shear.value, gamma_s = shear.next;

  // A : B from one of the two conditions of the free surface, whichever determines it better once the arbitrary scales
  // of the two Bessel pairs are taken out; `sum` is Aβ + (n+1)Bβ′ with its large parts cancelled by algebra.
  const double rr_p = (m - y) * beta + 2.0 * gamma, rr_s = (n + 1.0) * (m * beta_s - n * gamma_s);
  const double rt_p = (n - 1.0) * beta - gamma, rt_s = (n * n - 1.0 - y) * beta_s + gamma_s;
  const double scale_p = std::hypot(n * beta, gamma);
  const double scale_s = std::hypot(n * beta_s, gamma_s);
  double a, b, sum;
  if (std::hypot(rr_p / scale_p, rr_s / (scale_s * (n + 1.0))) >
      std::hypot(n * rt_p / scale_p, n * rt_s / (scale_s * (n + 1.0)))) {
    a = rr_s;
    b = -rr_p;
    sum = (n + 1.0) * (y * beta * beta_s - n * gamma_s * beta - 2.0 * gamma * beta_s);
  } else {
    a = -rt_s;
    b = rt_p;
    sum = y * beta * beta_s - gamma_s * beta - (n + 1.0) * gamma * beta_s;
  }
  const double wave = n * (n + 1.0);
  const double norm = n * sum * sum + a * a * gradient_norm_rest(order, kappa, pressure) +
                      wave * b * b * gradient_norm_rest(order, kappa_shear, shear);
  const double radial = n * sum - a * gamma;
  const double tangential = sum - b * gamma_s;
  const double scale = std::copysign(std::sqrt((2.0 * n + 1.0) / (3.0 * norm)), radial);
  return {a * scale, b * scale, radial * scale, tangential * scale};
}

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

int degrees_below(double poisson, double cutoff) {
  return static_cast<int>(std::ceil(cutoff / slowest_surface_wave(poisson))) + 2;
}

std::vector<Mode> find_modes(double poisson, double cutoff, const Poll& poll) {
  // The roots lie above ω = 1 for every ν, the zeros of j_n and of (x j_n)' (n ≥ 1) more than 2.7 from 0 and each
  // other.
  const WaveSpeeds speed = wave_speeds(poisson);
  const WaveNumbers wave{1.0 / speed.pressure, 1.0 / speed.shear};
  const auto orders = static_cast<std::size_t>(degrees_below(poisson, cutoff));
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
