#include "numeric/damped_oscillator.hpp"

#include <cmath>

namespace stoss::numeric {
namespace {

/// Both decay rates of an overdamped oscillator, γ ± √(γ² − ω²), without cancellation.
struct Rates {
  double half_difference;  ///< κ
  double slow, fast;
};

Rates rates(double omega, double gamma) {
  const double half_difference = std::sqrt((gamma - omega) * (gamma + omega));
  const double fast = gamma + half_difference;
  return {half_difference, omega * (omega / fast), fast};
}

DampedMotion underdamped(double omega, double gamma, double time) {
  const double frequency = std::sqrt((omega - gamma) * (omega + gamma)), angle = frequency * time;
  const double decay = std::exp(-gamma * time);
  const double sine = angle == 0.0 ? time : std::sin(angle) / frequency;
  return {decay * (std::cos(angle) + gamma * sine), decay * omega * sine, decay * (std::cos(angle) - gamma * sine)};
}

DampedMotion overdamped(double omega, double gamma, double time) {
  const auto [difference, slow, fast] = rates(omega, gamma);
  if (const double angle = difference * time; std::abs(angle) < 1.0) {
    const double decay = std::exp(-gamma * time), cosine = std::cosh(angle);
    const double sine = angle == 0.0 ? time : std::sinh(angle) / difference;
    return {decay * (cosine + gamma * sine), decay * omega * sine, decay * (cosine - gamma * sine)};
  }
  const double slowly = std::exp(-slow * time) / (2.0 * difference);
  const double quickly = std::exp(-fast * time) / (2.0 * difference);
  return {fast * slowly - slow * quickly, omega * (slowly - quickly), fast * quickly - slow * slowly};
}

}  // namespace

DampedMotion damped_motion(double omega, double gamma, double time) {
  if (gamma == 0.0) return {std::cos(omega * time), std::sin(omega * time), std::cos(omega * time)};
  return gamma < omega ? underdamped(omega, gamma, time) : overdamped(omega, gamma, time);
}

double determinant(double omega, double gamma, double time) {
  if (gamma >= omega) {
    const Rates rate = rates(omega, gamma);
    return std::expm1(-rate.slow * time) * std::expm1(-rate.fast * time);
  }
  const double lost = std::expm1(-gamma * time);
  const double sine = std::sin(0.5 * time * std::sqrt((omega - gamma) * (omega + gamma)));
  return lost * lost + 4.0 * (1.0 + lost) * sine * sine;
}

double share_beside_kicks(double omega, double gamma, double time) {
  if (gamma == 0.0) {
    const double angle = 0.5 * omega * time;
    return 1.0 - angle / std::tan(angle);
  }
  const double coupling = damped_motion(omega, gamma, time).coupling;
  return 1.0 - omega * time * coupling / determinant(omega, gamma, time);
}

double share_due(double omega, double gamma, double time) {
  if (gamma == 0.0) return 0.5;
  const double velocity = damped_motion(omega, gamma, time).velocity;
  return (std::exp(-2.0 * gamma * time) - velocity) / determinant(omega, gamma, time);
}

namespace {

/// K(0) and −K(π): t [(1 ∓ M)⁻¹M]₁₂ ω with M the free motion over a step.
struct Answer {
  double slow, alternating;
};

Answer answer(double omega, double gamma, double time) {
  const auto [position, coupling, velocity] = damped_motion(omega, gamma, time);
  const double determinant = 1.0 + position + velocity + std::exp(-2.0 * gamma * time);  // of 1 + M
  return {1.0 - share_beside_kicks(omega, gamma, time), omega * time * coupling / determinant};
}

double strength(const Answer& to) { return 1.0 / (to.slow + to.alternating); }

}  // namespace

StableKicks stable_kicks(double omega, double gamma, double time) {
  const double damping = gamma / strength(answer(omega, gamma, time));
  const Answer damped = answer(omega, damping, time);
  return {damping, strength(damped), damped.alternating * strength(damped)};
}

}  // namespace stoss::numeric
