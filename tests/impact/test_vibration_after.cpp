// How bodies vibrate when they meet again: the state after the impact, flown on and turned round.
#include <gtest/gtest.h>

#include <cstddef>
#include <limits>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/vibration.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

constexpr double flight = 7.5;

/// The state at the next nominal touch, by free flight from the end of an impact.
State at_next_touch(const Contact& contact, const Impact& impact) {
  const State& end = impact.final_state;
  return free_motion(contact, end, flight - (end.center + contact.extent) / end.velocity);
}

TEST(VibrationAfter, IsThatOfTheStateAfterTheFlight) {
  for (const Contact& contact : {contact(disk(0.33, 12.0)), contact(sphere(0.3, 9.0)), contact(rod(40.0)),
                                 contact(rod(), rod(Rod{.length = 2.5, .young = 2.0}), 20.0)}) {
    const Impact first = impact(contact, 0.1);
    const Vibration next = vibration_after(contact, first.final_state, flight);
    ASSERT_FALSE(next.empty());
    // `approach` begins out of reach, before the touch.
    const State start = approach(contact, 0.1 * first.restitution, next);
    const double before = -(start.center + contact.extent) / start.velocity;
    const State same = free_motion(contact, at_next_touch(contact, first), -before);
    for (std::size_t k = 0; k < start.momentum.size(); ++k) {
      EXPECT_NEAR(start.coordinate[k], same.coordinate[k], 1e-11);
      EXPECT_NEAR(start.momentum[k], same.momentum[k], 1e-11);
    }
  }
}

TEST(VibrationAfter, HasTheEnergiesThatALossyBodyHasLeft) {
  const Contact lossy = contact(disk(Disk{.poisson = 0.33, .loss_time = 0.01}, 9.0));
  const Impact first = impact(lossy, 0.1);
  const State touch = at_next_touch(lossy, first);
  double energy = 0.0, left = 0.0;
  for (const Oscillation& mode : vibration_after(lossy, first.final_state, flight)) energy += mode.energy;
  for (const double each : mode_energies(lossy, touch)) left += each;
  EXPECT_NEAR(energy, left / (0.5 * lossy.mass * touch.velocity * touch.velocity), 1e-12 * energy);
  EXPECT_LT(energy, 0.95 * first.energy.vibration / first.energy.translation);
}

TEST(VibrationAfter, LeavesOutWavesThatRanAway) {
  const Contact ground = contact(sphere(0.3), half_space(HalfSpace{.poisson = 0.3}), 6.0, 0.1);
  const Vibration next = vibration_after(ground, impact(ground, 0.1).final_state, flight);
  ASSERT_FALSE(next.empty());
  for (const Oscillation& mode : next) EXPECT_EQ(mode.body, 0);
}

TEST(VibrationAfter, RefusesFlightsThatAreNoTimes) {
  const Contact wall = contact(disk(0.33, 9.0));
  const State end = impact(wall, 0.1).final_state;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN(), infinity}) {
    test::expect_refusal([&] { (void)vibration_after(wall, end, bad); }, {"flight: got"});
  }
  test::expect_refusal([&] { (void)vibration_after(wall, {}, 1.0); }, {"state: got 0 coordinates"});
}

TEST(ValidVibration, IsOneOfModesThatAreKeptAtSomeCutoff) {
  const RefinableContact ball(sphere(0.3));
  const auto refused = [&](double speed, const Vibration& vibration, const char* part) {
    test::expect_refusal([&] { validate(ball, speed, vibration); }, {part});
  };
  EXPECT_NO_THROW(validate(ball, 0.01, Vibration{{0, 2, 0, 0.1, 1.0}}));
  refused(0.01, {{0, 2, 900, 0.1, 1.0}}, "mode");
  refused(0.01, {{0, 2, 0, -0.1, 1.0}}, "energy: got -0.1");
  refused(2.0, {{0, 2, 0, 0.1, 1.0}}, "speed: got 2");
}

}  // namespace
}  // namespace stoss
