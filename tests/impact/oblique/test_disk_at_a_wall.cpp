// Oblique impacts of disks at a rigid wall: independent finite elements, limits and balances.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

#include "impact/oblique/resolved.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/oblique.hpp"
#include "stoss/impact/vibration.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace oblique_disks {
namespace {

using test::resolved;

struct Case {
  double friction, tangential;
  // Of finite elements, linear kinematics, ν = 0.33, v = 0.1.
  double restitution, tangential_restitution, heat, vibration;
};

void PrintTo(const Case& its, std::ostream* out) { *out << "mu " << its.friction << ", v_t " << its.tangential; }

class ObliqueDiskAtAWall : public ::testing::TestWithParam<Case> {
 protected:
  static constexpr double speed = 0.1;
  const Contact wall = contact(disk(0.33, 20.0));
};

// The error falls as 1/cutoff; the split of friction and vibration differs by 0.002 at μ = 1.
TEST_P(ObliqueDiskAtAWall, IsThatOfFiniteElements) {
  const Case& its = GetParam();
  const ObliqueImpact impact =
      oblique_impact(wall, speed, {its.tangential, 0.0, 0.0, its.friction}, resolved(wall, 32, 0.25));
  EXPECT_NEAR(impact.restitution, its.restitution, 2e-4);
  if (its.tangential > 0.0) {
    EXPECT_NEAR(impact.tangential_restitution, its.tangential_restitution, 4e-3);
  }
  EXPECT_NEAR(impact.energy.friction, its.heat, 2.5e-3);
  EXPECT_NEAR(impact.energy.friction + impact.energy.vibration + impact.energy.unresolved, its.heat + its.vibration,
              2e-3);
}

TEST_P(ObliqueDiskAtAWall, ClosesItsBalances) {
  const Case& its = GetParam();
  const Obliquity obliquity{its.tangential, 0.02, 0.0, its.friction};
  double last = 1.0;
  for (const double share : {0.5, 0.25}) {
    const ObliqueImpact impact = oblique_impact(wall, speed, obliquity, resolved(wall, 24, share));
    EXPECT_LT(impact.normal.momentum_error, 1e-13);
    EXPECT_LT(impact.momentum_error, 1e-13);
    EXPECT_LT(impact.angular_momentum_error, 1e-13);
    EXPECT_LT(std::abs(impact.energy_error), 4e-4);
    EXPECT_LT(std::abs(impact.energy_error), 0.4 * last);  // second order
    last = std::abs(impact.energy_error);
    EXPECT_GE(impact.energy.friction, 0.0);
    EXPECT_GE(impact.energy.unresolved, 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, ObliqueDiskAtAWall,
                         ::testing::Values(Case{0.1, 0.2, 0.94700, -0.7118, 0.1334, 0.0208},
                                           Case{0.3, 0.1, 0.94595, 0.4926, 0.1211, 0.0649},
                                           Case{1.0, 0.0, 0.94877, 0.0, 0.0027, 0.0971},
                                           Case{1.0, 0.1, 0.94155, 0.4759, 0.0713, 0.1148}));

class ObliqueDisk : public ::testing::Test {
 protected:
  const Contact wall = contact(disk(0.33, 16.0));
};

TEST_F(ObliqueDisk, TendToTheCentralImpactWithoutFriction) {
  const ImpactOptions options = resolved(wall, 32);
  const Impact central = impact(wall, 0.1, options);
  // Points that move along the surface carry mass there, too, which the central impact leaves out.
  constexpr double left_out = 2e-6;
  const ObliqueImpact nearly = oblique_impact(wall, 0.1, {0.1, 0.05, 0.0, 1e-6}, options);
  EXPECT_NEAR(nearly.restitution, central.restitution, left_out);
  EXPECT_NEAR(nearly.tangential_restitution, -1.0, 1e-5);
  EXPECT_NEAR(nearly.normal.contact_time, central.contact_time, 0.02);
  EXPECT_NEAR(nearly.normal.max_force, central.max_force, 1e-4);
  EXPECT_NEAR(nearly.normal.max_half_width, central.max_half_width, 1e-4);
}

// While unlike bodies spread under pressure, their points slide at their limit, and a slow sliding along costs little:
// without that, as between equal disks, ε_t is 0.075 here.
TEST_F(ObliqueDisk, MixDirectionsWhereTheyNearlyStick) {
  const Contact coarse = contact(disk(0.33, 11.3));
  const ObliqueImpact impact = oblique_impact(coarse, 0.003, {1.5e-4, 0.0, 0.0, 0.1}, resolved(coarse, 24));
  EXPECT_NEAR(impact.tangential_restitution, 0.496, 2e-3);
  const ObliqueImpact rougher = oblique_impact(coarse, 0.003, {4.5e-4, 0.0, 0.0, 0.3}, resolved(coarse, 24));
  EXPECT_NEAR(rougher.tangential_restitution, 0.199, 2e-3);
}

// The same, at a wall: its mixed impedance is about 1e-3 of ε_t.
TEST_F(ObliqueDisk, OfOtherKindsAreThoseOfAnotherProgram) {
  struct Outcome {
    double poisson, speed, friction, tangential, restitution, tangential_restitution;
  };
  for (const Outcome& its : {Outcome{0.0, 0.05, 0.5, 0.05, 0.967546, 0.436893},
                             {0.7, 0.02, 0.2, 0.012, 0.977038, 0.535752},
                             {-0.5, 0.03, 0.3, 0.0135, 0.964735, 0.110646},
                             {0.33, 1e-3, 0.3, 3e-4, 0.983287, 0.227298},
                             {0.33, 0.3, 0.3, 0.09, 0.844359, 0.575603}}) {
    const Contact other = contact(disk(its.poisson, 16.0));
    const ObliqueImpact impact =
        oblique_impact(other, its.speed, {its.tangential, 0.0, 0.0, its.friction}, resolved(other, 28));
    EXPECT_NEAR(impact.restitution, its.restitution, 1e-4) << its.poisson;
    EXPECT_NEAR(impact.tangential_restitution, its.tangential_restitution, 3e-3) << its.poisson;
  }
}

// A small contact cannot tell a spin from a velocity: what differs goes with the square of its width.
TEST_F(ObliqueDisk, HardlyTellSpinFromSlidingWhereTheyAreSlow) {
  double last = 1.0;
  for (const double speed : {1e-2, 1e-3, 1e-4}) {
    const ImpactOptions options = resolved(wall, 24);
    const ObliqueImpact moved = oblique_impact(wall, speed, {speed, 0.0, 0.0, 0.5}, options);
    const ObliqueImpact spun = oblique_impact(wall, speed, {0.0, speed, 0.0, 0.5}, options);
    const double away = std::abs(moved.tangential_restitution - spun.tangential_restitution);
    EXPECT_LT(away, 0.2 * last);
    last = away;
  }
  EXPECT_LT(last, 1e-4);
}

// A wide contact rolls less well than it slides: points beside the foremost one move less.
TEST_F(ObliqueDisk, TellSpinFromSliding) {
  const ObliqueImpact spun = oblique_impact(wall, 0.1, {0.0, 0.1, 0.0, 0.3}, resolved(wall, 32));
  EXPECT_NEAR(spun.tangential_restitution, 0.47738, 2e-4);
  EXPECT_NEAR(spun.restitution, 0.946256, 1e-5);
}

TEST_F(ObliqueDisk, LoseToTheirMaterialInBothDirections) {
  const auto outcome = [](double loss_time) {
    Disk lossy{0.33};
    lossy.loss_time = loss_time;
    const Contact met = contact(disk(lossy, 16.0));
    return oblique_impact(met, 0.1, {0.1, 0.0, 0.0, 0.3}, resolved(met, 24));
  };
  const ObliqueImpact elastic = outcome(0.0), nearly = outcome(1e-6), lossy = outcome(0.05);
  EXPECT_EQ(elastic.energy.dissipated, 0.0);
  EXPECT_NEAR(nearly.restitution, elastic.restitution, 1e-5);
  EXPECT_NEAR(nearly.tangential_restitution, elastic.tangential_restitution, 1e-4);
  EXPECT_LT(lossy.restitution, elastic.restitution - 0.03);
  EXPECT_GT(lossy.energy.dissipated, 0.05);
  EXPECT_LT(std::abs(lossy.energy_error), 4e-4);
  EXPECT_LT(lossy.tangential_restitution, elastic.tangential_restitution);
}

TEST_F(ObliqueDisk, VibrateBefore) {
  ImpactOptions options = resolved(wall, 24, 0.25);
  options.start = approach(wall, 0.1, {{0, 2, 0, 0.1, 1.0}, {0, 0, 0, 0.05, 0.3}});
  const ObliqueImpact impact = oblique_impact(wall, 0.1, {0.1, 0.0, 0.0, 0.3}, options);
  EXPECT_LT(std::abs(impact.energy_error), 1e-4);
  EXPECT_NEAR(impact.normal.energy.modes.front().before, 0.05 / 2.15, 1e-6);  // of 1 + 1 + 0.15
  const ObliqueImpact smooth = oblique_impact(wall, 0.1, {0.1, 0.0, 0.0, 1e-7}, options);
  EXPECT_NEAR(smooth.restitution, stoss::impact(wall, 0.1, options).restitution, 2e-5);
}

TEST_F(ObliqueDisk, GrowTheirGridAsTheyNeed) {
  ImpactOptions options = resolved(wall, 20);
  options.resolution.half_width = 0.25;
  const ObliqueImpact impact = oblique_impact(wall, 0.1, {0.1, 0.0, 0.0, 0.3}, options);
  EXPECT_GT(impact.normal.resolution.half_width, 0.45);
  EXPECT_NEAR(impact.restitution, 0.9461, 1e-3);
}

// Coulomb's law has no solution for every friction between unlike bodies: nothing is returned then.
TEST_F(ObliqueDisk, RefuseFrictionThatHasNoSolution) {
  const Contact soft = contact(disk(-0.6, 11.3));
  const std::string message = test::message_of<NotConverged>([&] {
    (void)oblique_impact(soft, 0.0265, {0.0886, 0.0, 0.0, 4.29}, resolved(soft, 24));
  });
  EXPECT_NE(message.find("friction"), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST_F(ObliqueDisk, RefuseWhatTheyDoNotKnow) {
  const Obliquity rough{0.1, 0.0, 0.0, 0.3};
  ImpactOptions options;
  options.resolution.tail = Tail::quasistatic;
  test::expect_refusal([&] { (void)oblique_impact(wall, 0.1, rough, options); }, {"tail", "radiating"});
}

}  // namespace
}  // namespace oblique_disks
}  // namespace stoss
