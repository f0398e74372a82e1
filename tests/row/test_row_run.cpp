// One run of a row: its account of momentum and energy, its convergence, its forces, its bits; and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/row/row.hpp"
#include "support/refusal.hpp"
#include "support/rows.hpp"

namespace stoss {
namespace {

using test::equal;
using test::row_of;
using test::Speeds;

void expect_closed(const Row& row, const Speeds& speeds, double energy = 1e-3, double cutoff = 16.0) {
  const RowImpact found = row_impact(row, speeds, cutoff);
  const RowEnergy& its = found.energy;
  EXPECT_NEAR(found.momentum_error, 0.0, 1e-11);
  EXPECT_LT(std::abs(found.energy_error), energy);
  double vibration = 1.0;
  for (const Oscillation& each : row.vibration) vibration += each.energy;
  const double sum = its.translation + its.vibration + its.contact + its.unresolved + its.dissipated + its.yielded;
  EXPECT_NEAR(sum, vibration + found.energy_error, 1e-12);
  EXPECT_GE(its.dissipated, 0.0);
}

TEST(RowRun, KeepAccountOfMomentumAndEnergy) {
  const Speeds first{0.05, 0.0, 0.0};
  Row plain = equal(sphere(0.3), 3);
  expect_closed(plain, first, 1e-4);
  plain.wall_after = true;
  expect_closed(plain, first, 1e-4);
  plain.wall_before = true;
  const RowImpact shut = row_impact(plain, first, 8.0, {}, {.until = 100.0});
  EXPECT_LT(std::abs(shut.energy_error), 5e-3);
  EXPECT_NEAR(shut.momentum_error, 0.0, 1e-11);
  for (const double loss_time : {0.03, 0.3, 3.0}) {
    expect_closed(equal(sphere({0.3, 1.0, 1.0, 1.0, loss_time}), 3), first, 2e-3);
  }
  expect_closed(equal(relaxing(sphere(0.3), {{{0.5, 1.0}, {0.2, 10.0}}}), 3), first);
  expect_closed(equal(rough(sphere(0.3), 1e-3), 3), first);
  expect_closed(equal(yielding(sphere(0.3), {.yield = 0.003}), 3), {1e-3, 0.0, 0.0});
  expect_closed(row_of({sphere(0.3), disk(0.3)}, {0, 0, 0}), first);
  expect_closed(equal(disk({0.33, 1.0, 1.0, 1.0, 0.1}), 3), first, 2e-3);
}

// Between others a lossy body has few modes, and most of what it hands on creeps.
TEST(RowRun, OfLossyBodiesConverge) {
  for (const double loss_time : {0.1, 1.0}) {
    const Row row = equal(sphere({0.3, 1.0, 1.0, 1.0, loss_time}), 3);
    const RowImpact coarse = row_impact(row, {0.1, 0.0, 0.0}, 11.0), fine = row_impact(row, {0.1, 0.0, 0.0}, 32.0);
    for (std::size_t b = 0; b < 3; ++b) {
      EXPECT_NEAR(coarse.velocities_after[b], fine.velocities_after[b], 1e-5) << loss_time;
    }
  }
}

// Nearly incompressible balls take steps much shorter than the modes that are not kept.
TEST(RowRun, OfShortStepsConverge) {
  const Row row = equal(sphere(0.4999), 3);
  const RowImpact coarse = row_impact(row, {0.1, 0.0, 0.0}, 11.0), fine = row_impact(row, {0.1, 0.0, 0.0}, 22.0);
  for (std::size_t b = 0; b < 3; ++b) EXPECT_NEAR(coarse.velocities_after[b], fine.velocities_after[b], 1e-5) << b;
  EXPECT_LT(std::abs(coarse.energy_error), 1e-4);
}

// What follows across a body must not drive its contacts, however short steps are beside the modes that are not kept.
TEST(RowRun, OfNearlyIncompressibleBodiesKeepAccountOfTheEnergy) {
  for (const double poisson : {0.45, 0.48, 0.49, 0.495}) {
    Row drop = equal(sphere(poisson), 2);
    drop.wall_after = true;
    Row rubber = equal(relaxing(sphere(poisson), {{{0.1, 0.3}, {0.05, 10.0}}}), 3);
    for (const double cutoff : {8.0, 11.3, 16.0, 22.6}) {
      expect_closed(drop, {0.1, 0.1}, 5e-4, cutoff);
      expect_closed(rubber, {0.1, 0.0, 0.0}, 5e-4, cutoff);
    }
  }
}

TEST(RowRun, HaveRigidBodiesBetweenOthers) {
  expect_closed(row_of({sphere(0.3), rigid(sphere(0.3))}, {0, 1, 0}), {0.05, 0.0, 0.0});
}

// They begin where no vibration makes them touch: by its reach further away than bodies at rest.
TEST(RowRun, OfVibratingBodiesKeepAccountOfTheEnergy) {
  for (const double phase : {0.0, 1.0, 3.0}) {
    Row row = equal(sphere(0.3), 3);
    row.vibration = {{.body = 0, .order = 2, .index = 0, .energy = 0.1, .phase = phase},
                     {.body = 1, .order = 3, .index = 0, .energy = 0.03, .phase = phase}};
    expect_closed(row, {0.1, 0.0, 0.0}, 1e-4);
  }
}

TEST(RowRun, AreTheSameAgain) {
  Row row = row_of({sphere(0.3), sphere({0.2, 2.0, 1.0, 1.0})}, {0, 1, 0, 0});
  row.wall_after = true;
  const Speeds speeds{0.03, 0.01, 0.0, 0.0};
  const RowResult one = stoss::row(row, speeds), other = stoss::row(row, speeds);
  for (std::size_t b = 0; b < row.bodies.size(); ++b) {
    EXPECT_EQ(one.velocities_after[b].value, other.velocities_after[b].value);
    EXPECT_EQ(one.velocities_after[b].error, other.velocities_after[b].error);
  }
  bool watched = false;
  const RowImpact silent = row_impact(row, speeds, 8.0);
  const RowImpact seen = row_impact(row, speeds, 8.0, {}, {.observer = [&](const RowSnapshot&) { watched = true; }});
  EXPECT_TRUE(watched);
  EXPECT_EQ(silent.velocities_after, seen.velocities_after);
}

// The observer sees the impulses that the bodies get.
TEST(RowRun, ShowTheForcesThatMoveTheBodies) {
  const Row row = equal(sphere(0.3), 3);
  Speeds impulse(2);
  double before = 0.0;
  RowWatch watch;
  watch.observer = [&](const RowSnapshot& now) {
    for (std::size_t k = 0; k < 2; ++k) impulse[k] += now.force[k] * (now.time - before);
    before = now.time;
  };
  const RowImpact found = row_impact(row, {0.05, 0.0, 0.0}, 16.0, {}, watch);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(impulse[k], found.contacts[k].impulse, 1e-9);
  EXPECT_NEAR(found.velocities_after[0], 0.05 - found.contacts[0].impulse, 1e-12);
  EXPECT_NEAR(found.velocities_after[2], found.contacts[1].impulse, 1e-12);
}

// A ball between two walls never comes to an end.
TEST(RowRun, ABallBetweenWallsGoesOn) {
  Row row = equal(sphere(0.3), 1);
  row.wall_before = row.wall_after = true;
  row.gaps = {0.0, 0.5};
  const RowResult found = stoss::row(row, {0.1});
  EXPECT_FALSE(found.converged);
  EXPECT_NE(found.reason.find("may meet again"), std::string::npos) << found.reason;
  const RowImpact once = row_impact(row, {0.1}, 16.0, {}, {.until = 10.0});
  EXPECT_LT(once.velocities_after[0], 0.0);
  EXPECT_EQ(once.contacts[0].touches, 0);
}

TEST(RowRun, BeginAsTheyWereLeft) {
  const Row three = equal(sphere(0.3), 3);
  const Speeds speeds{0.05, 0.0, 0.0};
  const RowImpact plain = row_impact(three, speeds, 8.0);
  const auto begun = [&](const RowState& state) {
    return row_impact(three, speeds, 8.0, {}, {.start = &state}).velocities_after;
  };
  EXPECT_NE(begun(plain.after), plain.velocities_after);
  RowState state = plain.after;
  for (auto* each : {&state.coordinate, &state.momentum}) {
    for (auto& of_body : *each) std::fill(of_body.begin(), of_body.end(), 0.0);
  }
  EXPECT_EQ(begun(state), plain.velocities_after);
  state.coordinate.pop_back();
  test::expect_refusal([&] { (void)begun(state); }, {"start", "2 bodies", "3"});
}

TEST(RowRun, RefuseWhatIsNoRow) {
  const Row three = equal(sphere(0.3), 3);
  const auto refused = [](const Row& row, const Speeds& speeds, const std::vector<std::string>& parts) {
    test::expect_refusal([&] { (void)row_impact(row, speeds, 8.0); }, parts);
    test::expect_refusal([&] { (void)stoss::row(row, speeds); }, parts);
  };
  refused(equal(sphere(0.3), 1), {0.1}, {"bodies", "2 to 100"});
  refused(equal(sphere(0.3), 101), Speeds(101, 0.1), {"bodies", "2 to 100"});
  refused(row_of({sphere(0.3)}, {0, 1}), {0.1, 0.0}, {"bodies", "number of a kind"});
  refused(three, {0.1, 0.0}, {"speed", "2 values", "3"});
  refused(three, {0.1, 0.0, std::nan("")}, {"speed"});
  refused(three, {2.0, 0.0, 0.0}, {"speed"});
  refused(three, {0.0, 0.0, 0.1}, {"speed", "no two bodies that meet"});
  Row gaps = three;
  gaps.gaps = {0.1};
  refused(gaps, {0.1, 0.0, 0.0}, {"gaps", "1 values", "2"});
  gaps.gaps = {0.1, -0.1};
  refused(gaps, {0.1, 0.0, 0.0}, {"gap"});
  refused(row_of({half_space(HalfSpace{.poisson = 0.3}), sphere(0.3)}, {0, 1}), {0.0, -0.1}, {"half-space"});
  const Row block = row_of({sphere(0.3), half_space(HalfSpace{.poisson = 0.3})}, {0, 1, 0});
  test::expect_refusal([&] { (void)row_impact(block, {0.1, 0.0, 0.0}, 1.0); }, {});
  refused(row_of({sphere(0.3), disk(0.3)}, {0, 1}), {0.1, 0.0}, {});
  Row vibrating = three;
  vibrating.vibration = {{.body = 3, .order = 2, .index = 0, .energy = 0.1}};
  refused(vibrating, {0.1, 0.0, 0.0}, {"vibration body", "0 to 2"});
  vibrating.vibration.front().body = 0, vibrating.vibration.front().index = 100;
  test::expect_refusal(
      [&] {
        (void)row_impact(vibrating, {0.1, 0.0, 0.0}, 8.0);
      },
      {"mode (2, 100) of body 0", "up to"});
  test::expect_refusal([&] { (void)row_impact(three, {0.1, 0.0, 0.0}, 8.0, {}, {.until = 1e12}); }, {"until", "steps"});
  test::expect_refusal([&] { (void)stoss::row(three, {0.1, 0.0, 0.0}, {.tolerance = 0.0}); }, {"tolerance"});
}

}  // namespace
}  // namespace stoss
