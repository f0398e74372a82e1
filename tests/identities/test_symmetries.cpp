// What may be exchanged or reversed without a change.
#include <gtest/gtest.h>

#include <cmath>

#include "identities/identity.hpp"
#include "support/body_tools.hpp"

namespace stoss::test {

TEST_P(Identity, TimeReversalGivesBackTheStart) {
  if (loses_energy()) GTEST_SKIP() << "the radiating tail takes energy";
  if (is_lossy(its)) GTEST_SKIP() << "the material takes energy";
  ImpactOptions options{.resolution = {.step = step, .tail = its.tail}};
  use_one_grid(contact, its.speed, options.resolution);
  const Impact forth = impact(contact, its.speed, options);
  options.start = backwards(forth.final_state);
  if (!is_rod(its)) options.resolution.nodes = forth.resolution.nodes;
  const Impact back = impact(contact, -forth.final_state.velocity, options);
  EXPECT_NEAR(back.restitution * forth.restitution, 1.0, 1e-8);
  EXPECT_NEAR(-back.final_state.velocity / its.speed, 1.0, 1e-8);
  EXPECT_LE(back.energy.vibration, 1e-8);
  EXPECT_NEAR(back.max_force / forth.max_force, 1.0, 1e-8);
  EXPECT_NEAR(back.max_compression, forth.max_compression, 1e-8 * std::abs(forth.max_compression));
  if (!its.soft) {  // what counts as contact with a soft wall depends on the speed of the impact
    // It begins where the continuous surface touches, and ends where the last force does, a little in front of that.
    EXPECT_NEAR(back.contact_time, forth.contact_time, 3.0 * step);
    EXPECT_NEAR(back.impulse_time, forth.impulse_time, 1e-8 * forth.impulse_time);
  }
}

TEST_P(IdentityOfPairs, FirstAndSecondMayBeSwapped) {
  const Case other = swapped(its);
  const double length = size(other.first) / size(its.first);
  const double time = length * wave_speed(its.first) / wave_speed(other.first);
  const double force = mass(other.first) / mass(its.first) * length / (time * time);
  const Impact here = run();
  const Impact there = run(other, time);
  EXPECT_NEAR(there.restitution, here.restitution, 1e-12);
  EXPECT_NEAR(there.energy.lost_to_first, here.energy.lost_to_second, 1e-12);
  EXPECT_NEAR(there.energy.lost_to_second, here.energy.lost_to_first, 1e-12);
  EXPECT_NEAR(there.contact_time * time, here.contact_time, 1e-12);
  EXPECT_NEAR(there.max_force * force, here.max_force, 1e-12);
  EXPECT_NEAR(there.max_compression * length, here.max_compression, 1e-12);
}

TEST_P(IdentityOfEqualBodies, AreOneAtAWallAtHalfTheSpeed) {
  Case at_wall = its;
  at_wall.second.reset();
  at_wall.speed = 0.5 * its.speed;
  const Impact pair = run();
  const Impact wall = run(at_wall);
  EXPECT_NEAR(pair.restitution, wall.restitution, 1e-12);
  EXPECT_NEAR(pair.contact_time, wall.contact_time, 1e-12);
  EXPECT_NEAR(pair.max_force, wall.max_force, 1e-12);
  EXPECT_NEAR(pair.max_compression, 2.0 * wall.max_compression, 1e-12);
  EXPECT_NEAR(pair.max_half_width, wall.max_half_width, 1e-12);
  EXPECT_NEAR(pair.energy.lost_to_first, pair.energy.lost_to_second, 1e-12);
  EXPECT_NEAR(pair.energy.vibration, wall.energy.vibration, 1e-12);
  EXPECT_EQ(pair.steps, wall.steps);
}

TEST_P(IdentityOfSoftWalls, StrengthOnlyShiftsTheWall) {
  const double lost = run().lost_fraction;
  for (const double strength : {1e-3, 1e3}) {
    Contact shifted = contact;
    shifted.strength = strength;
    EXPECT_NEAR(impact(shifted, its.speed, {.resolution = {.step = step, .tail = its.tail}}).lost_fraction, lost, 1e-9);
  }
}

}  // namespace stoss::test
