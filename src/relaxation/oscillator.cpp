#include "relaxation/oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "numeric/damped_oscillator.hpp"

namespace stoss {
namespace {

/// Takes the two nearest of three real zeros as the pair, where those of the pair are far apart.
void pair_nearest(const Rates& rates, LossyOscillator& mode) {
  const double discriminant = (mode.gamma - mode.frequency) * (mode.gamma + mode.frequency);
  if (discriminant <= 0.0) return;
  const double half = std::sqrt(discriminant), fast = mode.gamma + half;
  const double slow = mode.frequency * (mode.frequency / fast);
  double least = 2.0 * half;
  std::size_t nearest = mode.rate.size();
  bool to_fast = false;
  for (std::size_t k = 0; k < mode.rate.size(); ++k) {
    for (const bool other : {false, true}) {
      const double apart = std::abs(mode.rate[k] - (other ? fast : slow));
      if (apart < least) least = apart, nearest = k, to_fast = other;
    }
  }
  if (nearest == mode.rate.size()) return;
  const double near = to_fast ? fast : slow, far = to_fast ? slow : fast, joins = mode.rate[nearest];
  mode.rate[nearest] = far;
  mode.residue[nearest] = 1.0 / (mode.omega * mode.omega * modulus_slope(rates, far) - 2.0 * far);
  mode.gamma = 0.5 * (near + joins);
  mode.frequency = std::sqrt(near * joins);
}

/// The steady motion under kicks of period t that make the velocity 1, just before one.
struct Steady {
  double place, velocity;
};

Steady steady_pair(const LossyOscillator& mode, double time) {
  const auto [position, coupling, slowed] = numeric::damped_motion(mode.frequency, mode.gamma, time);
  const double determinant = numeric::determinant(mode.frequency, mode.gamma, time);
  const double jump = mode.velocity / mode.frequency;
  return {((1.0 - slowed) * mode.place + coupling * jump) / determinant - mode.place,
          mode.frequency * (((1.0 - position) * jump - coupling * mode.place) / determinant - jump)};
}

/// 1/x − 1/(e^x − 1)
double beside_exponential(double x) {
  constexpr double small = 1e-2;
  return x < small ? 0.5 - x / 12.0 * (1.0 - x * x / 60.0) : 1.0 / x - 1.0 / std::expm1(x);
}

}  // namespace

LossyOscillator kelvin_voigt_oscillator(double omega, double loss_time) {
  LossyOscillator mode;
  mode.omega = mode.frequency = omega;
  mode.gamma = 0.5 * loss_time * omega * omega;
  return mode;
}

LossyOscillator relaxing_oscillator(double omega, const Rates& rates) {
  LossyOscillator mode;
  mode.omega = omega;
  mode.gamma = 0.5 * omega * omega * rates.viscous;
  double squared = omega * omega * rates.relaxed;
  for (std::size_t j = 0; const RealZero& zero : real_zeros(rates, 1.0 / (omega * omega))) {
    mode.rate.push_back(zero.rate);
    mode.residue.push_back(1.0 / (omega * omega * zero.slope - 2.0 * zero.rate));
    mode.gamma += 0.5 * zero.below;  // the sum of all zeros is that of the poles
    squared *= rates.rate[j++] / zero.rate;
  }
  mode.frequency = std::sqrt(squared);
  pair_nearest(rates, mode);
  mode.place = 0.0;
  for (std::size_t k = 0; k < mode.rate.size(); ++k) {
    mode.place -= mode.residue[k];
    mode.velocity += mode.residue[k] * mode.rate[k];
  }
  return mode;
}

double LossyOscillator::share_due(double time) const {
  double before = steady_pair(*this, time).velocity;
  for (std::size_t k = 0; k < rate.size(); ++k) before -= rate[k] * residue[k] / std::expm1(rate[k] * time);
  return -before;
}

double LossyOscillator::missing_beside_kicks(double time) const {
  const double steady = (velocity + 2.0 * gamma * place) / (frequency * frequency);
  double missing = steady - time * steady_pair(*this, time).place;
  for (std::size_t k = 0; k < rate.size(); ++k) missing += residue[k] * time * beside_exponential(rate[k] * time);
  return missing;
}

double LossyOscillator::energy(double moved, double speed, const std::vector<double>& decaying, double kick) const {
  double now = speed, springs = 0.0;
  for (std::size_t k = 0; k < decaying.size(); ++k) {
    if (residue[k] == 0.0) continue;  // a branch so weak, or so fast, that it holds nothing
    now -= rate[k] * decaying[k];
    springs += rate[k] * decaying[k] * (decaying[k] / residue[k]);
  }
  // The pair without its zeros, which may coincide.
  const double squared = frequency * frequency, turned = velocity + 2.0 * gamma * place;
  springs += (squared * moved * (velocity * moved - 2.0 * place * speed) - turned * speed * speed) /
             (velocity * turned + squared * place * place);
  const double kicked = now - 0.5 * kick;
  return 0.5 * (kicked * kicked + now * now + springs);
}

}  // namespace stoss
