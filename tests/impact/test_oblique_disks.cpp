// Oblique impacts of disks: independent finite elements, identities, limits and balances.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/oblique.hpp"
#include "stoss/impact/vibration.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace oblique_disks {
namespace {

ImpactOptions resolved(const Contact& contact, int nodes, double share = 0.5) {
  ImpactOptions options;
  options.resolution.step = share / contact.cutoff;
  options.resolution.nodes = nodes;
  return options;
}

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

TEST_P(ObliqueDiskAtAWall, IsMirroredWithTheSignOfTheSlip) {
  const Case& its = GetParam();
  const auto outcome = [&](double sign) {
    return oblique_impact(wall, speed, {sign * its.tangential, sign * 0.03, 0.0, its.friction}, resolved(wall, 24));
  };
  const ObliqueImpact one = outcome(1.0), other = outcome(-1.0);
  EXPECT_NEAR(other.restitution, one.restitution, 1e-11);
  EXPECT_NEAR(other.sliding_after, -one.sliding_after, 1e-12);
  EXPECT_NEAR(other.spin_after, -one.spin_after, 1e-12);
  EXPECT_NEAR(other.energy.friction, one.energy.friction, 1e-11);
}

TEST_P(ObliqueDiskAtAWall, GivesTheSameBits) {
  const Case& its = GetParam();
  const auto outcome = [&] {
    return oblique_impact(wall, speed, {its.tangential, 0.0, 0.0, its.friction}, resolved(wall, 16));
  };
  const ObliqueImpact one = outcome(), other = outcome();
  EXPECT_EQ(one.restitution, other.restitution);
  EXPECT_EQ(one.sliding_after, other.sliding_after);
  EXPECT_EQ(one.energy_error, other.energy_error);
}

INSTANTIATE_TEST_SUITE_P(Every, ObliqueDiskAtAWall,
                         ::testing::Values(Case{0.1, 0.2, 0.94700, -0.7118, 0.1334, 0.0208},
                                           Case{0.3, 0.1, 0.94595, 0.4926, 0.1211, 0.0649},
                                           Case{1.0, 0.0, 0.94877, 0.0, 0.0027, 0.0971},
                                           Case{1.0, 0.1, 0.94155, 0.4759, 0.0713, 0.1148}));

class ObliqueDisks : public ::testing::Test {
 protected:
  const Contact wall = contact(disk(0.33, 16.0));
};

// Equal bodies press each other as a wall does at half the speed, whatever they do along their surfaces.
TEST_F(ObliqueDisks, OfOneKindDoNotMixDirections) {
  const Contact pair = contact(disk(0.33, 16.0), disk(0.33, 16.0));
  ImpactOptions options = resolved(pair, 32);
  options.resolution.half_width = 0.58229;
  const double alone = impact(pair, 0.2, options).restitution;
  const ObliqueImpact rough = oblique_impact(pair, 0.2, {0.1, 0.0, 0.0, 1.0}, options);
  const ObliqueImpact smooth = oblique_impact(pair, 0.2, {0.2, 0.0, 0.0, 0.3}, options);
  EXPECT_NEAR(rough.restitution, alone, 1e-12);
  EXPECT_NEAR(smooth.restitution, alone, 1e-12);
  // Of an independent program.
  EXPECT_NEAR(rough.tangential_restitution, 0.38502970, 1e-7);
  EXPECT_NEAR(smooth.tangential_restitution, 0.51709884, 1e-7);
  EXPECT_NEAR(rough.energy.friction, 0.029566, 1e-5);
  EXPECT_NEAR(rough.spin_after, rough.second_spin_after, 1e-14);
  EXPECT_NEAR(rough.spin_after, -0.046033, 1e-6);
  EXPECT_NEAR(rough.tangential_after, 0.053562, 1e-6);
}

TEST_F(ObliqueDisks, TendToTheCentralImpactWithoutFriction) {
  const ImpactOptions options = resolved(wall, 32);
  const Impact central = impact(wall, 0.1, options);
  const ObliqueImpact smooth = oblique_impact(wall, 0.1, {0.1, 0.05, 0.0, 0.0}, options);
  EXPECT_EQ(smooth.restitution, central.restitution);
  EXPECT_EQ(smooth.normal.steps, central.steps);
  EXPECT_EQ(smooth.tangential_restitution, -1.0);
  // Points that move along the surface carry mass there, too, which the central impact leaves out.
  constexpr double left_out = 2e-6;
  const ObliqueImpact nearly = oblique_impact(wall, 0.1, {0.1, 0.05, 0.0, 1e-6}, options);
  EXPECT_NEAR(nearly.restitution, central.restitution, left_out);
  EXPECT_NEAR(nearly.tangential_restitution, -1.0, 1e-5);
  EXPECT_NEAR(nearly.normal.contact_time, central.contact_time, 0.02);
  EXPECT_NEAR(nearly.normal.max_force, central.max_force, 1e-4);
  EXPECT_NEAR(nearly.normal.max_half_width, central.max_half_width, 1e-4);
}

// s′ = s − μ(1 + ε)(1 + 1/K²)v where all slides, K² = ½; points beside the foremost one have a shorter arm.
TEST_F(ObliqueDisks, SlideThroughAsRigidOnes) {
  constexpr double friction = 0.1, sliding = 0.02;
  double last = 1.0;
  for (const double speed : {1e-2, 1e-3}) {
    const ObliqueImpact impact = oblique_impact(wall, speed, {sliding, 0.0, 0.0, friction}, resolved(wall, 24));
    const double rigid = sliding - friction * (1.0 + impact.restitution) * 3.0 * speed;
    const double away = std::abs(impact.sliding_after - rigid) / (friction * speed);
    EXPECT_LT(away, 0.2 * last);
    last = away;
  }
  EXPECT_LT(last, 3e-3);
}

// While unlike bodies spread under pressure, their points slide at their limit, and a slow sliding along costs little:
// without that, as between equal disks, ε_t is 0.075 here.
TEST_F(ObliqueDisks, MixDirectionsWhereTheyNearlyStick) {
  const Contact coarse = contact(disk(0.33, 11.3));
  const ObliqueImpact impact = oblique_impact(coarse, 0.003, {1.5e-4, 0.0, 0.0, 0.1}, resolved(coarse, 24));
  EXPECT_NEAR(impact.tangential_restitution, 0.496, 2e-3);
  const ObliqueImpact rougher = oblique_impact(coarse, 0.003, {4.5e-4, 0.0, 0.0, 0.3}, resolved(coarse, 24));
  EXPECT_NEAR(rougher.tangential_restitution, 0.199, 2e-3);
}

// The pair alone fixes the outcome, not which of the two is called the first, nor its units.
TEST_F(ObliqueDisks, AreTheSameWhoeverIsFirst) {
  for (const double radius : {0.5, 1.0, 2.0}) {
    const Disk other{0.1, radius, 3.0, 2.0};
    const double unit = std::sqrt(1.5), frequency = unit / radius;  // of its speeds and frequencies
    const double cutoff = 16.0 * std::max(1.0, frequency);
    const Contact here = contact(disk(0.33, cutoff), disk(other, cutoff / frequency));
    const Contact there = contact(disk(other, cutoff / frequency), disk(0.33, cutoff));
    const ObliqueImpact one = oblique_impact(here, 0.1, {0.06, 0.03, 0.01, 0.3}, resolved(here, 24));
    const ObliqueImpact two =
        oblique_impact(there, 0.1 / unit, {0.06 / unit, 0.01 / frequency, 0.03 / frequency, 0.3}, resolved(there, 24));
    EXPECT_NEAR(two.restitution, one.restitution, 1e-10);
    EXPECT_NEAR(two.tangential_restitution, one.tangential_restitution, 1e-9);
    EXPECT_NEAR(two.spin_after * frequency, one.second_spin_after, 1e-10);
    EXPECT_NEAR(two.energy.second_vibration, one.energy.vibration, 1e-10);
    EXPECT_LT(one.angular_momentum_error, 1e-13);
    EXPECT_LT(std::abs(one.energy_error), 4e-4);
  }
}

// Until waves are back a great disk is a half-plane, but for its curvature: both are computed in quite different ways.
TEST_F(ObliqueDisks, MeetAHalfPlaneAsAGreatDisk) {
  constexpr double cutoff = 6.0, poisson = 0.1, young = 2.0;
  const double unit = std::sqrt(young);
  struct Outcome {
    double normal, along;  // impulses
  };
  const auto outcome = [&](const Body& second) {
    const Contact pair = contact(disk(0.33, cutoff), second);
    ImpactOptions options = resolved(pair, 24, 0.25);
    options.resolution.half_width = 0.36;
    const ObliqueImpact impact = oblique_impact(pair, 0.05, {0.003, 0.0, 0.0, 0.1}, options);
    EXPECT_LT(std::abs(impact.energy_error), 1e-4);
    EXPECT_LT(impact.angular_momentum_error, 1e-13);
    return Outcome{(1.0 + impact.restitution) * pair.mass, impact.impulse * pair.mass};
  };
  const Outcome plane = outcome(half_plane(HalfPlane{poisson, young}, cutoff / unit, 14.0 * unit));
  double last_normal = 1.0, last_along = 1.0;
  for (const double radius : {6.0, 12.0, 24.0}) {
    const Outcome great = outcome(disk(Disk{poisson, radius, young}, cutoff / unit * radius));
    const double normal = std::abs(great.normal / plane.normal - 1.0),
                 along = std::abs(great.along / plane.along - 1.0);
    EXPECT_LT(normal, 0.5 * last_normal);
    EXPECT_LT(along, 0.5 * last_along);
    last_normal = normal;
    last_along = along;
  }
  EXPECT_LT(last_normal, 5e-4);
  EXPECT_LT(last_along, 1e-2);
}

// The near side of a greater disk answers as the whole, but for its curvature, 1/size − 1: along the surface that
// matters more than along the normal.
TEST_F(ObliqueDisks, MeetTheNearSideOfAGreatOneAsTheWhole) {
  constexpr double cutoff = 8.0, radius = 12.0;
  const double unit = std::sqrt(2.0) / radius;
  const Body great = disk(Disk{0.1, radius, 2.0}, cutoff / unit);
  const auto outcome = [&](const Body& second) {
    const Contact pair = contact(disk(0.33, cutoff), second);
    ImpactOptions options = resolved(pair, 24, 0.25);
    options.resolution.half_width = 0.36;
    return oblique_impact(pair, 0.05, {0.01, 0.01, 0.002, 0.3}, options);
  };
  const ObliqueImpact whole = outcome(great);
  const auto part = [&](double size) { return outcome(great.near_side(size, cutoff / unit, {})); };
  EXPECT_NEAR(part(1.0).tangential_restitution, whole.tangential_restitution, 1e-12);
  for (const double size : {0.8, 0.4}) {
    const ObliqueImpact near = part(size);
    const double bent = 1.0 / size - 1.0;
    EXPECT_NEAR(near.restitution, whole.restitution, 2e-3 * bent);
    EXPECT_NEAR(near.tangential_restitution, whole.tangential_restitution, 2.5e-2 * bent);
    EXPECT_NEAR(near.second_spin_after, whole.second_spin_after, 1e-5 * bent);
    EXPECT_NEAR(near.energy.second_vibration, whole.energy.second_vibration, 1e-3 * bent);
    EXPECT_NEAR(near.normal.max_force, whole.normal.max_force, 1e-2 * whole.normal.max_force * bent);
    EXPECT_LT(std::abs(near.energy_error), 2e-5);
  }
  EXPECT_THROW((void)part(0.1), NotConverged);  // its echo is back before the end
}

TEST_F(ObliqueDisks, DoNotOutlastAHalfPlane) {
  const Contact pair = contact(disk(0.33, 8.0), half_plane(HalfPlane{0.33}, 8.0, 5.0));
  EXPECT_THROW((void)oblique_impact(pair, 0.05, {0.01, 0.0, 0.0, 0.3}, resolved(pair, 16)), NotConverged);
  test::expect_refusal([&] { (void)oblique_impact(pair, 0.05, {0.01, 0.0, 0.01, 0.3}); }, {"second_spin"});
}

// Of an independent program, which lets plane waves of one direction carry motion of the other, too.
TEST_F(ObliqueDisks, OfTwoKindsAreThoseOfAnotherProgram) {
  const Contact pair = contact(disk(0.33, 16.0), disk(Disk{0.1, 1.0, 3.0, 2.0}, 16.0 / std::sqrt(1.5)));
  const ObliqueImpact impact = oblique_impact(pair, 0.1, {0.1, 0.0, 0.0, 0.3}, resolved(pair, 32));
  EXPECT_NEAR(impact.restitution, 0.963607, 1e-5);
  EXPECT_NEAR(impact.tangential_restitution, 0.495509, 1e-4);
  EXPECT_NEAR(impact.tangential_after, 0.049836, 1e-5);
  EXPECT_NEAR(impact.spin_after, -0.066258, 1e-5);
  EXPECT_NEAR(impact.second_spin_after, -0.033129, 1e-5);
}

// A wide contact rolls less well than it slides: points beside the foremost one move less.
TEST_F(ObliqueDisks, TellSpinFromSliding) {
  const ObliqueImpact spun = oblique_impact(wall, 0.1, {0.0, 0.1, 0.0, 0.3}, resolved(wall, 32));
  EXPECT_NEAR(spun.tangential_restitution, 0.47738, 2e-4);
  EXPECT_NEAR(spun.restitution, 0.946256, 1e-5);
}

TEST_F(ObliqueDisks, LoseToTheirMaterialInBothDirections) {
  const auto outcome = [](double loss_time) {
    Disk lossy{0.33};
    lossy.loss_time = loss_time;
    const Contact wall = contact(disk(lossy, 16.0));
    return oblique_impact(wall, 0.1, {0.1, 0.0, 0.0, 0.3}, resolved(wall, 24));
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

TEST_F(ObliqueDisks, OfOneLossyKindDoNotMixDirections) {
  Disk lossy{0.33};
  lossy.loss_time = 0.05;
  const Contact pair = contact(disk(lossy, 16.0), disk(lossy, 16.0));
  const auto restitution = [&](double friction, double tangential) {
    return oblique_impact(pair, 0.2, {tangential, 0.0, 0.0, friction}, resolved(pair, 24)).restitution;
  };
  EXPECT_NEAR(restitution(1.0, 0.1), restitution(0.2, 0.2), 1e-11);
  EXPECT_NEAR(restitution(1.0, 0.1), impact(pair, 0.2, resolved(pair, 24)).restitution, 1e-5);
}

TEST_F(ObliqueDisks, VibrateBefore) {
  ImpactOptions options = resolved(wall, 24, 0.25);
  options.start = approach(wall, 0.1, {{0, 2, 0, 0.1, 1.0}, {0, 0, 0, 0.05, 0.3}});
  const ObliqueImpact impact = oblique_impact(wall, 0.1, {0.1, 0.0, 0.0, 0.3}, options);
  EXPECT_LT(std::abs(impact.energy_error), 1e-4);
  EXPECT_NEAR(impact.normal.energy.modes.front().before, 0.05 / 2.15, 1e-6);  // of 1 + 1 + 0.15
  const ObliqueImpact smooth = oblique_impact(wall, 0.1, {0.1, 0.0, 0.0, 1e-7}, options);
  EXPECT_NEAR(smooth.restitution, stoss::impact(wall, 0.1, options).restitution, 2e-5);
}

TEST_F(ObliqueDisks, GrowTheirGridAsTheyNeed) {
  ImpactOptions options = resolved(wall, 20);
  options.resolution.half_width = 0.25;
  const ObliqueImpact impact = oblique_impact(wall, 0.1, {0.1, 0.0, 0.0, 0.3}, options);
  EXPECT_GT(impact.normal.resolution.half_width, 0.45);
  EXPECT_NEAR(impact.restitution, 0.9461, 1e-3);
}

// Coulomb's law has no solution for every friction between unlike bodies: nothing is returned then.
TEST_F(ObliqueDisks, RefuseFrictionThatHasNoSolution) {
  const Contact soft = contact(disk(-0.6, 11.3));
  const std::string message = test::message_of<NotConverged>([&] {
    (void)oblique_impact(soft, 0.0265, {0.0886, 0.0, 0.0, 4.29}, resolved(soft, 24));
  });
  EXPECT_NE(message.find("friction"), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST_F(ObliqueDisks, RefuseWhatTheyDoNotKnow) {
  const Obliquity rough{0.1, 0.0, 0.0, 0.3};
  ImpactOptions options;
  options.resolution.tail = Tail::quasistatic;
  test::expect_refusal([&] { (void)oblique_impact(wall, 0.1, rough, options); }, {"tail", "radiating"});
  const Contact soft = contact(disk(0.33, 16.0), ExponentialWall{});
  test::expect_refusal([&] { (void)oblique_impact(soft, 0.1, rough); }, {"exponential"});
  const Contact rods = contact(rod(Rod{}, 16.0));
  test::expect_refusal([&] { (void)oblique_impact(rods, 0.1, rough); }, {"rod"});
}

}  // namespace
}  // namespace oblique_disks
}  // namespace stoss
