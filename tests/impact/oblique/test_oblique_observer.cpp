// What an observer of an oblique impact sees: it is the impact, and obeys Coulomb's law at every point.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "impact/oblique/films.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/impact/oblique.hpp"

namespace stoss {
namespace oblique_observer {
namespace {

using test::FilmCase;
using test::Instant;
using test::options_of;
using test::Seen;
using test::seen;

std::vector<FilmCase> cases() {
  const double same = 12.0 / (0.5 * std::sqrt(1.5)), same_of_great = 8.0 / (std::sqrt(2.0) / 12.0);
  const Contact disk_wall = contact(disk(0.33, 12.0)), ball_wall = contact(sphere(0.3, 15.0));
  const Contact disks = contact(disk(0.33, 12.0), disk(Disk{0.1, 2.0, 3.0, 2.0}, same));
  const Contact balls = contact(sphere(0.3, 12.0), sphere(Sphere{0.2, 2.0, 3.0, 2.0}, same));
  const Body great = disk(Disk{0.1, 12.0, 2.0}, same_of_great);
  const Contact near = contact(disk(0.33, 8.0), great.near_side(0.6, same_of_great, {}));
  return {{"disk slides", disk_wall, 0.1, {0.2, 0.0, 0.0, 0.1}},
          {"disk nearly sticks", disk_wall, 0.05, {0.02, 0.01, 0.0, 1.0}},
          {"disks", disks, 0.1, {0.05, -0.02, 0.01, 0.3}},
          {"part of a disk", near, 0.05, {0.01, 0.01, 0.002, 0.3}},
          {"ball slides", ball_wall, 0.05, {-0.2, 0.0, 0.0, 0.1}},
          {"ball nearly sticks", ball_wall, 0.05, {0.01, 0.01, 0.0, 0.5}},
          {"balls", balls, 0.1, {0.05, -0.02, 0.01, 0.3}},
          {"ball on a half-space",
           contact(sphere(0.3, 6.0), half_space(HalfSpace{0.3}, 6.0, 16.0)),
           0.1,
           {0.05, 0.0, 0.0, 0.3}},
          {"smooth disk", disk_wall, 0.1, {0.05, 0.03, 0.0, 0.0}},
          {"smooth balls", balls, 0.1, {0.05, -0.02, 0.01, 0.0}},
          {"smooth rod", contact(rod(20.0)), 0.1, {0.05, 0.0, 0.0, 0.0}}};
}

void changes_no_bit(const FilmCase& its, const Seen& watched) {
  const ObliqueImpact alone = oblique_impact(its.contact, its.speed, its.before, options_of(its.contact));
  EXPECT_EQ(watched.impact.restitution, alone.restitution);
  EXPECT_EQ(watched.impact.sliding_after, alone.sliding_after);
  EXPECT_EQ(watched.impact.energy_error, alone.energy_error);
  EXPECT_EQ(watched.impact.energy.friction, alone.energy.friction);
  EXPECT_EQ(watched.impact.normal.max_force, alone.normal.max_force);
}

void shows_the_impact_from_before_to_after(const FilmCase& its, const Seen& watched) {
  const ObliqueImpact& impact = watched.impact;
  const double step = impact.normal.resolution.step;
  ASSERT_EQ(static_cast<long>(watched.instants.size()), impact.normal.steps + 1);
  const Instant &first = watched.instants.front(), &last = watched.instants.back();
  EXPECT_EQ(first.time, 0.0);
  EXPECT_EQ(first.velocity, its.speed);
  EXPECT_EQ(first.tangential, its.before.tangential);
  EXPECT_EQ(first.spin, its.before.spin);
  EXPECT_EQ(first.second_spin, its.before.second_spin);
  EXPECT_EQ(first.touching, 0);
  EXPECT_NEAR(last.time, static_cast<double>(impact.normal.steps) * step, 1e-12);
  EXPECT_NEAR(last.velocity, -impact.restitution * its.speed, 1e-13);
  EXPECT_NEAR(last.tangential, impact.tangential_after, 1e-14);
  EXPECT_NEAR(last.spin, impact.spin_after, 1e-14);
  EXPECT_NEAR(last.second_spin, impact.second_spin_after, 1e-14);
  EXPECT_NEAR(last.energy.friction, impact.energy.friction, 1e-13);
  EXPECT_NEAR(last.energy.across, impact.energy.across, 1e-13);
  EXPECT_NEAR(last.energy.rotation, impact.energy.rotation, 1e-13);
  EXPECT_NEAR(last.energy.second_rotation, impact.energy.second_rotation, 1e-13);
  EXPECT_NEAR(last.energy.translation, impact.energy.translation, 1e-13);
}

void shows_energy_that_is_kept(const FilmCase& its, const Seen& watched) {
  for (const Instant& now : watched.instants) {
    const ObliqueEnergies& energy = now.energy;
    const double sum = energy.translation + energy.across + energy.rotation + energy.second_rotation + energy.elastic +
                       energy.friction;
    ASSERT_NEAR(sum, 1.0, 2e-3) << now.time;
  }
  const ObliqueEnergies& energy = watched.instants.back().energy;
  const double sum =
      energy.translation + energy.across + energy.rotation + energy.second_rotation + energy.elastic + energy.friction;
  // Where the normal motion is replayed, what it has lost is what the bodies have.
  const bool replayed = its.contact.first->contour == Contour::ball || its.before.friction == 0.0;
  EXPECT_NEAR(1.0 - sum, watched.impact.energy_error, replayed ? 1e-3 : 1e-12);
}

void shows_forces_that_change_the_velocities(const FilmCase& its, const Seen& watched) {
  const double step = watched.impact.normal.resolution.step, mass = its.contact.whole_mass,
               unit = whole_mass(*its.contact.first);
  for (std::size_t i = 1; i < watched.instants.size(); ++i) {
    const Instant &before = watched.instants[i - 1], &now = watched.instants[i];
    const double force = 0.5 * unit * (before.force + now.force),
                 friction = 0.5 * unit * (before.friction + now.friction);
    ASSERT_NEAR(mass * (now.velocity - before.velocity), -force * step, 1e-13 * mass);
    ASSERT_NEAR(mass * (now.tangential - before.tangential), -friction * step, 1e-13 * mass);
    // Velocities half-way move the bodies.
    const double half = 0.5 * step / mass * unit;
    ASSERT_NEAR(now.center - before.center, step * (before.velocity - half * before.force), 1e-13);
    ASSERT_NEAR(now.shift - before.shift, step * (before.tangential - half * before.friction), 1e-13);
    ASSERT_NEAR(now.angle - before.angle, 0.5 * step * (before.spin + now.spin), 1e-3 * step);
    ASSERT_NEAR(now.second_angle - before.second_angle, 0.5 * step * (before.second_spin + now.second_spin),
                1e-3 * step);
  }
}

void shows_points_that_obey_coulombs_law(const FilmCase& its, const Seen& watched) {
  const double friction = its.before.friction;
  long slipping = 0;
  for (const Instant& now : watched.instants) {
    double force = 0.0, along = 0.0;
    int touching = 0;
    for (const ObliquePoint& point : now.points) {
      force += point.pressure;
      along += point.friction;
      touching += point.pressure > 0.0 ? 1 : 0;
      ASSERT_GE(point.pressure, 0.0);
      ASSERT_LE(std::abs(point.friction), friction * point.pressure * (1.0 + 1e-8)) << now.time;
      ASSERT_EQ(point.grip == Grip::open, point.pressure == 0.0);
      if (point.grip == Grip::forward || point.grip == Grip::backward) {
        ++slipping;
        ASSERT_NEAR(point.friction, static_cast<int>(point.grip) * friction * point.pressure, 1e-8 * point.pressure);
      }
    }
    EXPECT_NEAR(now.force, force, 1e-14);
    EXPECT_NEAR(now.friction, along, 1e-14);
    EXPECT_EQ(now.touching, touching);
  }
  EXPECT_GT(slipping, 0);
}

void shows_the_heat_of_points_that_slip(const FilmCase& its, const Seen& watched) {
  const double step = watched.impact.normal.resolution.step, unit = whole_mass(*its.contact.first);
  const ObliqueEnergies& start = watched.instants.front().energy;
  const double initial = 0.5 * its.contact.whole_mass * its.speed * its.speed / start.translation;
  double heat = 0.0;
  for (std::size_t t = 1; t < watched.instants.size(); ++t) {
    const std::vector<ObliquePoint>&points = watched.instants[t].points, &before = watched.instants[t - 1].points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      heat += 0.5 * unit * (before[i].friction + points[i].friction) * points[i].slip * step;
    }
  }
  EXPECT_NEAR(heat / initial, watched.impact.energy.friction, 1e-12);
}

// Points behind the edge have no further give: what sticks rests, and what slips slips against its friction.
void shows_points_stick_and_slip(const FilmCase& its, const Seen& watched) {
  const double scale = std::abs(its.before.tangential) + std::abs(its.before.spin) + its.speed;
  for (std::size_t t = 1; t < watched.instants.size(); ++t) {
    const std::vector<ObliquePoint>&points = watched.instants[t].points, &before = watched.instants[t - 1].points;
    for (std::size_t i = 2; i + 2 < points.size(); ++i) {
      bool inside = true;
      for (std::size_t j = i - 2; j <= i + 2; ++j)
        inside = inside && points[j].pressure > 0.0 && before[j].pressure > 0.0;
      if (!inside) continue;
      const ObliquePoint& point = points[i];
      if (point.grip == Grip::stick) {
        ASSERT_NEAR(point.slip, 0.0, 1e-9 * scale) << watched.instants[t].time;
      } else {
        ASSERT_GE(static_cast<int>(point.grip) * point.slip, -1e-9 * scale) << watched.instants[t].time;
      }
    }
  }
}

void shows_the_same_bits_at_every_interval(const FilmCase& its, const Seen& watched) {
  const Seen& all = watched;
  const Seen few = seen(its, 7);
  std::size_t k = 0;
  for (std::size_t i = 0; i < all.instants.size(); ++i) {
    if (i % 7 != 0 && i + 1 != all.instants.size()) continue;
    ASSERT_LT(k, few.instants.size());
    const Instant &one = all.instants[i], &other = few.instants[k++];
    ASSERT_EQ(one.time, other.time);
    ASSERT_EQ(one.tangential, other.tangential);
    ASSERT_EQ(one.shift, other.shift);
    ASSERT_EQ(one.angle, other.angle);
    ASSERT_EQ(one.energy.elastic, other.energy.elastic);
    ASSERT_EQ(one.points.size(), other.points.size());
    for (std::size_t j = 0; j < one.points.size(); ++j) {
      ASSERT_EQ(one.points[j].friction, other.points[j].friction);
      ASSERT_EQ(one.points[j].slip, other.points[j].slip);
    }
  }
  EXPECT_EQ(k, few.instants.size());
}

void knows_where_the_points_are(const FilmCase& its, const Seen& watched) {
  const std::vector<ObliquePoint>& points = watched.instants.front().points;
  const auto nodes = static_cast<std::size_t>(watched.impact.normal.resolution.nodes);
  const std::size_t count = has_single_point(its.contact) ? 1 : nodes;
  const bool sided = its.contact.first->contour == Contour::cylinder;
  ASSERT_EQ(points.size(), sided ? 2 * count : count);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) {
      EXPECT_GT(points[i].place, points[i - 1].place);
    }
    if (sided) {
      EXPECT_EQ(points[i].place, -points[points.size() - 1 - i].place);
    }
    EXPECT_GT(points[i].measure, 0.0);
  }
}

class ObliqueObserver : public ::testing::TestWithParam<FilmCase> {};

TEST_P(ObliqueObserver, SeesTheImpact) {
  const Seen watched = seen(GetParam());
  for (const auto& check : {changes_no_bit, shows_the_impact_from_before_to_after, shows_energy_that_is_kept,
                            shows_forces_that_change_the_velocities, shows_points_that_obey_coulombs_law,
                            shows_the_heat_of_points_that_slip, shows_points_stick_and_slip,
                            shows_the_same_bits_at_every_interval, knows_where_the_points_are}) {
    check(GetParam(), watched);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, ObliqueObserver, ::testing::ValuesIn(cases()));

}  // namespace
}  // namespace oblique_observer
}  // namespace stoss
