// Bodies that meet a half-space: values computed independently, limits, and what does not depend on units.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/errors.hpp"
#include "stoss/quasistatic/half_space_radiation.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/csv.hpp"

namespace stoss {
namespace {

RefinableContact ball_on(const HalfSpace& solid, double poisson = 0.3) { return {sphere(poisson), half_space(solid)}; }

TEST(RestitutionOnAHalfSpace, AgreesWithTheReferenceWithinBothErrors) {
  for (const auto& row : test::read_csv("half_space_restitution.csv")) {
    const bool ball = row.text("body") == "sphere", stiff = row.number("rigid_body") == 1.0;
    const double speed = row.number("speed");
    SCOPED_TRACE(row.text("body") + (stiff ? ", rigid" : "") + ", v = " + std::to_string(speed));
    const BodyMaker body = ball ? sphere(0.3) : disk(0.33);
    const BodyMaker solid = ball ? half_space(HalfSpace{0.3}) : half_plane(HalfPlane{0.33});
    const RefinableContact contact(stiff ? rigid(body) : body, solid);
    for (const double tolerance : {1e-3, 1e-4}) {
      const Restitution found = restitution(contact, speed, {.tolerance = tolerance});
      EXPECT_TRUE(found.converged);
      EXPECT_NEAR(found.lost_fraction.value, row.number("lost_fraction"),
                  found.lost_fraction.error + row.number("uncertainty"));
      EXPECT_NEAR(found.contact_time.value, row.number("contact_time"), found.contact_time.error + 0.02);
      EXPECT_NEAR(found.max_compression.value, row.number("max_compression"),
                  found.max_compression.error + 1e-3 * row.number("max_compression"));
    }
  }
}

// Found by a search over random half-spaces: three runs whose impulse times, 7.29063, 7.29180, 7.29132, agree by
// chance.
TEST(RestitutionOnAHalfSpace, TellsTheErrorOfAnImpulseTimeOfRunsThatAgreeByChance) {
  const RefinableContact contact(sphere(0.383),
                                 half_space(HalfSpace{.poisson = 0.275, .young = 5.17, .density = 0.422}));
  const Restitution usual = restitution(contact, 0.0416);
  const Restitution fine = restitution(contact, 0.0416, {.tolerance = 5e-5, .absolute = 5e-8});
  EXPECT_NEAR(usual.impulse_time.value, fine.impulse_time.value, usual.impulse_time.error);
}

TEST(RestitutionOnAHalfSpace, OfADiskIsTheLimitOfLargeDisks) {
  for (const double poisson : {-0.95, -0.8, 0.33}) {
    const RefinableContact large(disk(0.33), disk(Disk{poisson, 1000.0}));
    const RefinableContact plane(disk(0.33), half_plane(HalfPlane{poisson}));
    const Restitution one = restitution(large, 0.1), limit = restitution(plane, 0.1);
    EXPECT_NEAR(one.lost_fraction.value, limit.lost_fraction.value, one.lost_fraction.error + limit.lost_fraction.error)
        << poisson;
  }
}

/// A sphere that is flat where it is touched.
Body with_facet(Body body) {
  body.curvature = 0.0;
  body.surface = [surface = body.surface](const ContactPoints& points) {
    Surface flat = surface(points);
    std::fill(flat.recess.begin(), flat.recess.end(), 0.0);
    return flat;
  };
  return body;
}

TEST(RestitutionOnAHalfSpace, IsTheLimitOfLargeSpheresWithAFacet_long) {
  // Other modes and another code. Rayleigh waves on a sphere are slower by a series in 1/R, of which three radii give
  // the limit: 3 f(60) − 8 f(80) + 6 f(120).
  constexpr double cutoff = 8.0, speed = 0.01;
  const ImpactOptions options{.resolution = {.step = 0.25 / cutoff, .nodes = 64}};
  const auto lost_to_sphere = [&](double radius) {
    const Body large = with_facet(sphere(Sphere{0.3, radius}, cutoff * radius));
    return impact(contact(rigid(sphere(0.3))(cutoff, {}), large), speed, options).lost_fraction;
  };
  const double limit = 3.0 * lost_to_sphere(60.0) - 8.0 * lost_to_sphere(80.0) + 6.0 * lost_to_sphere(120.0);
  const Contact plane = contact(rigid(sphere(0.3)), half_space(HalfSpace{0.3}), cutoff, speed);
  EXPECT_NEAR(impact(plane, speed, options).lost_fraction / limit, 1.0, 1e-4);
}

TEST(RestitutionOnAHalfSpace, OfASlowBallIsThatOfTheTheoryOfSlowImpacts) {
  for (const double speed : {1e-7, 1e-6, 1e-5}) {
    const Restitution found = restitution(ball_on({0.3}), speed, {.absolute = 0.0});
    const quasistatic::HalfSpaceRadiation theory = quasistatic::half_space_radiation(
        quasistatic::PointLaw::center, {.poisson = 0.3, .half_space_poisson = 0.3}, speed);
    EXPECT_TRUE(found.converged);
    // The ball keeps some v/c as vibration besides.
    EXPECT_NEAR(found.lost_fraction.value, theory.lost_fraction,
                found.lost_fraction.error + theory.lost_fraction_error + 0.4 * speed);
  }
}

TEST(RestitutionOnAHalfSpace, OfAStiffAndHeavySolidIsThatAtAWall) {
  for (const double speed : {0.1, 0.01}) {
    const Restitution wall = restitution(sphere(0.3), speed);
    const Restitution stiff = restitution(ball_on({0.3, 1e6, 1e6}), speed);
    EXPECT_NEAR(stiff.lost_fraction.value, wall.lost_fraction.value,
                wall.lost_fraction.error + stiff.lost_fraction.error + 1e-5 * speed);
    EXPECT_LT(stiff.finest.energy.lost_to_second, 1e-3 * stiff.finest.energy.lost_to_first);
  }
}

TEST(RestitutionOnAHalfSpace, OfAStiffBallIsThatOfARigidOne) {
  // A ball 1e4 times stiffer and of the same mass, in its own units, at the same speed in those of the half-space.
  constexpr double stiff = 1000.0;
  const double unit = std::sqrt(stiff);
  const Restitution elastic =
      restitution(RefinableContact(sphere(0.3), half_space(HalfSpace{0.3, 1.0 / stiff, 1.0})), 0.05 / unit);
  const Restitution ideal =
      restitution(RefinableContact(rigid(sphere(0.3)), half_space(HalfSpace{0.3, 1.0 / stiff, 1.0})), 0.05 / unit);
  EXPECT_NEAR(elastic.lost_fraction.value / ideal.lost_fraction.value, 1.0, 2e-3);
  EXPECT_LT(elastic.lost_fraction.value, ideal.lost_fraction.value);
}

TEST(RestitutionOnAHalfSpace, DoesNotDependOnUnits) {
  // Steel on glass, a ball of 5 mm.
  const Sphere steel{0.3, 5e-3, 210e9, 7850.0};
  const HalfSpace glass{0.23, 70e9, 2500.0};
  const HalfSpace ratios{0.23, 70.0 / 210.0, 2500.0 / 7850.0};
  const double speed = 1.0 / std::sqrt(210e9 / 7850.0);
  const Restitution in_si = restitution(RefinableContact(sphere(steel), half_space(glass)), speed);
  const Restitution in_ratios = restitution(ball_on(ratios), speed);
  EXPECT_NEAR(in_si.lost_fraction.value, in_ratios.lost_fraction.value, 1e-9);
  EXPECT_NEAR(in_si.lost_fraction.value, 0.0085314, in_si.lost_fraction.error + 7.5e-6);
  // With cutoffs up to 22.6: 45.978 µs, to half a step at either end of 0.025 µs.
  const double unit = scales(steel).time;
  EXPECT_NEAR(in_si.contact_time.value * unit, 45.978e-6, in_si.contact_time.error * unit);
  EXPECT_LT(in_si.contact_time.error * unit, 0.4e-6);
  const Restitution finer = restitution(ball_on(ratios), speed, {.tolerance = 1e-4});
  EXPECT_NEAR(finer.contact_time.value * unit, 46.0e-6, 0.1e-6);
}

// Slow impacts last longer, and lower cutoffs are as fine for them. Those of a body that loses energy are not.
TEST(RestitutionOnAHalfSpace, BeginsLowerWhereItLastsLonger) {
  const auto first = [](const RefinableContact& contact, double speed) {
    return restitution(contact, speed, {.tolerance = 1e-2}).runs.front().cutoff / contact.cutoff(0);
  };
  const RefinableContact ball = ball_on({0.3});
  EXPECT_DOUBLE_EQ(first(ball, 0.1), 1.0);
  EXPECT_DOUBLE_EQ(first(ball, 0.01), std::exp2(-0.5));
  EXPECT_DOUBLE_EQ(first(ball, 1e-4), std::exp2(-0.75));
  EXPECT_DOUBLE_EQ(first(ball, 1e-6), std::exp2(-0.75));
  EXPECT_DOUBLE_EQ(first(ball_on({.poisson = 0.3, .loss_time = 0.1}), 0.01), 1.0);
  EXPECT_DOUBLE_EQ(first(RefinableContact(sphere(0.3)), 1e-4), 1.0);
}

TEST(RestitutionOnAHalfSpace, ClosesItsLedger) {
  const Restitution found = restitution(ball_on({0.3}), 0.01, {.tolerance = 1e-4});
  const EnergyLedger& energy = found.finest.energy;
  EXPECT_NEAR(energy.lost_to_first + energy.lost_to_second, found.finest.lost_fraction,
              std::abs(found.finest.energy_error) + 1e-12);
  EXPECT_NEAR(energy.lost_to_first, 6.8e-4, 0.2e-4);  // of independent runs with 0.0780 for the other
  EXPECT_NEAR(energy.lost_to_second, 0.0780, 1e-4);
  EXPECT_LT(found.finest.momentum_error, 1e-9);
}

TEST(RestitutionOnAHalfSpace, LengthensAHalfSpaceThatAContactOutlasts) {
  // Hertz' time is too short where a ball is much softer than he assumes.
  const RefinableContact soft(sphere(0.3), half_space(HalfSpace{0.3, 0.01, 1.0}));
  const Restitution found = restitution(soft, 0.05, {.tolerance = 1e-2});
  EXPECT_TRUE(found.converged);
  const Contact brief = contact(sphere(0.3), half_space(HalfSpace{0.3}), 6.0, 0.1);
  EXPECT_THROW((void)impact(brief, 1e-6), NotConverged);
  EXPECT_NEAR(impact(brief, 0.1).lost_fraction, 0.3031, 3e-4);
}

TEST(RestitutionOnAHalfSpace, RefusesWhatCannotMeet) {
  const HalfSpace solid{0.3};
  const auto meet = [](const BodyMaker& first, const BodyMaker& second) { (void)RefinableContact(first, second); };
  EXPECT_THROW(meet(disk(0.3), half_space(solid)), InvalidInput);
  EXPECT_THROW(meet(sphere(0.3), half_plane(HalfPlane{0.3})), InvalidInput);
  EXPECT_THROW(meet(rod(Rod{}), half_space(solid)), InvalidInput);
  EXPECT_THROW(meet(half_space(solid), sphere(0.3)), InvalidInput);
  EXPECT_THROW(meet(half_space(solid), half_space(solid)), InvalidInput);
  EXPECT_THROW(meet(rigid(sphere(0.3)), rigid(sphere(0.3))), InvalidInput);
  EXPECT_THROW(meet(sphere(0.3), half_space(HalfSpace{0.3, 9e-7})), InvalidInput);
  EXPECT_THROW(meet(sphere(0.3), half_space(HalfSpace{0.3, 1.1e6})), InvalidInput);
  EXPECT_THROW(meet(sphere(0.3), half_space(HalfSpace{0.3, 1.0, 1.1e6})), InvalidInput);
  EXPECT_THROW((void)contact(half_space(solid, 10.0, 10.0)), InvalidInput);
  EXPECT_THROW((void)contact(rigid(sphere(0.3))(10.0, {})), InvalidInput);
}

TEST(RestitutionOnAHalfSpace, RefusesSpeedsAboveTheSlowerWaveSpeed) {
  const RefinableContact soft(sphere(0.3), half_space(HalfSpace{0.3, 1e-3}));
  EXPECT_THROW((void)restitution(soft, 0.1), InvalidInput);
  EXPECT_TRUE(restitution(soft, 0.01).converged);
}

TEST(RestitutionOnAHalfSpace, ConvergesOverItsRange_long) {
  for (const double young : {1e-3, 0.03, 1.0, 300.0, 1e6}) {
    for (const double density : {0.1, 1.0, 10.0}) {
      for (const double poisson : {-0.95, 0.0, 0.4999}) {
        const RefinableContact contact = ball_on({poisson, young, density});
        const double own = std::min(1.0, std::sqrt(young / density));
        for (const double speed : {1e-4 * own, 0.3 * own}) {
          SCOPED_TRACE(std::to_string(young) + ", " + std::to_string(density) + ", " + std::to_string(poisson) + ", " +
                       std::to_string(speed));
          Restitution found;
          ASSERT_NO_THROW(found = restitution(contact, speed, {.tolerance = 1e-2}));
          EXPECT_TRUE(found.converged);
          EXPECT_GT(found.lost_fraction.value, 0.0);
          EXPECT_GT(found.restitution.value, 0.0);
        }
      }
    }
  }
}

}  // namespace
}  // namespace stoss
