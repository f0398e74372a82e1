// The force of an impact in time, with its error.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/plate.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/quasistatic/hertz.hpp"
#include "stoss/restitution/pulse.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

RefinableContact ball_at_wall() { return RefinableContact(sphere(0.3)); }
RefinableContact ball_on_block() { return {sphere(0.3), half_space(HalfSpace{0.3})}; }
RefinableContact two_balls() { return {sphere(0.3), sphere(Sphere{.poisson = 0.2, .radius = 1.5, .young = 0.6})}; }

double within(const Pulse& pulse, double time) {
  const auto at = std::lower_bound(pulse.time.begin(), pulse.time.end(), time) - pulse.time.begin();
  const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at, 1, std::ssize(pulse.time) - 1));
  const double share = (time - pulse.time[i - 1]) / (pulse.time[i] - pulse.time[i - 1]);
  return pulse.force[i - 1] + share * (pulse.force[i] - pulse.force[i - 1]);
}

TEST(Pulse, ItsImpulseIsThatOfTheRestitution) {
  for (const RefinableContact& contact : {ball_at_wall(), ball_on_block(), two_balls(), RefinableContact(disk(0.3))}) {
    const double speed = 0.01;
    const Pulse made = pulse(contact, speed);
    ASSERT_TRUE(made.converged) << made.reason;
    const Contact& at = contact.at(0);
    const double expected = (1.0 + made.restitution.value) * speed * at.mass / whole_mass(*at.first);
    EXPECT_NEAR(made.impulse.value, expected, 2e-5 * expected);
    EXPECT_NEAR(made.amplitude.front(), 1.0, 1e-6);
    EXPECT_EQ(made.frequency.front(), 0.0);
  }
}

TEST(Pulse, FollowsFinerOnesWithinItsErrors) {
  for (const RefinableContact& contact : {ball_at_wall(), ball_on_block(), two_balls()}) {
    const Pulse coarse = pulse(contact, 0.02), fine = pulse(contact, 0.02, {.tolerance = 2e-3, .points = 4000});
    ASSERT_TRUE(coarse.converged);
    int beyond = 0;
    for (std::size_t i = 0; i < coarse.time.size(); ++i) {
      const double apart = std::abs(coarse.force[i] - within(fine, coarse.time[i]));
      if (apart > coarse.force_error[i] + 1e-4 * coarse.peak_force.value) ++beyond;
    }
    EXPECT_LE(beyond, static_cast<int>(coarse.time.size()) / 20);
    const auto agree = [](const Estimate& one, const Estimate& other) {
      EXPECT_LE(std::abs(one.value - other.value), one.error + other.error);
    };
    agree(coarse.peak_force, fine.peak_force);
    agree(coarse.contact_time, fine.contact_time);
    agree(coarse.duration, fine.duration);
    agree(coarse.rise, fine.rise);
    agree(coarse.impulse, fine.impulse);
    agree(coarse.corner_frequency, fine.corner_frequency);
    agree(coarse.first_null, fine.first_null);
    agree(coarse.asymmetry, fine.asymmetry);
  }
}

TEST(Pulse, HasThePeakAndTheTimeOfTheRestitution) {
  const Restitution found = restitution(ball_at_wall(), 0.01);
  const Pulse made = pulse(ball_at_wall(), 0.01);
  EXPECT_LE(std::abs(made.peak_force.value - found.max_force.value), made.peak_force.error + found.max_force.error);
  EXPECT_LE(std::abs(made.contact_time.value - found.contact_time.value),
            made.contact_time.error + found.contact_time.error);
}

TEST(Pulse, OfSlowBallsIsThatOfHertz) {
  double before = 1.0;
  for (const double speed : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const double its = pulse(ball_at_wall(), speed).from_hertz;
    EXPECT_LT(its, 0.6 * before) << speed;  // a whole ball is stiffer than half-spaces by a/R, which falls as v^{2/5}
    before = its;
  }
  EXPECT_LT(before, 0.02);
  EXPECT_LT(pulse(ball_at_wall(), 1e-5).from_sine, 0.03);  // Hunter 1957: it hardly differs from sin^{3/2}
}

TEST(Pulse, OfRodsIsAPlateauWithoutOvershoot) {
  const Pulse made = pulse(RefinableContact(rod(Rod{})), 0.01, {.tolerance = 1e-3});
  EXPECT_NEAR(made.peak_force.value, 0.01, 1e-4);
  EXPECT_NEAR(within(made, 1.0), 0.01, 1e-4);
  EXPECT_LT(*std::max_element(made.force.begin(), made.force.end()), 0.0103);
  EXPECT_NEAR(made.contact_time.value, 2.0, made.contact_time.error + 0.1);
  EXPECT_TRUE(std::isnan(made.from_hertz));
}

TEST(Pulse, RoughAndYieldingFacesAreSofter) {
  const Pulse smooth = pulse(ball_at_wall(), 1e-3);
  const Pulse rough = pulse(RefinableContact(stoss::rough(sphere(0.3), 1e-3)), 1e-3);
  const Pulse yields = pulse(RefinableContact(yielding(sphere(0.3), {.yield = 2e-3})), 1e-3);
  EXPECT_LT(rough.peak_force.value, 0.95 * smooth.peak_force.value);
  EXPECT_LT(yields.peak_force.value, 0.95 * smooth.peak_force.value);
  EXPECT_GT(yields.asymmetry.value, -0.5);
  EXPECT_LT(rough.first_null.value, smooth.first_null.value);
}

TEST(Pulse, Refuses) {
  test::expect_refusal([] { (void)pulse(ball_at_wall(), 2.0); }, {"speed: got 2"});
  test::expect_refusal([] { (void)pulse(ball_at_wall(), 0.1, {.tolerance = 0.0}); }, {"tolerance: got 0"});
  test::expect_refusal([] { (void)pulse(ball_at_wall(), 0.1, {.threshold = 1.0}); }, {"threshold: got 1"});
  test::expect_refusal([] { (void)pulse(ball_at_wall(), 0.1, {.points = 2}); }, {"points: got 2"});
}

}  // namespace
}  // namespace stoss
