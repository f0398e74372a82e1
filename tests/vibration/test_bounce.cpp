// Sequences of impacts: complete damping, memory of the phases, how they end, and what is refused.
#include "stoss/vibration/bounce.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/ladder.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

constexpr Resolution all_energy_kept{.tail = Tail::quasistatic};

Contact on_half_space() {
  return contact(sphere(Sphere{.poisson = 0.3}), half_space(HalfSpace{.poisson = 0.3}), 8.0, 0.02);
}

TEST(BounceWithoutMemory, IsTheImpactFromRestToTheBit) {
  const ExponentialWall soft{100.0, 1.0};
  struct Case {
    Contact contact;
    Tail tail;
  };
  const std::vector<Case> cases{{contact(sphere(0.3, 12.0)), Tail::radiating},
                                {contact(disk(0.33, 12.0)), Tail::quasistatic},
                                {contact(disk(0.33, 12.0), soft), Tail::radiating},
                                {contact(rod(40.0)), Tail::radiating},
                                {on_half_space(), Tail::radiating}};
  for (const Case& each : cases) {
    const Contact& contact = each.contact;
    const Tail tail = each.tail;
    const BounceOptions options{.count = 4, .flight_time = 7.3, .decay_time = 0.0, .resolution = {.tail = tail}};
    double speed = 0.1;
    bounce(contact, speed, options, [&](const Bounce& bounce, const Impact& now) {
      const Impact rest = impact(contact, bounce.speed, {.resolution = {.tail = tail}});
      EXPECT_EQ(bounce.speed, speed) << name(contact);
      EXPECT_EQ(bounce.restitution, rest.restitution) << name(contact);
      EXPECT_EQ(bounce.contact_time, rest.contact_time) << name(contact);
      EXPECT_EQ(now.final_state.momentum, rest.final_state.momentum) << name(contact);
      EXPECT_EQ(bounce.before.vibration, 0.0);
      speed *= bounce.restitution;
    });
    EXPECT_LT(speed, 0.1 * (1.0 + 1e-12)) << name(contact);
  }
}

TEST(BounceWithoutMemory, IsTheLimitOfShortDecayTimes) {
  const Contact at_wall = contact(sphere(0.3, 12.0));
  const auto last = [&](double decay_time) {
    return bounce(at_wall, 0.1, {.count = 3, .flight_time = 30.0, .decay_time = decay_time}).back().restitution;
  };
  EXPECT_EQ(last(0.01), last(0.0));  // e^(−1500) is nothing
  EXPECT_NE(last(10.0), last(0.0));
}

TEST(BounceWithoutMemory, ComesOfLossyMaterialInLongFlights) {
  const Contact at_wall = contact(sphere(Sphere{.poisson = 0.3, .loss_time = 0.01}, 12.0));
  const auto greatest_difference = [&](double flight) {
    double greatest = 0.0;
    for (const Bounce& each : bounce(at_wall, 0.1, {.count = 4, .flight_time = flight})) {
      const double rest = impact(at_wall, each.speed).restitution;
      greatest = std::max(greatest, std::abs(each.restitution - rest));
    }
    return greatest;
  };
  EXPECT_GT(greatest_difference(3.0), 1e-3);
  EXPECT_LT(greatest_difference(5000.0), 2e-5);  // another phase of the touch within a step
}

TEST(BounceMemory, IsTheVibrationAfterTheImpactFurtherInPhase) {
  for (const double flight : {1.0, 13.7, 1e4}) {
    const Contact at_wall = contact(disk(0.33, 12.0));
    std::vector<double> found;
    std::vector<Impact> impacts;
    bounce(at_wall, 0.2, {.count = 2, .flight_time = flight, .resolution = all_energy_kept},
           [&](const Bounce& bounce, const Impact& impact) {
             found.push_back(bounce.restitution);
             impacts.push_back(impact);
           });
    const Impact& first = impacts.front();
    Vibration vibrating = vibration(at_wall, first.final_state);
    for (std::size_t k = 0; k < vibrating.size(); ++k) vibrating[k].phase += first.energy.modes[k].omega * flight;
    const double speed = -first.final_state.velocity;
    const Impact second =
        impact(at_wall, speed, {.resolution = all_energy_kept, .start = approach(at_wall, speed, vibrating)});
    EXPECT_NEAR(found[1], second.restitution, 1e-10) << flight;
    EXPECT_GT(std::abs(found[1] - impact(at_wall, speed, {.resolution = all_energy_kept}).restitution), 1e-3) << flight;
  }
}

TEST(BounceMemory, OfARodRepeatsAfterItsPeriod) {
  // All frequencies are multiples of π: a flight longer by 2 L/c changes nothing.
  const Contact at_wall = contact(rod(60.0));
  const Vibration vibrating{{.order = 0, .index = 0, .energy = 0.02, .phase = 0.4}};
  const auto sequence = [&](double flight) {
    return bounce(at_wall, 0.1, {.count = 5, .flight_time = flight, .vibration = vibrating});
  };
  const auto shorter = sequence(3.7), longer = sequence(5.7), longest = sequence(103.7), other = sequence(4.3);
  for (std::size_t i = 0; i < shorter.size(); ++i) {
    EXPECT_NEAR(longer[i].restitution, shorter[i].restitution, 1e-9);
    EXPECT_NEAR(longest[i].restitution, shorter[i].restitution, 1e-9);
  }
  EXPECT_GT(std::abs(other.back().restitution - shorter.back().restitution), 1e-6);
}

TEST(BounceMemory, OfARodAtRestInsideIsThatOfAnIdealBall) {
  // The wave that runs to the free end and back takes all energy back into translation: ε = 1 again and again.
  double before = 1.0;
  for (const double cutoff : {100.0, 200.0, 400.0}) {
    double greatest = 0.0;
    for (const Bounce& each : bounce(contact(rod(cutoff)), 0.1, {.count = 6, .flight_time = 3.3})) {
      greatest = std::max(greatest, std::abs(each.restitution - 1.0));
    }
    EXPECT_LT(greatest, 0.7 * before) << cutoff;
    before = greatest;
  }
  EXPECT_LT(before, 0.01);
}

TEST(BounceScale, IsOneOfTheBodyItself) {
  const auto last = [](double radius) {
    return bounce(contact(sphere(Sphere{.poisson = 0.3, .radius = radius}, 12.0)), 0.1,
                  {.count = 4, .flight_time = 11.0})
        .back();
  };
  EXPECT_EQ(last(1.0).restitution, last(8.0).restitution);
}

TEST(Bounce, EndsWhereItsSpeedIsNoneOfAnImpact) {
  const Contact at_wall = contact(disk(0.33, 8.0));
  try {
    (void)bounce(at_wall, 1e-8, {.count = 3, .flight_time = 9.0});
    FAIL() << "slower than 1e-8";
  } catch (const BounceNotConverged& error) {
    EXPECT_EQ(error.done.size(), 1U);
    EXPECT_NE(std::string(error.what()).find("1e-8 to 1"), std::string::npos) << error.what();
  }
}

TEST(Bounce, KeepsWhatIsDoneWhenItIsStopped) {
  struct Stopped {};
  long seen = 0;
  const Poll poll = [&] {
    if (seen == 3) throw Stopped{};
  };
  const BounceOptions options{.count = 100, .flight_time = 9.0, .poll = poll};
  EXPECT_THROW(bounce(contact(sphere(0.3, 12.0)), 0.1, options, [&](const Bounce&, const Impact&) { ++seen; }),
               Stopped);
  EXPECT_EQ(seen, 3);
}

TEST(BounceInput, IsRefusedOutOfRange) {
  const Contact at_wall = contact(sphere(0.3, 12.0));
  const auto refused = [&](double speed, const BounceOptions& options, const std::vector<std::string>& parts) {
    test::expect_refusal([&] { (void)bounce(at_wall, speed, options); }, parts);
  };
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, 2.0, nan}) refused(bad, {.flight_time = 1.0}, {"speed", "got"});
  for (const long bad : {0L, -1L, 2'000'000'000L}) refused(0.1, {.count = bad, .flight_time = 1.0}, {"count", "got"});
  for (const double bad : {0.0, -1.0, 1e13, nan, infinity}) refused(0.1, {.flight_time = bad}, {"flight_time", "got"});
  for (const double bad : {0.0, -1.0, 1e4, nan, infinity}) refused(0.1, {.gravity = bad}, {"gravity", "got"});
  for (const double bad : {-1.0, 1e16, nan, infinity}) {
    refused(0.1, {.flight_time = 1.0, .decay_time = bad}, {"decay_time", "got"});
  }
  refused(0.1, {}, {"flight_time", "neither"});
  refused(0.1, {.flight_time = 1.0, .gravity = 1.0}, {"flight_time", "gravity", "exactly one"});
  const BounceOptions above{.flight_time = 1.0, .vibration = {{.order = 2, .index = 40, .energy = 0.1}}};
  refused(0.1, above, {"vibration", "cutoff"});
  test::expect_refusal([&] { validate(at_wall, 0.1, above); }, {"vibration", "cutoff"});
  test::expect_refusal([&] { (void)bounce(contact(sphere(0.3, 12.0), sphere(0.3, 12.0)), 0.1, {.flight_time = 1.0}); },
                       {"against", "free bod"});
}

}  // namespace
}  // namespace stoss
