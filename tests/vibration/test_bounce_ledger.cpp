// Sequences of impacts: the ledger of energy, and the time of flight.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/ladder.hpp"
#include "stoss/vibration/bounce.hpp"

namespace stoss {
namespace {

constexpr Resolution quasistatic_tail{.tail = Tail::quasistatic};

TEST(BounceLedger, AddsUpAtEveryImpact) {
  struct Case {
    Contact contact;
    BounceOptions options;
  };
  const Vibration excited{{.order = 2, .index = 0, .energy = 0.3, .phase = 1.0}};
  const std::vector<Case> cases{
      {contact(disk(0.33, 12.0)), {.count = 25, .flight_time = 31.4, .resolution = quasistatic_tail}},
      {contact(disk(0.33, 12.0)), {.count = 25, .flight_time = 0.1, .vibration = excited}},
      {contact(sphere(0.3, 12.0)), {.count = 25, .gravity = 0.01, .decay_time = 40.0, .vibration = excited}},
      {contact(sphere(Sphere{.poisson = 0.3, .loss_time = 0.05}, 12.0)), {.count = 10, .flight_time = 2.0}},
      {contact(disk(0.33, 12.0), ExponentialWall{100.0, 1.0}), {.count = 10, .flight_time = 20.0}},
      {contact(sphere(Sphere{.poisson = 0.3}), half_space(HalfSpace{.poisson = 0.3}), 8.0, 0.02),
       {.count = 8, .flight_time = 25.0}}};
  for (const Case& each : cases) {
    const Contact& contact = each.contact;
    const BounceOptions& options = each.options;
    SequenceEnergy last;
    double error = 0.0, first_translation = 0.0, first_speed = 0.1;
    const double decay = options.decay_time ? *options.decay_time : std::numeric_limits<double>::infinity();
    double flight = 0.0;
    bounce(contact, first_speed, options, [&](const Bounce& now, const Impact& impact) {
      const std::string where = name(contact) + ", impact " + std::to_string(now.number);
      const auto& [translation, vibration, dissipated, unresolved] = now.before;
      if (now.number == 1) {
        EXPECT_NEAR(translation + vibration, 1.0, 1e-12) << where;
        EXPECT_EQ(dissipated + unresolved, 0.0) << where;
        first_translation = translation;
      } else {
        EXPECT_NEAR(translation, last.translation, 1e-10) << where;
        EXPECT_NEAR(vibration + dissipated, last.vibration + last.dissipated, 1e-10) << where;
        EXPECT_EQ(unresolved, last.unresolved) << where;
        if (longest_loss_time(contact) == 0.0) {
          EXPECT_NEAR(vibration, last.vibration * std::exp(-flight / decay), 1e-10) << where;
        }
      }
      const double ratio = now.speed / first_speed;
      EXPECT_NEAR(translation, first_translation * ratio * ratio, 1e-10) << where;
      const double stored = longest_loss_time(contact) > 0.0 ? 0.0 : impact.energy.stored;
      error += (impact.energy_error + stored) * (translation + vibration);
      EXPECT_NEAR(now.energy_error, error, 1e-10) << where;
      EXPECT_GE(now.after.unresolved, unresolved) << where;
      EXPECT_GE(now.after.dissipated, dissipated) << where;
      last = now.after;
      flight = now.flight_time;
    });
    EXPECT_NE(last.translation, first_translation);
  }
}

TEST(BounceFlight, UnderGravityIsBallistic) {
  const Contact at_wall = contact(sphere(0.3, 12.0));
  const std::vector<Bounce> falling = bounce(at_wall, 0.1, {.count = 3, .gravity = 0.004});
  for (const Bounce& each : falling) {
    EXPECT_DOUBLE_EQ(each.flight_time, 2.0 * each.restitution * each.speed / 0.004);
  }
  const std::vector<Bounce> timed = bounce(at_wall, 0.1, {.count = 2, .flight_time = falling[0].flight_time});
  EXPECT_EQ(timed[1].restitution, falling[1].restitution);
  EXPECT_NE(falling[1].flight_time, falling[0].flight_time);
}

TEST(BounceFlight, TooShortForTheVibrationIsSaid) {
  const Contact at_wall = contact(disk(0.33, 12.0));
  const auto second = [&](double flight) {
    return bounce(at_wall, 0.2, {.count = 2, .flight_time = flight, .resolution = quasistatic_tail})[1];
  };
  EXPECT_TRUE(second(1e-3).short_flight);
  EXPECT_FALSE(second(50.0).short_flight);
}

TEST(BounceFlight, OfALossyBodyKeepsItsEnergyWhenItIsTooShort) {
  const Contact at_wall = contact(sphere(Sphere{.poisson = 0.3, .loss_time = 0.01}, 12.0));
  const std::vector<Bounce> two = bounce(at_wall, 0.2, {.count = 2, .flight_time = 1e-6});
  EXPECT_TRUE(two[1].short_flight);
  EXPECT_NEAR(two[1].before.vibration, two[0].after.vibration, 1e-14);
}

}  // namespace
}  // namespace stoss
