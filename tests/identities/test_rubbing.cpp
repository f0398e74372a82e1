// Oblique impacts with friction, for every round body and all that it can meet.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <variant>

#include "identities/identity.hpp"
#include "stoss/impact/oblique.hpp"

namespace stoss::test {
namespace {

/// A case of the table, met obliquely: at a sliding speed that makes some of the contact stick.
class ObliqueIdentity : public ::testing::TestWithParam<Case> {
 protected:
  static constexpr double friction = 0.3;
  static constexpr int points = 20;
  const Case& its = GetParam();
  const Contact contact = contact_of(its);
  const double step = 0.5 / contact.cutoff;
  const bool second_turns = its.second && !its.half_space;
  const double second_radius = second_turns ? size(*its.second) / size(its.first) : 0.0;

  [[nodiscard]] Obliquity slides(double over_limit) const {
    return {over_limit * friction * its.speed, 0.0, 0.0, friction};
  }

  /// All that can turn does.
  [[nodiscard]] Obliquity turns() const {
    Obliquity obliquity = slides(1.2);
    obliquity.spin = 0.4 * its.speed;
    if (second_turns) obliquity.second_spin = -0.3 * its.speed / second_radius;
    return obliquity;
  }

  [[nodiscard]] ObliqueImpact run(const Obliquity& obliquity, double share = 1.0) const {
    return run(contact, its.speed, obliquity, share * step);
  }

  [[nodiscard]] static ObliqueImpact run(const Contact& contact, double speed, const Obliquity& obliquity,
                                         double step) {
    return oblique_impact(contact, speed, obliquity, {.resolution = {.step = step, .nodes = points}});
  }

  /// By how much the arm of friction differs from the radius of the smaller body, relative to it.
  [[nodiscard]] double of_arm(const ObliqueImpact& impact) const {
    const double half_width = impact.normal.max_half_width / (second_turns ? std::min(1.0, second_radius) : 1.0);
    return half_width * half_width;
  }
};

class ObliqueIdentityOfPairs : public ObliqueIdentity {};
class ObliqueIdentityOfEqualBodies : public ObliqueIdentity {};

TEST_P(ObliqueIdentity, MomentumSpinAndEnergyClose) {
  const ObliqueImpact impact = run(turns(), 0.5);
  EXPECT_LT(impact.normal.momentum_error, 1e-12);
  EXPECT_LT(impact.momentum_error, 1e-12);
  EXPECT_LT(impact.angular_momentum_error, 1e-12);
  EXPECT_LT(std::abs(impact.energy_error), 1e-3);
  const ObliqueLedger& energy = impact.energy;
  for (const double share : {energy.translation, energy.across, energy.rotation, energy.second_rotation,
                             energy.vibration, energy.second_vibration, energy.dissipated, energy.friction}) {
    EXPECT_GE(share, 0.0);
  }
  EXPECT_GE(energy.unresolved, -1e-6);
  EXPECT_EQ(energy.second_rotation > 0.0, second_turns);
  EXPECT_EQ(energy.second_vibration > 0.0, its.second.has_value());
  EXPECT_EQ(energy.dissipated > 0.0, is_lossy(its));
}

TEST_P(ObliqueIdentity, WithoutFrictionIsTheCentralImpactToTheLastBit) {
  Obliquity smooth = turns();
  smooth.friction = 0.0;
  const ObliqueImpact impact = run(smooth);
  const Impact central = stoss::impact(contact, its.speed, {.resolution = {.step = step, .nodes = points}});
  EXPECT_EQ(impact.restitution, central.restitution);
  EXPECT_EQ(impact.normal.final_state.coordinate, central.final_state.coordinate);
  EXPECT_EQ(impact.tangential_after, smooth.tangential);
  EXPECT_EQ(impact.spin_after, smooth.spin);
  EXPECT_EQ(impact.energy.friction, 0.0);
}

TEST_P(ObliqueIdentity, IsMirroredAndKnowsNoUnits) {
  const Obliquity one = turns(), other{-one.tangential, -one.spin, -one.second_spin, friction};
  const ObliqueImpact here = run(one), mirrored = run(other);
  EXPECT_NEAR(mirrored.restitution, here.restitution, 1e-9);
  EXPECT_NEAR(mirrored.sliding_after, -here.sliding_after, 1e-9 * its.speed);
  EXPECT_NEAR(mirrored.spin_after, -here.spin_after, 1e-9 * its.speed);
  EXPECT_NEAR(mirrored.energy.friction, here.energy.friction, 1e-9);
  const ObliqueImpact there = run(contact_of(in_units(its, 3e-3, 7.3e10, 2400.0)), its.speed, one, step);
  EXPECT_NEAR(there.restitution, here.restitution, 1e-9);
  EXPECT_NEAR(there.sliding_after, here.sliding_after, 1e-9 * its.speed);
  EXPECT_NEAR(there.second_spin_after, here.second_spin_after, 1e-9 * its.speed);
  EXPECT_NEAR(there.energy.friction, here.energy.friction, 1e-9);
}

// What rolls along while it falls meets as what does not: (v_t, Ω₁, Ω₂) count by s alone, but for the shorter arms. No
// sliding gains speed beyond a superball.
TEST_P(ObliqueIdentity, DoesNotFeelThatAllRollsAndGainsNoSpeed) {
  const Obliquity straight = slides(1.0);
  const ObliqueImpact here = run(straight);
  for (const ObliqueImpact& impact : {run(slides(0.1)), here, run(slides(4.0))}) {
    EXPECT_LE(std::abs(impact.sliding_after), std::abs(impact.sliding)) << impact.sliding;
    EXPECT_LT(impact.restitution, 1.0) << impact.sliding;
  }
  const double allowed = 2.0 * of_arm(here) * its.speed;
  for (const double roll : {-0.5 * its.speed, 0.2 * its.speed}) {
    Obliquity rolling = straight;
    rolling.tangential += roll;
    rolling.spin -= roll;
    const ObliqueImpact there = run(rolling);
    EXPECT_NEAR(there.sliding_after, here.sliding_after, allowed) << roll;
    EXPECT_NEAR(there.tangential_after - roll, here.tangential_after, allowed) << roll;
    EXPECT_NEAR(there.spin_after + roll, here.spin_after, allowed) << roll;
    EXPECT_NEAR(there.restitution, here.restitution, 2.0 * of_arm(here)) << roll;
  }
}

TEST_P(ObliqueIdentity, SlidesThroughAsRigidBodiesDo) {
  constexpr double weak = 0.1, fast = 0.9;  // so that no wave moves the surface as fast
  const ObliqueImpact impact = run({fast, 0.0, 0.0, weak});
  const double lost = weak * (1.0 + impact.restitution) * its.speed;
  // At the edge of a fast contact the surface moves as fast as it pleases.
  EXPECT_NEAR(impact.impulse, lost, its.speed > 0.2 ? 1e-3 * lost : 1e-9 * its.speed);
  // 1 + mR²/I of each that turns: 3.5 of solid spheres, 3 of disks.
  const double first = mass(its.first);
  const double reduced = second_turns ? mass(*its.second) / (first + mass(*its.second)) : 1.0;
  const double turned = reduced * (1.0 / inertia_share(its.first) +
                                   (second_turns ? first / mass(*its.second) / inertia_share(*its.second) : 0.0));
  EXPECT_NEAR(impact.sliding_after, impact.sliding - lost * (1.0 + turned), 2.0 * of_arm(impact) * lost * turned);
}

// With momenta and masses from the definitions of the bodies.
TEST_P(ObliqueIdentityOfPairs, AllMomentaHoldInAnyFrame) {
  const Obliquity before = turns();
  const ObliqueImpact after = run(before);
  const double m1 = mass(its.first), m2 = mass(*its.second);
  const double i1 = inertia_share(its.first) * m1;
  const double i2 = inertia_share(*its.second) * m2 * second_radius * second_radius;
  const double impulse = after.impulse * m1 * m2 / (m1 + m2);
  for (const double frame : {0.0, -before.tangential, 3.0}) {
    const std::array velocity{before.tangential + frame, frame};
    const std::array later{velocity[0] - impulse / m1, velocity[1] + impulse / m2};
    EXPECT_NEAR(later[0] - later[1], after.tangential_after, 1e-12);
    // About the point of first touch, where the second body is at +R₂; the arms of friction are a little shorter.
    const auto moment = [&](const std::array<double, 2>& along, double spin, double second_spin) {
      return i1 * spin - m1 * along[0] + i2 * second_spin + m2 * second_radius * along[1];
    };
    const double gained =
        moment(later, after.spin_after, after.second_spin_after) - moment(velocity, before.spin, before.second_spin);
    EXPECT_NEAR(gained, 0.0, 2.0 * of_arm(after) * std::abs(impulse) * (1.0 + second_radius));
  }
}

TEST_P(ObliqueIdentityOfPairs, FirstAndSecondMayBeSwapped) {
  const Case other = swapped(its);
  const double speed = its.speed / other.speed;  // c of the second, in that of the first
  const double time = second_radius / speed;
  const Obliquity here = turns();
  const Obliquity there{here.tangential / speed, here.second_spin * time, here.spin * time, friction};
  const ObliqueImpact one = run(here), two = run(contact_of(other), other.speed, there, step / time);
  EXPECT_NEAR(two.restitution, one.restitution, 1e-8);
  EXPECT_NEAR(two.sliding_after * speed, one.sliding_after, 1e-8 * its.speed);
  EXPECT_NEAR(two.spin_after / time, one.second_spin_after, 1e-8 * its.speed / second_radius);
  EXPECT_NEAR(two.second_spin_after / time, one.spin_after, 1e-8 * its.speed);
  EXPECT_NEAR(two.energy.friction, one.energy.friction, 1e-8);
  EXPECT_NEAR(two.energy.rotation, one.energy.second_rotation, 1e-8);
}

TEST_P(ObliqueIdentityOfEqualBodies, KeepTheNormalImpactWhateverTheFriction) {
  const Impact central = stoss::impact(contact, its.speed, {.resolution = {.step = step, .nodes = points}});
  // Lossy disks are solved in another way when they rub.
  const double tolerance = is_lossy(its) ? 1e-5 : 1e-10;
  for (const double strength : {0.1, 1.0}) {
    Obliquity obliquity = slides(1.0);
    obliquity.friction = strength;
    const ObliqueImpact impact = run(obliquity);
    EXPECT_NEAR(impact.restitution, central.restitution, tolerance) << strength;
    EXPECT_NEAR(impact.normal.contact_time, central.contact_time, tolerance) << strength;
  }
}

TEST_P(ObliqueIdentityOfEqualBodies, AreOneAtAWallAtHalfTheSpeed) {
  Case at_wall = its;
  at_wall.second.reset();
  const Obliquity before{0.3 * its.speed, 0.2 * its.speed, 0.2 * its.speed, friction};
  const ObliqueImpact pair = run(before);
  const ObliqueImpact wall =
      run(contact_of(at_wall), 0.5 * its.speed, {0.5 * before.tangential, before.spin, 0.0, friction}, step);
  EXPECT_NEAR(pair.spin_after, pair.second_spin_after, 1e-10);
  EXPECT_NEAR(pair.energy.vibration, pair.energy.second_vibration, 1e-10);
  if (!is_ball(its.first)) return;  // a wall mixes the directions of a disk
  EXPECT_NEAR(pair.restitution, wall.restitution, 1e-10);
  EXPECT_NEAR(pair.tangential_after, 2.0 * wall.tangential_after, 1e-10);
  EXPECT_NEAR(pair.spin_after, wall.spin_after, 1e-10);
  EXPECT_NEAR(pair.energy.friction, wall.energy.friction, 1e-10);
}

std::string oblique_name(const ::testing::TestParamInfo<Case>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Every, ObliqueIdentity, ::testing::ValuesIn(rubbing(all_cases())), oblique_name);
INSTANTIATE_TEST_SUITE_P(Every, ObliqueIdentityOfPairs, ::testing::ValuesIn(rubbing(pairs())), oblique_name);
INSTANTIATE_TEST_SUITE_P(Every, ObliqueIdentityOfEqualBodies, ::testing::ValuesIn(rubbing(equal_pairs())),
                         oblique_name);

}  // namespace
}  // namespace stoss::test
