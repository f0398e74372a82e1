// Oblique impacts of spheres, by what must hold exactly.
#include <gtest/gtest.h>

#include <cmath>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/oblique.hpp"
#include "stoss/impact/vibration.hpp"
#include "support/refusal.hpp"
#include "support/rings.hpp"

namespace stoss {
namespace {

using test::rings;

TEST(ObliqueSphere, LeavesTheNormalImpactAsItIsToTheLastBit) {
  for (const double speed : {1e-3, 0.1}) {
    const Contact wall = contact(sphere(0.3, 8.0));
    const Impact central = impact(wall, speed);
    for (const double friction : {0.0, 1e-6, 0.3, 5.0}) {
      const ObliqueImpact oblique = oblique_impact(wall, speed, {0.5 * speed, 0.0, 0.0, friction});
      EXPECT_EQ(oblique.restitution, central.restitution);
      EXPECT_EQ(oblique.normal.energy_error, central.energy_error);
      EXPECT_EQ(oblique.normal.steps, central.steps);
    }
  }
}

TEST(ObliqueSphere, DependsOnSlidingOverFrictionAlone) {
  const SharedNormalImpact shared(contact(sphere(0.3, 8.0)), 0.05, rings(24, 0.0625));
  const ObliqueImpact one = shared.with({0.03, 0.01, 0.0, 0.5}), other = shared.with({0.015, 0.005, 0.0, 0.25});
  EXPECT_EQ(one.tangential_restitution, other.tangential_restitution);
  EXPECT_EQ(one.spin_after, 2.0 * other.spin_after);
}

TEST(ObliqueSphere, ComesToTheSmoothOneAsFrictionGoes) {
  const SharedNormalImpact shared(contact(sphere(0.3, 8.0)), 0.05, rings(24, 0.0625));
  const ObliqueImpact smooth = shared.with({0.02, -0.01, 0.0, 0.0});
  EXPECT_EQ(smooth.tangential_restitution, -1.0);
  EXPECT_EQ(smooth.tangential_after, 0.02);
  EXPECT_EQ(smooth.spin_after, -0.01);
  EXPECT_EQ(smooth.energy.friction, 0.0);
  const ObliqueImpact nearly = shared.with({0.02, -0.01, 0.0, 1e-9});
  EXPECT_NEAR(nearly.tangential_after, 0.02, 1e-9);
  EXPECT_NEAR(nearly.spin_after, -0.01, 1e-9);
  EXPECT_NEAR(nearly.energy.translation, smooth.energy.translation, 1e-9);
}

TEST(ObliqueSphere, KeepsItsEnergyToTheSquareOfTheStep) {
  const Contact wall = contact(sphere(0.3, 8.0));
  const auto error = [&](double step) {
    return std::abs(oblique_impact(wall, 0.1, {0.05, 0.0, 0.0, 0.5}, rings(16, step)).energy_error);
  };
  EXPECT_GT(error(1.0 / 16.0), 3.0 * error(1.0 / 32.0));
  EXPECT_LT(error(1.0 / 32.0), 1e-4);
}

TEST(ObliqueSphere, FeelsSlidingAloneHoweverItIsMadeWhereTheContactIsSmall) {
  double before = 1.0;
  for (const double speed : {1e-2, 1e-4, 1e-6}) {
    const SharedNormalImpact shared(contact(sphere(0.3, 4.0)), speed, rings(16, 0.125));
    const double moving = shared.with({0.3 * speed, 0.0, 0.0, 0.3}).sliding_after;
    const double turning = shared.with({0.0, 0.3 * speed, 0.0, 0.3}).sliding_after;
    const double apart = std::abs(moving - turning) / (0.3 * speed), half_width = shared.normal().max_half_width;
    EXPECT_LT(apart, half_width * half_width);
    EXPECT_LT(apart, 0.2 * before);
    before = apart;
  }
}

TEST(ObliqueSphere, LosesInItsMaterialAlongTheSurfaceToo) {
  constexpr double cutoff = 8.0;
  const auto after = [&](double loss_time, double step) {
    Sphere given{0.3};
    given.loss_time = loss_time;
    return oblique_impact(contact(sphere(given, cutoff)), 0.05, {0.02, 0.0, 0.0, 0.3}, rings(24, step));
  };
  const ObliqueImpact elastic = after(0.0, 0.0625), nearly = after(1e-6, 0.0625), lossy = after(0.1, 0.0625);
  EXPECT_NEAR(nearly.tangential_restitution, elastic.tangential_restitution, 2e-3);
  EXPECT_LT(lossy.tangential_restitution, elastic.tangential_restitution - 0.05);
  // More is dissipated than by the motion along the normal.
  const double normal = 0.05 * 0.05 / (0.05 * 0.05 + 0.02 * 0.02);
  EXPECT_GT(lossy.energy.dissipated, normal * lossy.normal.energy.dissipated * 1.01);
  EXPECT_GT(lossy.energy.unresolved, 0.0);
  EXPECT_LT(lossy.angular_momentum_error, 1e-13);
  EXPECT_GT(std::abs(lossy.energy_error), 3.0 * std::abs(after(0.1, 0.03125).energy_error));
  EXPECT_LT(std::abs(lossy.energy_error), 1e-3);
}

TEST(ObliqueSphere, MayVibrateBefore) {
  const Contact wall = contact(sphere(0.3, 8.0));
  ImpactOptions options = rings(16, 0.0625);
  options.start = approach(wall, 0.02, {{0, 2, 0, 0.5, 1.0}});
  const ObliqueImpact its = oblique_impact(wall, 0.02, {0.01, 0.0, 0.0, 0.3}, options);
  EXPECT_EQ(its.restitution, impact(wall, 0.02, options).restitution);
  EXPECT_LT(its.momentum_error, 1e-13);
  EXPECT_LT(std::abs(its.energy_error), 1e-3);
  EXPECT_GT(its.energy.friction, 0.0);
}

TEST(ObliqueImpact, RefusesStepsThatDoNotResolveTheContact) {
  // A few steps in the contact with a sphere that is much smaller.
  constexpr double cutoff = 3.25, radius = 0.036;
  const Contact pair = contact(sphere(Sphere{0.0}, cutoff), sphere(Sphere{0.0, radius}, cutoff * radius));
  const ImpactOptions coarse = rings(45, 0.5 / cutoff);
  (void)impact(pair, 0.1, coarse);
  EXPECT_THROW((void)oblique_impact(pair, 0.1, {0.0008, 0.0008, 0.05, 0.02}, coarse), NotConverged);
  EXPECT_NO_THROW((void)oblique_impact(pair, 0.1, {0.0008, 0.0008, 0.05, 0.02}, rings(45, 0.005)));
}

TEST(ObliqueImpact, RefusesWhatItCannotCompute) {
  const Contact wall = contact(sphere(0.3, 8.0));
  const auto refused = [](const Contact& its, const Obliquity& obliquity) {
    return [&its, obliquity] { (void)oblique_impact(its, 0.05, obliquity); };
  };
  test::expect_refusal(refused(wall, {2.0, 0.0, 0.0, 0.3}), {"tangential", "2"});
  test::expect_refusal(refused(wall, {0.0, 2.0, 0.0, 0.3}), {"spin", "2"});
  test::expect_refusal(refused(wall, {0.0, 0.0, 0.1, 0.3}), {"second_spin", "only 0"});
  test::expect_refusal(refused(wall, {0.1, 0.0, 0.0, 5.1}), {"friction", "5.1"});
  test::expect_refusal(refused(wall, {std::nan(""), 0.0, 0.0, 0.1}), {"tangential"});
  const Contact bar = contact(rod(20.0)), soft = contact(sphere(0.3, 8.0), ExponentialWall{});
  test::expect_refusal(refused(bar, {0.1, 0.0, 0.0, 0.3}), {"friction", "rod"});
  EXPECT_GT(oblique_impact(soft, 0.05, {0.1, 0.0, 0.0, 0.3}).energy.friction, 0.0);
  EXPECT_EQ(oblique_impact(bar, 0.05, {0.1, 0.0, 0.0, 0.0}).tangential_restitution, -1.0);
  test::expect_refusal([] { (void)SharedNormalImpact(contact(disk(0.3, 8.0)), 0.05); }, {"disk"});
}

}  // namespace
}  // namespace stoss
