#include "numeric/stable_kicks.hpp"

#include <cmath>

#include "numeric/damped_oscillator.hpp"

namespace stoss::numeric {
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
