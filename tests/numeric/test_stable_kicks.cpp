// What kicks make of an oscillator, against the z-transform of its motion: passive at all frequencies, and exact at low
// ones.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "numeric/damped_oscillator.hpp"

namespace stoss::numeric {
namespace {

struct Oscillator {
  double omega, gamma, time;
};

constexpr Oscillator oscillators[] = {{1, 0, 0.5}, {3, 0, 0.01},  {3, 0.2, 0.2},
                                      {3, 3, 0.1}, {2, 10, 0.05}, {1, 0.1, 2}};

/// Displacement under the force e^{iθk}, over the static one.
std::complex<double> compliance(const Oscillator& of, double theta) {
  const auto [gamma, strength, at_once] = stable_kicks(of.omega, of.gamma, of.time);
  const auto [position, coupling, velocity] = damped_motion(of.omega, gamma, of.time);
  const std::complex<double> z = std::polar(1.0, theta);
  const double left = std::exp(-2.0 * gamma * of.time);
  return at_once + strength * of.omega * of.time * coupling / (z - (position + velocity) + left / z);
}

}  // namespace

TEST(StableKicks, FollowASlowForceExactly) {
  for (const Oscillator& each : oscillators) EXPECT_NEAR(compliance(each, 0.0).real(), 1.0, 1e-12);
}

TEST(StableKicks, LoseToASlowForceWhatTheOscillatorDoes) {
  constexpr double theta = 1e-4;
  for (const auto& [omega, gamma, time] : {Oscillator{3, 0.2, 0.1}, {3, 1.5, 0.1}, {2, 0.1, 0.25}}) {
    const double exact = -2.0 * gamma * theta / (omega * omega * time);
    EXPECT_NEAR(compliance({omega, gamma, time}, theta).imag() / exact, 1.0, 1e-3) << omega << ", " << gamma;
  }
}

TEST(StableKicks, StandStillUnderAnAlternatingForce) {
  for (const Oscillator& each : oscillators) {
    EXPECT_NEAR(compliance(each, std::numbers::pi).real(), 0.0, 1e-12);
    EXPECT_GT(stable_kicks(each.omega, each.gamma, each.time).at_once, 0.0);
  }
}

TEST(StableKicks, NeverGiveEnergy) {
  for (const Oscillator& each : oscillators) {
    for (double theta = 0.01; theta < std::numbers::pi; theta += 0.01) {
      EXPECT_LE(compliance(each, theta).imag(), 1e-12) << each.omega << ", " << each.gamma << ", " << theta;
    }
  }
}

TEST(StableKicks, WithoutDampingAreWeakerByTheMeanOverAStep) {
  const StableKicks kicks = stable_kicks(2.0, 0.0, 0.3);
  EXPECT_EQ(kicks.gamma, 0.0);
  EXPECT_NEAR(kicks.strength, std::sin(0.6) / 0.6, 1e-14);
}

}  // namespace stoss::numeric
