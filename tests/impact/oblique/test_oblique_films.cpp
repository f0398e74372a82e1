// What films of oblique impacts show: stick, slip, reversal, vibration, and the motion along the normal.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "impact/oblique/films.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/impact/oblique.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace oblique_films {
namespace {

using test::Instant;
using test::into;
using test::options_of;
using test::Seen;
using test::seen;

class ObliqueFilms : public ::testing::Test {
 protected:
  const Contact ball = contact(sphere(0.3, 15.0)), plate = contact(disk(0.33, 12.0));
};

TEST_F(ObliqueFilms, OfGrossSlidingHaveAllPointsSlipOneWay) {
  for (const Contact* each : {&ball, &plate}) {
    const Seen watched = seen({"", *each, 0.05, {-0.5, 0.0, 0.0, 0.05}});
    for (const Instant& now : watched.instants) {
      for (const ObliquePoint& point : now.points) {
        ASSERT_EQ(point.grip, point.pressure > 0.0 ? Grip::backward : Grip::open) << now.time;
      }
      ASSERT_NEAR(now.friction, -0.05 * now.force, 1e-12);
    }
  }
}

// Cattaneo and Mindlin: what sticks is in the middle, and an annulus around it slips.
TEST_F(ObliqueFilms, OfOneThatNearlySticksHaveAZoneThatSticksInOneThatSlips) {
  const Seen watched = seen({"", ball, 0.02, {0.01, 0.0, 0.0, 0.3}});
  long with_both = 0;
  for (const Instant& now : watched.instants) {
    std::size_t stuck = 0, touching = 0;
    for (const ObliquePoint& point : now.points) {
      stuck += point.grip == Grip::stick ? 1 : 0;
      touching += point.grip != Grip::open ? 1 : 0;
    }
    if (stuck > 0 && stuck < touching && now.time > 0.5 * watched.impact.normal.contact_time) ++with_both;
    if (now.time > 0.9 * watched.instants.back().time || touching < 4 || stuck == 0) continue;
    // Alone the rings at the edge are in doubt.
    for (std::size_t i = 0; i + 2 < stuck; ++i) EXPECT_EQ(now.points[i].grip, Grip::stick) << now.time << " " << i;
  }
  EXPECT_GT(with_both, 20);
}

// Where friction reverses, it does so from the edge inwards; at the end the ball slips backwards.
TEST_F(ObliqueFilms, ShowFrictionThatReverses) {
  const Seen watched = seen({"", ball, 0.02, {0.01, 0.0, 0.0, 0.3}});
  double most = 0.0, least = 0.0;
  for (const Instant& now : watched.instants) {
    most = std::max(most, now.friction);
    least = std::min(least, now.friction);
  }
  EXPECT_GT(most, 0.0);
  EXPECT_LT(least, -0.1 * most);
}

// Pressure draws the surface of a disk inward, as Flamant's load does that of a half-plane, by 1 − ν: its points slide
// in over a wall, and out again while they are relieved.
TEST_F(ObliqueFilms, OfADiskShowThatItsSurfaceIsDrawnInward) {
  const Seen watched = seen({"", contact(disk(-0.5, 12.0)), 0.05, {0.0, 0.0, 0.0, 0.1}});
  const double time = watched.impact.normal.contact_time;
  const auto goes = [&](double at, double inward) {
    const auto now = std::find_if(watched.instants.begin(), watched.instants.end(),
                                  [&](const Instant& each) { return each.time > at * time; });
    int points = 0;
    for (const ObliquePoint& point : now->points) {
      if (point.grip == Grip::open || std::abs(point.place) < 0.08) continue;
      EXPECT_EQ(static_cast<int>(point.grip), point.place > 0.0 ? -inward : inward) << at << " " << point.place;
      ++points;
    }
    EXPECT_GT(points, 6);
  };
  goes(0.2, 1.0);
  goes(0.35, 1.0);
  goes(0.8, -1.0);
}

// One normal impact serves the films of all angles and frictions.
TEST_F(ObliqueFilms, OfSlidesAreThoseOfTheImpact) {
  const SharedNormalImpact shared(ball, 0.05, options_of(ball));
  for (const Obliquity& before : {Obliquity{0.01, 0.0, 0.0, 0.5}, {0.1, 0.02, 0.0, 0.1}, {0.1, 0.0, 0.0, 0.0}}) {
    std::vector<Instant> instants;
    const ObliqueImpact after = shared.with(before, {}, into(instants));
    const Seen whole = seen({"", ball, 0.05, before});
    EXPECT_EQ(after.sliding_after, whole.impact.sliding_after);
    ASSERT_EQ(instants.size(), whole.instants.size());
    for (std::size_t i = 0; i < instants.size(); ++i) {
      ASSERT_EQ(instants[i].shift, whole.instants[i].shift);
      ASSERT_EQ(instants[i].friction, whole.instants[i].friction);
    }
  }
}

// The centre of mass of both stays where it is, and bodies at rest that touch have their radii between them.
TEST_F(ObliqueFilms, PlaceBothBodies) {
  const Contact pair = contact(sphere(0.3, 12.0), sphere(Sphere{0.3, 2.0, 1.0, 1.0}, 24.0));
  for (const Instant& now : seen({"", pair, 0.05, {0.1, 0.0, 0.0, 0.2}}).instants) {
    const PlanePoint first = center(pair, now, 0), second = center(pair, now, 1);
    ASSERT_NEAR(second.x - first.x, -now.center, 1e-14);
    ASSERT_NEAR(first.y - second.y, now.shift, 1e-14);
    ASSERT_NEAR(first.y + 8.0 * second.y, 0.0, 1e-14);
    ASSERT_NEAR(first.x + 1.0 + 8.0 * (second.x - 2.0), 0.0, 1e-13);
  }
  const Instant last = seen({"", ball, 0.05, {0.1, 0.0, 0.0, 0.2}}).instants.back();
  EXPECT_EQ(center(ball, last, 0).x, last.center);
  EXPECT_EQ(center(ball, last, 0).y, last.shift);
  test::expect_refusal([&] { (void)center(ball, last, 1); }, {"body"});
}

TEST_F(ObliqueFilms, SeeVibrationBefore) {
  const Contact one = contact(disk(0.33, 12.0));
  State state{-one.extent - 0.3, 0.05, std::vector<double>(mode_count(one)), std::vector<double>(mode_count(one))};
  state.momentum[3] = 0.05;
  for (const double friction : {0.0, 0.3}) {
    ImpactOptions options = options_of(one);
    options.start = state;
    std::vector<Instant> instants;
    const ObliqueImpact after = oblique_impact(one, 0.05, {0.02, 0.0, 0.0, friction}, options, into(instants));
    EXPECT_GT(instants.front().energy.elastic, 0.01);
    EXPECT_NEAR(instants.front().center, state.center, 1e-14);
    EXPECT_NEAR(instants.back().velocity, -after.restitution * 0.05, 1e-13);
  }
}

TEST_F(ObliqueFilms, EndWithWhatTheObserverThrows) {
  for (const Contact* each : {&ball, &plate}) {
    int calls = 0;
    const ObliqueImpactObserver observer = [&](const ObliqueSnapshot&) {
      if (++calls == 10) throw std::domain_error("enough");
    };
    EXPECT_THROW((void)oblique_impact(*each, 0.05, {0.02, 0.0, 0.0, 0.3}, options_of(*each), {observer}),
                 std::domain_error);
    EXPECT_EQ(calls, 10);
  }
}

TEST_F(ObliqueFilms, RefuseAnIntervalOutOfRange) {
  for (const Contact* each : {&ball, &plate}) {
    for (const double friction : {0.0, 0.3}) {
      test::expect_refusal(
          [&] {
            (void)oblique_impact(*each, 0.05, {0.0, 0.0, 0.0, friction}, options_of(*each),
                                 {[](const ObliqueSnapshot&) {}, 0});
          },
          {"every"});
    }
  }
}

}  // namespace
}  // namespace oblique_films
}  // namespace stoss
