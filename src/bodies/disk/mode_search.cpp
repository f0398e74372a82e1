// The modes of a free disk: those of n = 0 directly, all others by the search that round bodies share.
#include "bodies/disk/mode_search.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "bodies/mode_search.hpp"
#include "numeric/bessel.hpp"

namespace stoss::bodies::disk {
namespace {

/// ∫_0^1 r [(df/dr)² + n² f²/r²] dr for f = J_n(κr): αβ + [α² + (κ²−n²)β²]/2 with α = nβ − γ.
double gradient_norm(int order, double kappa, const numeric::BesselPair& pair) {
  const double beta = pair.value, gamma = pair.next;
  return beta * (order * beta - (order + 1) * gamma) + 0.5 * (gamma * gamma + kappa * kappa * beta * beta);
}

}  // namespace

double EdgeProblem::determinant() const {
  // With M = n(n−1) and Y = κ′²/2: α + qβ = (Y − M)β − γ and n(α − β) = Mβ − nγ; the M² terms cancel.
  const double n = order;
  const double m = n * (n - 1.0);
  const double y = 0.5 * kappa_shear * kappa_shear;
  const double beta = pressure.value, gamma = pressure.next;
  const double beta_s = shear.value, gamma_s = shear.next;
  return n * n * gamma * gamma_s - (y * beta - gamma) * (y * beta_s - gamma_s) +
         m * (2.0 * y * beta * beta_s - (n + 1.0) * (gamma * beta_s + beta * gamma_s));
}

int EdgeProblem::roots_below(int poles) const {
  const double n = order;
  const double q = 0.5 * kappa_shear * kappa_shear - n * n;
  const double beta = pressure.value, alpha = slope(order, pressure);
  const double beta_s = shear.value, alpha_s = slope(order, shear);

  // Clamped edge: u = 0 where h = α/β − n² β′/α′ = 0. Both terms fall with ω between their poles, so there is
  // exactly one root between neighbouring poles, and none before the first.
  const double det_displacement = n * (beta * shear.next + beta_s * pressure.next) - pressure.next * shear.next;
  const bool h_negative = std::signbit(det_displacement) == std::signbit(beta * alpha_s);
  const int clamped = poles - 1 + (h_negative ? 1 : 0);

  // Signs of the dynamic stiffness K (traction = K displacement) from its determinant and first element.
  const double det_stiffness = determinant() * det_displacement;
  const double k_rr = ((alpha + q * beta) * alpha_s + n * n * beta * (alpha_s - beta_s)) * det_displacement;
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

  // A : B from one of the two free-edge conditions, whichever determines it better once the arbitrary scales of the
  // two Bessel pairs are taken out; `sum` is Aβ + Bβ′ with its large parts cancelled by algebra.
  const double rr_p = (m - y) * beta + gamma, rr_s = m * beta_s - n * gamma_s;
  const double rphi_p = n * gamma - m * beta, rphi_s = (y - m) * beta_s - gamma_s;
  const double scale_p = std::hypot(n * beta, gamma);
  const double scale_s = std::hypot(n * beta_s, gamma_s);
  double a, b, sum;
  if (std::hypot(rr_p / scale_p, rr_s / scale_s) > std::hypot(rphi_p / scale_p, rphi_s / scale_s)) {
    a = rr_s;
    b = -rr_p;
    sum = y * beta * beta_s - n * gamma_s * beta - gamma * beta_s;
  } else {
    a = rphi_s;
    b = -rphi_p;
    sum = y * beta * beta_s - gamma_s * beta - n * gamma * beta_s;
  }
  const double norm = a * a * gradient_norm(order, kappa, pressure) + b * b * gradient_norm(order, kappa_shear, shear) +
                      2.0 * n * a * b * beta * beta_s;
  const double radial = n * sum - a * gamma;
  const double tangential = b * gamma_s - n * sum;
  const double scale = std::copysign(1.0 / std::sqrt(norm), radial);
  return {a * scale, b * scale, radial * scale, tangential * scale};
}

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
