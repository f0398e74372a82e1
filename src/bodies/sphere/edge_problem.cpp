#include "bodies/sphere/edge_problem.hpp"

#include <cmath>

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

}  // namespace stoss::bodies::sphere
