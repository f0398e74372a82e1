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
#include "support/rows.hpp"
#include "support/runge_kutta.hpp"

namespace stoss {
namespace {

using test::equal;
using test::row_of;
using test::Speeds;

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

}  // namespace
}  // namespace stoss
