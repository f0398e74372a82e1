// Maw's oblique impact by springs side by side, which stick or slip one by one: its balances, and its linear limit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "stoss/quasistatic/oblique/maw.hpp"
#include "stoss/quasistatic/oblique/mindlin.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

const double sphere = 1.75 * mindlin_ratio(0.3);  // χ

/// An impact by plain steps of equal angle √d = sin θ.
struct Springs {
  double psi2 = 0.0;
  double impulse = 0.0;        ///< ∫T dt over ∫N dt = 2
  double friction = 0.0;       ///< in the unit of friction_loss
  double least = 0.0;          ///< of the work of one slip
  double largest_force = 0.0;  ///< T/N
};

Springs by_springs(double psi1, double chi, bool with_friction) {
  constexpr std::size_t count = 1000;
  constexpr int steps = 2 * static_cast<int>(count);
  std::vector<double> q(count, 0.0);
  Springs result;
  double velocity = psi1, force = 0.0, d = 0.0, time_step = 0.0;
  const auto rate = [](double angle) {  // dt/dθ
    const double s = std::sin(angle);
    return 2.0 * s * std::abs(std::cos(angle)) / std::sqrt(1.0 - std::pow(s, 5));
  };
  for (int i = 1; i <= steps; ++i) {
    const double angle = std::numbers::pi * i / steps, s = i < steps ? std::sin(angle) : 0.0;
    time_step = rate(angle - 0.5 * std::numbers::pi / steps) * std::numbers::pi / steps;
    const double force_before = force;
    velocity -= 1.25 * chi * force * time_step;
    const double move = velocity * time_step;
    force = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      const double x = (static_cast<double>(k) + 0.5) / count;
      const double limit = std::max(s * s - x * x, 0.0), before = std::max(d - x * x, 0.0);
      const double share = before == 0.0 && limit > 0.0 ? limit / (s * s - d) : limit > 0.0 ? 1.0 : 0.0;
      const double stuck = q[k] + share * move;
      double next = limit > 0.0 ? stuck : 0.0;
      if (with_friction) {
        next = std::clamp(stuck, -limit, limit);
        const double work = 3.75 * 0.5 * (q[k] + next) * (stuck - next) / count;
        result.friction += work;
        result.least = std::min(result.least, work);
      }
      q[k] = next;
      force += 1.5 * next / count;
    }
    velocity -= 1.25 * chi * force * time_step;
    result.impulse += 0.3125 * (force_before + force) * time_step;
    d = s * s;
    if (d > 0.05) result.largest_force = std::max(result.largest_force, std::abs(force) / std::pow(d, 1.5));
  }
  result.psi2 = velocity;
  return result;
}

TEST(MawSprings, HaveItsMomentumAndEnergy) {
  for (const double chi : {0.3, 1.0, sphere, 6.0}) {
    for (const double share : {0.05, 0.3, 0.7, 0.95}) {
      const double psi1 = share * sliding_limit(chi);
      const MawImpact impact = maw(psi1, chi);
      const Springs springs = by_springs(psi1, chi, true);
      EXPECT_NEAR(impact.psi2, springs.psi2, 2e-4) << chi << " " << psi1;
      EXPECT_NEAR(impact.friction_loss, springs.friction, 1e-3 * (psi1 + psi1 * psi1)) << chi << " " << psi1;
      EXPECT_GT(springs.least, -1e-7);
      EXPECT_LE(springs.largest_force, 1.0 + 1e-5);
      EXPECT_NEAR(impact.impulse, springs.impulse, 5e-5) << chi << " " << psi1;
      EXPECT_GE(impact.friction_loss, 0.0);
      EXPECT_LE(std::abs(impact.psi2), psi1);
    }
  }
}

TEST(MawSprings, AreLinearWhereNothingSlips) {
  // ψ₁ → 0: springs stick from where they touch to where they leave, and take their energy with them.
  for (const double chi : {0.3, 0.7, sphere, 4.0}) {
    const double slope = maw(1e-6, chi).psi2 / 1e-6;
    EXPECT_NEAR(slope, by_springs(1.0, chi, false).psi2, 2e-4) << chi;
    EXPECT_NEAR(maw(1e-150, chi).psi2 / 1e-150, slope, 1e-5) << chi;
  }
  EXPECT_EQ(maw(0.0, sphere).psi2, 0.0);
}

}  // namespace
}  // namespace stoss
