#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "quasistatic/pulse.hpp"

namespace stoss::quasistatic {
namespace {

using std::numbers::pi;

// Falls ln(F_max/F) of a disk beyond which the force adds nothing to the time and to the impulse; and places of a
// sphere.
constexpr double last_fall_of_time = 42.0, last_fall_of_impulse = 20.0;
constexpr double last_time = 24.0, last_impulse = 10.0;

/// w
double width_of(double depth) { return std::sqrt(depth / (0.5 + depth)); }

double depth_of(double depth) { return std::max(depth, 1e-14); }

/// The place of a fall y.
double place_of(double depth, double fall) { return std::asinh(std::sqrt(fall) / width_of(depth_of(depth))); }

/// (e^{2y} − 1)/y − 2
double excess_slope(double y) {
  if (y > 1e-3) return std::expm1(2.0 * y) / y - 2.0;
  return y * (2.0 + y * (4.0 / 3.0 + y * (2.0 / 3.0 + y * (4.0 / 15.0 + y * (4.0 / 45.0)))));
}

/// The phase at a place, 0 … π/2.
double phase_at(double u) { return pi / (1.0 + std::exp(2.0 * u)); }

}  // namespace

double solve_fall(double energy_factor, double excess) {
  if (!(excess > 0.0)) return 0.0;
  // The left side is convex and grows, and the start is above the root, so that Newton's iterates descend to it.
  double fall = 2.0 * excess + 2.0 * std::sqrt(excess);
  constexpr int max_steps = 100;
  for (int step = 0; step < max_steps; ++step) {
    const double left = fall - 0.5 * std::log1p(fall / energy_factor);
    const double next = fall - (left - excess) * (energy_factor + fall) / (energy_factor - 0.5 + fall);
    if (!(next < fall)) break;
    fall = std::max(next, 0.0);
  }
  return fall;
}

LinePulse::LinePulse(double depth, double max_force)
    : Pulse(place_of(depth, last_fall_of_time), place_of(depth, last_fall_of_impulse)),
      depth_(depth_of(depth)),
      max_force_(max_force),
      width_(width_of(depth_)) {}

double LinePulse::fall_at(double u) const {
  const double x = width_ * std::sinh(u);
  return x * x;
}

Pulse::Course LinePulse::at(double u) const {
  const double y = fall_at(u), factor = energy_factor(), left = std::exp(-y);
  const double slope = 2.0 * depth_ + factor * excess_slope(y);  // A (e^{2y} − 1 − y/A)/y
  const double rate = 2.0 * width_ * std::cosh(u) * (depth_ + y) / std::sqrt(slope), force = left / std::sqrt(factor);
  return {.rate = rate,
          .force = force,
          .impulse = force * rate,
          .velocity = left * std::sqrt(y * slope / factor),
          .stiffness = 1.0 / (depth_ + y)};
}

Pulse::Contact LinePulse::at_phase(double phase) const {
  if (!(phase > 0.0 && phase < pi)) return {.place = end_of_time(), .force = 0.0, .compression = 0.0, .radius = 0.0};
  const double cosine = std::cos(phase);
  // ln(cos θ) = ½ ln(1 + y/A) − y, by whichever of sine and cosine is the more accurate
  const double excess = std::abs(cosine) < 0.5 ? -0.5 * std::log1p(-cosine * cosine) : -std::log(std::sin(phase));
  const double fall = solve_fall(energy_factor(), excess), force = max_force_ * std::exp(-fall);
  return {.place = std::min(place_of(depth_, fall), end_of_time()),
          .force = force,
          .compression = force > 0.0 ? force * (1.0 + depth_ + fall) : 0.0,
          .radius = 0.0};
}

PointPulse::PointPulse(const RadiusLaw& law, double speed)
    : Pulse(last_time, last_impulse), law_(law), speed_(speed), greatest_(law_.at_energy(0.5 * speed * speed)) {}

double PointPulse::radius(double phase) const {
  const double share = std::sin(phase);
  return std::min(law_.at_energy(0.5 * speed_ * speed_ * share * share), greatest_);
}

Pulse::Course PointPulse::at(double u) const {
  const double phase = phase_at(u), a = radius(phase), force = law_.force(a);
  const double impulse = std::sin(phase) * 2.0 * phase * (1.0 - phase / pi);
  return {.rate = speed_ * impulse / force,
          .force = force / speed_,
          .impulse = impulse,
          .velocity = std::cos(phase),
          .stiffness = law_.stiffness(a)};
}

Pulse::Contact PointPulse::at_phase(double phase) const {
  const double nearest = phase < 0.5 * pi ? phase : pi - phase, a = radius(nearest);
  const double place = nearest > 0.0 ? std::clamp(0.5 * std::log((pi - nearest) / nearest), 0.0, last_time) : last_time;
  return {.place = place, .force = law_.force(a), .compression = law_.compression(a), .radius = a};
}

}  // namespace stoss::quasistatic
