// Slow impacts of a sphere, and Rayleigh's estimate of their loss: Hertz' limit, an integration step by step, and the
// full solution.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "quasistatic/pulse.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/quasistatic/quantities.hpp"
#include "stoss/quasistatic/rayleigh.hpp"
#include "stoss/quasistatic/slow_impact.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/refusal.hpp"
#include "support/runge_kutta.hpp"

namespace stoss {
using namespace quasistatic;
using bodies::sphere::Mode;

namespace {

using std::numbers::pi;

TEST(SlowImpact, IsHertzInHisLimit) {
  const double ratio = 0.8 * boost::math::beta(0.4, 0.5);
  EXPECT_NEAR(ratio, 2.9432, 1e-4);
  for (const double speed : {1e-12, 1e-6, 0.1}) {
    const SlowImpact impact = slow_impact(PointLaw::hertz, 0.3, speed);
    EXPECT_NEAR(impact.contact_time * speed / impact.max_compression, ratio, 1e-13);
    EXPECT_NEAR(std::pow(impact.max_radius, 5.0) / (1.25 * pi * 0.91 * speed * speed), 1.0, 1e-13);
  }
  const SlowImpact slowest = slow_impact(PointLaw::center, 0.3, 1e-12);
  EXPECT_NEAR(slowest.contact_time * 1e-12 / slowest.max_compression, ratio, 2e-6);
}

TEST(SlowImpact, ConservesEnergyAndMomentum) {
  for (const double nu : {-0.5, 0.0, 0.3, 0.49}) {
    for (const double speed : {1e-12, 1e-4, 0.1}) {
      const SlowImpact impact = slow_impact(PointLaw::center, nu, speed);
      EXPECT_NEAR(compression_energy(impact.law, nu, impact.max_force) / (0.5 * speed * speed), 1.0, 1e-13);
      EXPECT_NEAR(compression(impact.law, nu, impact.max_force) / impact.max_compression, 1.0, 1e-13);
      double impulse = 0.0;
      for (const double weight : slow_pulse(impact.law, nu, speed)->nodes(1.0).weight) impulse += weight;
      EXPECT_NEAR(impulse, 2.0, 1e-13);
    }
  }
}

TEST(SlowImpact, IsTheMotionOfTheCentreOfMass) {
  // δ̈ = −F(δ) by Runge and Kutta's method from the turning point to half of the maximum force, and the history.
  const double nu = 0.3, speed = 0.02;
  const SlowImpact impact = slow_impact(PointLaw::center, nu, speed);
  constexpr int steps = 1000;
  const double h = 0.4 * impact.contact_time / steps;
  const auto force = [&](double at) {
    return compression_force(PointLaw::center, nu, std::min(at, impact.max_compression));
  };
  std::array motion{impact.max_compression, 0.0};
  for (int i = 0; i < steps; ++i) {
    motion = test::runge_kutta_step(motion, h, [&](const std::array<double, 2>& its) {
      return std::array{its[1], -force(its[0])};
    });
  }
  const auto [delta, velocity] = motion;
  const double phase = std::acos(velocity / speed);
  const std::vector<ContactInstant> history = contact_history(impact, {0.0, pi - phase, 0.5 * pi, phase, pi});
  const double middle = 0.5 * impact.contact_time;
  EXPECT_EQ(history[0].time, 0.0);
  EXPECT_NEAR(history[1].time, middle - steps * h, 1e-9);
  EXPECT_NEAR(history[2].time, middle, 1e-12);
  EXPECT_NEAR(history[3].time, middle + steps * h, 1e-9);
  EXPECT_NEAR(history[3].compression, delta, 1e-10);
  EXPECT_NEAR(history[3].force, force(delta), 1e-10);
  EXPECT_NEAR(history[4].time, impact.contact_time, 1e-12);
}

TEST(SlowImpact, RefusesNonsense) {
  test::expect_refusal([] { (void)slow_impact(PointLaw::center, 0.3, 0.2); }, {"speed: got 0.2", "limit_speed"});
  test::expect_refusal([] { (void)slow_impact(PointLaw::center, 0.3, 1e-13); }, {"speed", "1e-12"});
  test::expect_refusal([] { (void)slow_impact(PointLaw::hertz, 0.5, 1e-3); }, {"poisson"});
  const SlowImpact impact = slow_impact(PointLaw::center, 0.3, 1e-3);
  test::expect_refusal([&] { (void)contact_history(impact, {-0.1}); }, {"phase"});
}

TEST(PointRayleigh, MeanLossIsThatOfTheModes) {
  constexpr double table[][2] = {{0.0, 0.158}, {0.2, 0.172}, {0.3, 0.199}, {0.45, 0.290}, {0.49, 0.331}};
  for (const auto& [nu, expected] : table) {
    EXPECT_NEAR(mean_loss_factor(nu, bodies::sphere::modes(nu, 60.0)), expected, 6e-4) << nu;
  }
}

TEST(PointRayleigh, IsTheFormulaOfTheEndsForTheSlowest) {
  // v (4πE*²/m²) Σ U²/ω⁵ cos²(ωτ/2 + Φ/2 − 5π/4), Φ = 0.5549 · 4E*U² a³/(mωv).
  const double nu = 0.3, modulus = 1.0 / 0.91, mass = 4.0 * pi / 3.0;
  const std::vector<Mode> modes = bodies::sphere::modes(nu, 10.0);
  for (const double speed : {1e-8, 1e-10}) {
    const RayleighEstimate estimate = rayleigh(PointLaw::center, nu, speed, modes);
    double ends = 0.0;
    for (const Mode& mode : modes) {
      const double phase = 0.5549 * 4.0 * modulus * mode.radial * mode.radial *
                           std::pow(estimate.impact.max_radius, 3.0) / (mass * mode.omega * speed);
      const double wave = std::cos(0.5 * (mode.omega * estimate.impact.contact_time + phase) - 1.25 * pi);
      ends += speed * 4.0 * pi * std::pow(modulus / mass, 2.0) * mode.radial * mode.radial / std::pow(mode.omega, 5.0) *
              wave * wave;
    }
    EXPECT_NEAR(estimate.lost_fraction / ends, 1.0, 0.02 * std::pow(speed / 1e-8, 0.2)) << speed;
    EXPECT_FALSE(estimate.beyond_perturbation);
  }
}

TEST(PointRayleigh, IsNearTheFullSolution) {
  struct At {
    double poisson, speed, within;
  };
  const RefinableContact body(sphere(0.3));
  const std::vector<Mode> modes = bodies::sphere::modes(0.3, 60.0);
  for (const auto& [speed, within] : {std::pair{1e-2, 0.03}, {3e-3, 0.06}, {1e-3, 0.02}, {1e-4, 0.01}}) {
    const Restitution full = restitution(body, speed, {.tolerance = 5e-3, .absolute = 1e-9});
    const RayleighEstimate estimate = rayleigh(PointLaw::center, 0.3, speed, modes);
    const double loss = full.lost_fraction.value;
    EXPECT_NEAR(estimate.lost_fraction / loss, 1.0, within) << speed;
    EXPECT_NEAR(estimate.lost_fraction, loss, estimate.lost_fraction_error + full.lost_fraction.error) << speed;
    EXPECT_FALSE(estimate.beyond_perturbation);
    const double time = estimate.impact.contact_time / full.contact_time.value - 1.0;
    EXPECT_LT(time, 0.0);
    EXPECT_GT(time, -3.5 * estimate.kinetic_share);
  }
}

TEST(PointRayleigh, ErrorEstimateHoldsForAllPoissonNumbers) {
  double tightest = 0.0;
  for (const double nu : {-0.5, 0.0, 0.45}) {
    const RefinableContact body(sphere(nu));
    const std::vector<Mode> modes = bodies::sphere::modes(nu, 60.0);
    for (const double speed : {5.5e-4, 3e-3, 0.017}) {
      const Restitution full = restitution(body, speed, {.tolerance = 5e-3, .absolute = 1e-9});
      const RayleighEstimate estimate = rayleigh(PointLaw::center, nu, speed, modes);
      const double error = std::abs(estimate.lost_fraction - full.lost_fraction.value);
      EXPECT_LT(error, estimate.lost_fraction_error + full.lost_fraction.error) << nu << " " << speed;
      tightest = std::max(tightest, error / estimate.lost_fraction_error);
    }
  }
  EXPECT_GT(tightest, 0.5);
  EXPECT_TRUE(rayleigh(PointLaw::center, 0.3, 0.1, bodies::sphere::modes(0.3, 60.0)).beyond_perturbation);
}

TEST(PointRayleigh, ShowsItsQuantities) {
  const RayleighEstimate estimate = rayleigh(PointLaw::center, 0.3, 1e-3, bodies::sphere::modes(0.3, 10.0));
  const auto& all = point_rayleigh_quantities();
  EXPECT_EQ(all.front().name, "lost_fraction");
  EXPECT_EQ(all.front().error(estimate), estimate.lost_fraction_error);
  for (const auto& quantity : all) {
    if (quantity.name != "max_radius") continue;
    EXPECT_EQ(std::get<double>(quantity.value(estimate)), estimate.impact.max_radius);
  }
  EXPECT_EQ(all.size(), 9u);
}

TEST(PointRayleigh, RefusesNonsense) {
  EXPECT_EQ(rayleigh(PointLaw::center, 0.3, 0.01, {}).lost_fraction, 0.0);
  for (const double omega : {0.0, -1.0, 1001.0, std::numeric_limits<double>::quiet_NaN()}) {
    const std::vector<Mode> wrong{{2, 0, omega, 1.0, 0.0}};
    test::expect_refusal([&] { (void)rayleigh(PointLaw::center, 0.3, 0.01, wrong); }, {"omega", "above 0 to 1000"});
  }
}

}  // namespace
}  // namespace stoss
