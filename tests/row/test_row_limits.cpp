// Rows of bodies in limits that are known: Hertz's row of point balls, pairs, rods, reflected rows, finite elements.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution.hpp"
#include "stoss/row/row.hpp"
#include "support/refusal.hpp"
#include "support/runge_kutta.hpp"

namespace stoss {
namespace {

using Speeds = std::vector<double>;

Row row_of(std::vector<BodyMaker> kinds, std::vector<std::size_t> bodies) {
  Row row;
  row.kinds = std::move(kinds);
  row.bodies = std::move(bodies);
  return row;
}

Row equal(const BodyMaker& maker, std::size_t count) { return row_of({maker}, std::vector<std::size_t>(count)); }

/// Velocities after of equal point balls that push each other by F = δ^{3/2}, of which the first moves.
template <std::size_t count>
std::array<double, count> hertz_row() {
  std::array<double, 2 * count> state{};  // places, velocities
  state[count] = 1.0;
  const auto slope = [](const std::array<double, 2 * count>& at) {
    std::array<double, 2 * count> rate{};
    for (std::size_t b = 0; b < count; ++b) rate[b] = at[count + b];
    for (std::size_t b = 0; b + 1 < count; ++b) {
      const double force = std::pow(std::max(0.0, at[b] - at[b + 1]), 1.5);
      rate[count + b] -= force, rate[count + b + 1] += force;
    }
    return rate;
  };
  constexpr double step = 1e-3, end = 40.0;
  for (double time = 0.0; time < end; time += step) state = test::runge_kutta_step(state, step, slope);
  std::array<double, count> after{};
  for (std::size_t b = 0; b < count; ++b) after[b] = state[count + b];
  return after;
}

template <std::size_t count>
void expect_hertz() {
  constexpr double speed = 1e-7;
  Speeds speeds(count);
  speeds.front() = speed;
  const RowResult found = row(equal(sphere(0.3), count), speeds);
  EXPECT_TRUE(found.converged) << found.reason;
  const auto point = hertz_row<count>();
  for (std::size_t b = 0; b < count; ++b) {
    EXPECT_NEAR(found.velocities_after[b].value / speed, point[b], 0.01 * std::abs(point[b])) << b;
  }
}

TEST(RowLimits, ThreeSlowSpheresAreHertzsRow) { expect_hertz<3>(); }
TEST(RowLimits, FiveSlowSpheresAreHertzsRow) { expect_hertz<5>(); }

/// A row of two is the pair, within both errors.
void expect_pair(const BodyMaker& first, const BodyMaker& second, double speed) {
  const RowResult found = row(row_of({first, second}, {0, 1}), {speed, 0.0});
  EXPECT_TRUE(found.converged) << found.reason;
  const Restitution pair = restitution(RefinableContact(first, second), speed);
  const BodyScale one = first(1.0, {}).scale, other = second(1.0, {}).scale;
  const double share = other.mass / (one.mass + other.mass);
  const double first_after = speed * (1.0 - (1.0 + pair.restitution.value) * share);
  const double second_after = speed * (1.0 + pair.restitution.value) * (1.0 - share);
  const double error = speed * pair.restitution.error;
  EXPECT_NEAR(found.velocities_after[0].value, first_after, found.velocities_after[0].error + error);
  EXPECT_NEAR(found.velocities_after[1].value, second_after, found.velocities_after[1].error + error);
}

TEST(RowLimits, TwoEqualSpheresAreAPair) {
  for (const double poisson : {0.0, 0.3, 0.49}) {
    for (const double speed : {1e-4, 0.01, 0.1}) expect_pair(sphere(poisson), sphere(poisson), speed);
  }
}

TEST(RowLimits, UnequalSpheresAreAPair) {
  expect_pair(sphere(0.3), sphere({0.2, 3.0, 1.0, 1.0}), 0.03);
  expect_pair(sphere({0.3, 2.0, 1.0, 1.0}), sphere({0.2, 1.0, 0.3, 2.0}), 0.03);
  expect_pair(sphere(0.3), sphere({0.3, 10.0, 1.0, 1.0}), 1e-3);
}

TEST(RowLimits, TwoDisksAreAPair) {
  for (const double speed : {1e-3, 0.1}) expect_pair(disk(0.33), disk(0.33), speed);
  expect_pair(disk(0.33), disk({0.2, 2.0, 1.0, 1.0}), 0.05);
}

TEST(RowLimits, LossyRoughAndYieldingSpheresArePairs) {
  expect_pair(sphere({0.3, 1.0, 1.0, 1.0, 0.1}), sphere(0.3), 0.1);
  expect_pair(relaxing(sphere(0.3), {{{0.3, 1.0}, {0.2, 10.0}}}), sphere({0.3, 2.0, 1.0, 1.0}), 0.1);
  expect_pair(rough(sphere(0.3), 1e-3), sphere(0.3), 0.01);
  expect_pair(yielding(sphere(0.3), {.yield = 0.003}), yielding(sphere(0.3), {.yield = 0.003}), 1e-3);
}

// Waves of equal rods pass on what the first has: each stops dead but the last.
TEST(RowLimits, OfEqualRodsTheLastFlies) {
  const double speed = 0.1;
  const RowResult found = row(equal(rod(), 3), {speed, 0.0, 0.0}, {.tolerance = 0.03});
  for (std::size_t b = 0; b < 3; ++b) {
    const Estimate& its = found.velocities_after[b];
    EXPECT_NEAR(its.value, b == 2 ? speed : 0.0, its.error) << b;
    EXPECT_LT(its.error, 0.1 * speed);
  }
}

TEST(RowLimits, TwoRodsAreAPair) {
  // ε = L₁/L₂: the first stops dead.
  const RowResult found = row(row_of({rod(), rod({2.0, 1.0, 1.0, 1.0})}, {0, 1}), {0.1, 0.0}, {.tolerance = 0.03});
  EXPECT_NEAR(found.velocities_after[0].value, 0.0, found.velocities_after[0].error);
  EXPECT_NEAR(found.velocities_after[1].value, 0.05, found.velocities_after[1].error);
}

// Spectral elements, ball after ball, ν = 0.3: velocities over that before, uncertain by 2·10⁻⁵.
TEST(RowLimits, AreThoseOfFiniteElements) {
  const std::vector<std::pair<double, Speeds>> references{{0.1, {-0.02709, 0.03197, 0.99512}},
                                                          {0.02, {-0.04760, 0.05040, 0.99720}},
                                                          {0.1, {-0.02709, -0.00827, -0.00279, 0.04338, 0.99477}}};
  for (const auto& [speed, after] : references) {
    Speeds speeds(after.size());
    speeds.front() = speed;
    const RowResult found = row(equal(sphere(0.3), after.size()), speeds);
    EXPECT_TRUE(found.converged) << found.reason;
    for (std::size_t b = 0; b < after.size(); ++b) {
      EXPECT_NEAR(found.velocities_after[b].value / speed, after[b], found.velocities_after[b].error / speed + 2e-5);
    }
  }
}

/// The same row from the other side, which moves to the left where the one moves to the right.
Row mirrored(const Row& row) {
  Row its = row;
  its.bodies.assign(row.bodies.rbegin(), row.bodies.rend());
  its.gaps.assign(row.gaps.rbegin(), row.gaps.rend());
  std::swap(its.wall_before, its.wall_after);
  return its;
}

// Of one material, so that c is the same whoever is the first.
TEST(RowLimits, AreTheSameFromTheOtherSide) {
  Row row = row_of({sphere(0.3), sphere({0.3, 2.0, 1.0, 1.0}), sphere({0.3, 1.5, 1.0, 1.0})}, {0, 1, 2});
  const Speeds speeds{0.05, 0.02, 0.0}, back{0.0, -0.02, -0.05};
  for (const bool wall : {false, true}) {
    row.wall_after = wall;
    const RowResult here = stoss::row(row, speeds), there = stoss::row(mirrored(row), back);
    EXPECT_TRUE(here.converged && there.converged) << here.reason << there.reason;
    for (std::size_t b = 0; b < 3; ++b) {
      const Estimate &one = here.velocities_after[b], &other = there.velocities_after[2 - b];
      EXPECT_NEAR(one.value, -other.value, one.error + other.error) << b;
    }
  }
}

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

TEST(RowLimits, KeepAccountOfMomentumAndEnergy) {
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
TEST(RowLimits, OfLossyBodiesConverge) {
  for (const double loss_time : {0.1, 1.0}) {
    const Row row = equal(sphere({0.3, 1.0, 1.0, 1.0, loss_time}), 3);
    const RowImpact coarse = row_impact(row, {0.1, 0.0, 0.0}, 11.0), fine = row_impact(row, {0.1, 0.0, 0.0}, 32.0);
    for (std::size_t b = 0; b < 3; ++b) {
      EXPECT_NEAR(coarse.velocities_after[b], fine.velocities_after[b], 1e-5) << loss_time;
    }
  }
}

// Nearly incompressible balls take steps much shorter than the modes that are not kept.
TEST(RowLimits, OfShortStepsConverge) {
  const Row row = equal(sphere(0.4999), 3);
  const RowImpact coarse = row_impact(row, {0.1, 0.0, 0.0}, 11.0), fine = row_impact(row, {0.1, 0.0, 0.0}, 22.0);
  for (std::size_t b = 0; b < 3; ++b) EXPECT_NEAR(coarse.velocities_after[b], fine.velocities_after[b], 1e-5) << b;
  EXPECT_LT(std::abs(coarse.energy_error), 1e-4);
}

// What follows across a body must not drive its contacts, however short steps are beside the modes that are not kept.
TEST(RowLimits, OfNearlyIncompressibleBodiesKeepAccountOfTheEnergy) {
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

TEST(RowLimits, HaveRigidBodiesBetweenOthers) {
  expect_closed(row_of({sphere(0.3), rigid(sphere(0.3))}, {0, 1, 0}), {0.05, 0.0, 0.0});
}

// They begin where no vibration makes them touch: by its reach further away than bodies at rest.
TEST(RowLimits, OfVibratingBodiesKeepAccountOfTheEnergy) {
  for (const double phase : {0.0, 1.0, 3.0}) {
    Row row = equal(sphere(0.3), 3);
    row.vibration = {{.body = 0, .order = 2, .index = 0, .energy = 0.1, .phase = phase},
                     {.body = 1, .order = 3, .index = 0, .energy = 0.03, .phase = phase}};
    expect_closed(row, {0.1, 0.0, 0.0}, 1e-4);
  }
}

TEST(RowLimits, AreTheSameAgain) {
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
TEST(RowLimits, ShowTheForcesThatMoveTheBodies) {
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
TEST(RowLimits, ABallBetweenWallsGoesOn) {
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

TEST(RowLimits, RefuseWhatIsNoRow) {
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
  test::expect_refusal([&] { (void)stoss::row(three, {0.1, 0.0, 0.0}, {.tolerance = 0.0}); }, {"tolerance"});
}

}  // namespace
}  // namespace stoss
