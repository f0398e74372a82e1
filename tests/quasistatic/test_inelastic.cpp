// Yield, adhesion and losses of round bodies in one slow motion: published yield_laws, closed forms, balances.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "stoss/quasistatic/adhesion.hpp"
#include "stoss/quasistatic/elastic_plastic.hpp"
#include "stoss/quasistatic/inelastic_impact.hpp"
#include "stoss/quasistatic/yield.hpp"
#include "support/csv.hpp"
#include "support/refusal.hpp"
#include "support/runge_kutta.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

using std::numbers::pi;

constexpr std::array yield_laws{YieldLaw::finite_elements, YieldLaw::thornton_ning};

/// Thornton and Ning (1998), as published, of r = V_y/V.
double thornton_and_ning(double r) {
  const double square = r * r;
  return std::sqrt(6.0 * std::numbers::sqrt3 / 5.0) * std::sqrt(1.0 - square / 6.0) *
         std::pow(r / (r + 2.0 * std::sqrt(6.0 / 5.0 - square / 5.0)), 0.25);
}

/// δ at which yielding begins, of an impact of V/V_y, in its units.
double yield_depth(double ratio) { return std::pow(1.25, 0.4) * std::pow(ratio, -0.8); }

TEST(Yield, HasThePublishedRestitutionOfThorntonAndNing) {
  for (const double ratio : {1.0001, 1.1, 2.0, 10.0, 100.0, 1e4}) {
    EXPECT_NEAR(plastic_restitution(YieldLaw::thornton_ning, ratio), thornton_and_ning(1.0 / ratio), 1e-12) << ratio;
  }
}

TEST(Yield, TendsToTheLawsOfHighSpeed) {
  EXPECT_NEAR(plastic_restitution(YieldLaw::thornton_ning, 1e5) * std::pow(1e5, 0.25), 1.185, 1e-3);
  // Johnson's 1.72 (p_d⁵/(E*⁴ρ))^{1/8} V^{−1/4} of a ball at p_d = 3 Y.
  const double young = 1.0, density = 1.0, strength = 1e-3, speed = 1e-4;
  const double radius = 1.0, mass = 4.0 / 3.0 * pi * density;
  const double onset = yield_speed({1.0 / radius, 1.0 / young}, mass, strength);
  const double published = 1.72 * std::pow(std::pow(3.0 * strength, 5) / density, 0.125) * std::pow(speed, -0.25);
  EXPECT_NEAR(fully_plastic_restitution(speed / onset), published, 2e-3 * published);
  EXPECT_EQ(fully_plastic_restitution(20.0), 1.0);
}

TEST(Yield, LoadsContinuouslyAndReturnsToLessThanItWent) {
  for (const YieldLaw law : yield_laws) {
    EXPECT_NEAR(loading_force(law, 1.0 + 1e-9), 1.0, 1e-8);
    EXPECT_NEAR(loading_stiffness(law, 1.0 + 1e-9), 1.5, 1e-2);
    EXPECT_NEAR(loading_work(law, 1.0), 0.4, 1e-15);
    double last = 1.0;
    for (const double depth : {1.2, 2.0, 5.0, 20.0, 100.0, 300.0, 1e4}) {
      const double step = 1e-5 * depth;
      const double slope = (loading_force(law, depth + step) - loading_force(law, depth - step)) / (2.0 * step);
      EXPECT_NEAR(loading_stiffness(law, depth), slope, 1e-6 * slope) << depth;
      const double work = (loading_work(law, depth + step) - loading_work(law, depth - step)) / (2.0 * step);
      EXPECT_NEAR(loading_force(law, depth), work, 1e-6 * work) << depth;
      EXPECT_LT(loading_force(law, depth), depth * std::sqrt(depth)) << "stronger than elastic at " << depth;
      const Unloading back = unloading(law, depth);
      EXPECT_GT(back.residual, 0.0);
      EXPECT_LT(back.residual, depth);
      EXPECT_GT(back.radius_ratio, 1.0);
      const double share = unloading_work(law, depth) / loading_work(law, depth);
      EXPECT_LT(share, last) << depth;
      last = share;
    }
  }
}

TEST(Yield, HasTheNumbersOfTheFiniteElements) {
  // Of ν = 0.3, each with the error that the study states: residual depths, ε and the speed of its compression.
  std::size_t count = 0;
  for (const auto& row : test::read_csv("yield_restitution.csv")) {
    if (row.number("nu") != 0.3) continue;
    const double depth = row.number("d_max");
    const double ratio = std::sqrt(2.5 * loading_work(YieldLaw::finite_elements, depth));
    EXPECT_NEAR(ratio, row.number("V_over_V_y"), 1e-3 * ratio);
    const double square = std::pow(plastic_restitution(YieldLaw::finite_elements, ratio), 2);
    EXPECT_NEAR(square, row.number("W_unload_over_W_load"), row.number("W_ratio_error") + 2e-3 * square) << depth;
    EXPECT_NEAR(loading_force(YieldLaw::finite_elements, depth), row.number("f_max"), 0.01 * row.number("f_max"))
        << depth;
    EXPECT_NEAR(unloading(YieldLaw::finite_elements, depth).residual, row.number("d_r"),
                row.number("d_r_error") + 1e-2 * depth)
        << depth;
    ++count;
  }
  EXPECT_GE(count, 14U);
}

TEST(Yield, RefusesWhatIsNoNumber) {
  EXPECT_THROW((void)loading_force(YieldLaw::finite_elements, -1.0), InvalidInput);
  EXPECT_THROW((void)unloading(YieldLaw::finite_elements, std::nan("")), InvalidInput);
  EXPECT_THROW((void)plastic_restitution(YieldLaw::thornton_ning, 1e6), InvalidInput);
}

TEST(Adhesion, HasThePublishedNumbers) {
  const PointPair pair{2.0, 0.5};
  const double work = 3.0, radius = 0.5, modulus = 2.0;
  const double published = 7.09 * std::cbrt(std::pow(work, 5) * std::pow(radius, 4) / (modulus * modulus));
  EXPECT_NEAR(adhesion_energy(pair, work), published, 1e-3 * published);
  const double speed = std::sqrt(14.18 / 7.0) * std::pow(std::pow(work, 5) * std::pow(radius, 4) / 4.0, 1.0 / 6.0);
  EXPECT_NEAR(sticking_speed(pair, work, 7.0), speed, 1e-3 * speed);
}

TEST(Adhesion, SolvesTheEquationsOfJohnsonKendallAndRoberts) {
  // In E* = R = 1: both equations by the contact radius.
  const double work = 1e-4, kappa = std::sqrt(2.0 * pi * work);
  const double unit = std::pow(kappa, 4.0 / 3.0), force_unit = kappa * kappa;
  for (const double a : {0.5, 1.0, 1.3, 3.0, 10.0}) {
    const double radius = a * std::cbrt(kappa) * std::cbrt(kappa);
    const double delta = radius * radius - kappa * std::sqrt(radius);
    const double force = 4.0 / 3.0 * std::pow(radius, 3) - 2.0 * kappa * std::pow(radius, 1.5);
    const double hertz = 4.0 / 3.0 * std::pow(std::max(delta, 0.0), 1.5);
    EXPECT_NEAR(adhesive_addition(delta / unit) * force_unit, force - hertz, 1e-13) << a;
  }
  const double s = std::cbrt(0.25);
  EXPECT_NEAR(parting_approach, s * s * s * s - s, 1e-16);
}

TEST(Adhesion, AddsUpToItsEnergyOverTheMotion) {
  const auto force = [](double approach) { return -adhesive_addition(approach); };
  boost::math::quadrature::tanh_sinh<double> integrator;
  const double between = integrator.integrate(force, parting_approach, 0.0);
  const double kappa_unit = std::pow(2.0 * pi, 5.0 / 3.0);  // F₀δ₀ over (w⁵R⁴/E*²)^{1/3}
  EXPECT_NEAR(between * kappa_unit, adhesion_energy({1.0, 1.0}, 1.0), 1e-7);
}

TEST(InelasticImpact, OfNothingThatTakesEnergyIsElastic) {
  const InelasticImpact got = inelastic_impact({});
  EXPECT_NEAR(got.restitution, 1.0, 1e-9);
  EXPECT_NEAR(got.max_compression, std::pow(1.25, 0.4), 1e-8);
  const double time = 2.0 / 5.0 * std::pow(1.25, 0.4) * boost::math::beta(0.4, 0.5) * 1.0;
  EXPECT_NEAR(got.contact_time, 2.0 * time, 1e-6);
  EXPECT_FALSE(got.sticks);
}

TEST(InelasticImpact, OfYieldIsThatOfTheWorkOfTheLaw) {
  for (const YieldLaw law : yield_laws) {
    for (const double ratio : {0.5, 1.5, 10.0, 300.0}) {
      const InelasticImpact got = inelastic_impact({.yield_law = law, .yield_depth = yield_depth(ratio)});
      EXPECT_NEAR(got.restitution, plastic_restitution(law, ratio), 1e-7) << ratio;
      EXPECT_NEAR(got.yield, 1.0 - got.restitution * got.restitution, 1e-7);
    }
  }
}

TEST(InelasticImpact, OfAdhesionLosesItsEnergyAndSticksBelow) {
  // (v_s/v)² = 2W/mv² is 2 · 0.3315 F₀δ₀ of the units of the impact.
  const double energy = adhesion_energy({1.0, 1.0}, 1.0 / (2.0 * pi));  // over E*R³κ^{10/3} with κ = 1
  const auto adhesion_of = [&](double ratio) {                          // v_s/v
    return std::pow(ratio * ratio / (2.0 * 0.75 * energy), 0.4);
  };
  for (const double ratio : {0.01, 0.3, 0.9, 0.99}) {
    const InelasticImpact got = inelastic_impact({.adhesion = adhesion_of(ratio)});
    EXPECT_NEAR(got.restitution, std::sqrt(1.0 - ratio * ratio), 1e-6) << ratio;
    EXPECT_NEAR(got.adhesion, ratio * ratio, 1e-7) << ratio;
    EXPECT_FALSE(got.sticks);
  }
  const InelasticImpact stuck = inelastic_impact({.adhesion = adhesion_of(1.02)});
  EXPECT_TRUE(stuck.sticks);
  EXPECT_EQ(stuck.restitution, 0.0);
}

TEST(InelasticImpact, AddsUpAndIsTheSumWhereLossesAreSmall) {
  const InelasticContact waves{.radiation = 1e-5}, plate{.mobility = 1e-5}, yields{.yield_depth = yield_depth(1.02)},
      sticks{.adhesion = 3e-3};
  const InelasticContact all{.yield_depth = yields.yield_depth,
                             .radiation = waves.radiation,
                             .mobility = plate.mobility,
                             .adhesion = sticks.adhesion};
  double sum = 0.0;
  for (const InelasticContact& each : {waves, plate, yields, sticks}) {
    const double lost = 1.0 - std::pow(inelastic_impact(each).restitution, 2);
    EXPECT_GT(lost, 1e-7);
    EXPECT_LT(lost, 1e-3);
    sum += lost;
  }
  const InelasticImpact together = inelastic_impact(all);
  const double lost = 1.0 - together.restitution * together.restitution;
  EXPECT_NEAR(lost, sum, 0.01 * sum);
  EXPECT_NEAR(together.waves + together.yield + together.adhesion, lost, 1e-8);
}

TEST(InelasticImpact, OfManyLossesIsLessThanTheirSum) {
  const InelasticContact all{.yield_depth = yield_depth(20.0), .radiation = 0.1, .adhesion = 0.1};
  const InelasticImpact got = inelastic_impact(all);
  for (const double share : {got.waves, got.yield, got.adhesion}) {
    EXPECT_GT(share, 0.0);
    EXPECT_LT(share, 1.0);
  }
  InelasticContact yields{.yield_depth = all.yield_depth};
  EXPECT_LT(got.yield, inelastic_impact(yields).yield);
  EXPECT_GT(got.restitution, 0.0);
  EXPECT_LT(got.restitution, inelastic_impact(yields).restitution);
}

TEST(InelasticImpact, OfAThinPlateIsZenersEquation) {
  // C. Zener's ε at his λ = 0.1 and 0.5, here by a fourth-order integration with fixed steps in the compression rate.
  for (const double mobility : {0.05, 0.3, 1.0}) {
    // With dδ/dt = 1 − ∫F dt − αF: δ and the impulse J of the force.
    const auto force = [](double delta) { return std::pow(std::max(delta, 0.0), 1.5); };
    const auto slope = [&](const std::array<double, 2>& its) {
      return std::array{1.0 - its[1] - mobility * force(its[0]), force(its[0])};
    };
    std::array its{0.0, 0.0};
    for (int i = 0; i < 400000 && (i < 10 || its[0] > 0.0); ++i) its = test::runge_kutta_step(its, 1e-4, slope);
    EXPECT_NEAR(inelastic_impact({.mobility = mobility}).restitution, its[1] - 1.0, 1e-5) << mobility;
  }
}

TEST(InelasticImpact, RefusesWhatIsNoNumber) {
  EXPECT_THROW((void)inelastic_impact({.yield_depth = 0.0}), InvalidInput);
  EXPECT_THROW((void)inelastic_impact({.yield_depth = std::nan("")}), InvalidInput);
  EXPECT_THROW((void)inelastic_impact({.radiation = -1.0}), InvalidInput);
  EXPECT_THROW((void)inelastic_impact({.adhesion = std::numeric_limits<double>::infinity()}), InvalidInput);
}

}  // namespace
}  // namespace stoss
