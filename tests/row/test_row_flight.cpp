// Bodies of a row that fly freely go there at once: the same as step by step, and pairs in succession when far apart.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution.hpp"
#include "stoss/row/curve.hpp"
#include "stoss/row/row.hpp"
#include "support/refusal.hpp"
#include "support/rows.hpp"

namespace stoss {
namespace {

using test::Speeds;

const std::vector<RelaxationTerm> terms{{0.3, 1.0}, {0.2, 10.0}};

std::vector<BodyMaker> growing(const std::function<BodyMaker(double)>& of) { return {of(1.0), of(1.2), of(1.5)}; }

Row row_with(const std::vector<BodyMaker>& kinds, double gap) {
  Row row;
  row.kinds = kinds;
  for (std::size_t b = 0; b < kinds.size(); ++b) row.bodies.push_back(b);
  row.gaps.assign(kinds.size() - 1, gap);
  return row;
}

/// Velocities after impacts of two at a time: the first on the second, then that on the third.
Speeds pairs_in_succession(const std::vector<BodyMaker>& kinds, double speed) {
  Speeds after{speed, 0.0, 0.0};
  for (std::size_t k = 0; k < 2; ++k) {
    const double one = kinds[k](1.0, {}).scale.mass, other = kinds[k + 1](1.0, {}).scale.mass, met = after[k];
    const double share =
        (1.0 + restitution(RefinableContact(kinds[k], kinds[k + 1]), met).restitution.value) / (one + other);
    after[k] = met * (1.0 - share * other), after[k + 1] = met * share * one;
  }
  return after;
}

/// That of rows with gaps, whatever their length. @param apart by which vibration that is left changes velocities
void expect_pairs(const std::vector<BodyMaker>& kinds, double speed, double apart) {
  const Speeds pairs = pairs_in_succession(kinds, speed);
  for (const double gap : {1.0, 1000.0}) {
    const RowResult found = row(row_with(kinds, gap), {speed, 0.0, 0.0});
    EXPECT_TRUE(found.converged) << found.reason;
    for (std::size_t b = 0; b < 3; ++b) {
      EXPECT_NEAR(found.velocities_after[b].value, pairs[b], found.velocities_after[b].error + apart * speed) << gap;
    }
    EXPECT_LT(found.steps, 6000) << gap;  // of a flight of up to 1e9
    EXPECT_LT(std::abs(found.finest.energy_error), 1e-3);
    EXPECT_LT(std::abs(found.finest.momentum_error), 1e-12);
  }
}

TEST(RowFlight, OfBodiesFarApartIsOneOfPairsInSuccession) {
  expect_pairs(growing([](double radius) { return sphere({0.3, radius, 1.0, 1.0}); }), 1e-4, 1e-6);
  expect_pairs(growing([](double radius) { return sphere({0.3, radius, 1.0, 1.0}); }), 1e-3, 2e-6);
}

TEST(RowFlight, OfLossyBodiesToo) {
  expect_pairs(growing([](double radius) { return sphere({0.3, radius, 1.0, 1.0, 0.1}); }), 0.01, 1e-5);
  expect_pairs(growing([](double radius) { return relaxing(sphere({0.3, radius, 1.0, 1.0}), {terms}); }), 0.01, 1e-5);
}

// As the gap closes, contacts overlap in time: no jump of the velocities in between.
TEST(RowFlight, ShortensToContactsThatOverlap) {
  const auto kinds = growing([](double radius) { return sphere({0.3, radius, 1.0, 1.0}); });
  const RowResult touching = row(row_with(kinds, 0.0), {1e-3, 0.0, 0.0});
  const RowResult close = row(row_with(kinds, 1e-5), {1e-3, 0.0, 0.0});
  const RowResult apart = row(row_with(kinds, 1e-3), {1e-3, 0.0, 0.0});
  const RowResult far = row(row_with(kinds, 1.0), {1e-3, 0.0, 0.0});
  const auto first = [](const RowResult& of) { return of.velocities_after[0].value; };
  EXPECT_NEAR(first(close), first(touching), 2e-3 * 1e-3);
  EXPECT_LT(first(touching), first(close));
  EXPECT_LT(first(close), first(apart));
  EXPECT_LT(first(apart), first(far));
}

// Two balls that hardly part after they have met, and meet again while they ring, are followed to the end.
TEST(RowFlight, OfEqualBallsEnds) {
  for (const double gap : {1.0, 1000.0}) {
    const RowResult found = row(row_with({sphere(0.3), sphere(0.3), sphere(0.3)}, gap), {0.05, 0.0, 0.0});
    EXPECT_TRUE(found.converged) << found.reason;
    for (const double open : found.finest.open) EXPECT_EQ(open, 0.0);
    EXPECT_LT(found.velocities_after[0].value, found.velocities_after[1].value);
    EXPECT_LT(found.velocities_after[1].value, found.velocities_after[2].value);
    EXPECT_LT(found.steps, 40000);
  }
}

TEST(RowFlight, OfALongRowEnds) {
  Row row;
  row.kinds = {sphere(0.3)};
  row.bodies.assign(30, 0);
  Speeds speeds(30);
  speeds[0] = 0.1;
  const RowResult found = stoss::row(row, speeds);
  EXPECT_TRUE(found.converged) << found.reason;
  EXPECT_LT(std::abs(found.finest.energy_error), 1e-4);
}

TEST(RowFlight, IsTheSameWithAnyThreads) {
  const Row balls = row_with(growing([](double radius) { return sphere({0.3, radius, 1.0, 1.0}); }), 3.0);
  std::vector<Speeds> speeds;
  for (const double speed : {1e-3, 0.01, 0.02, 0.05, 0.1}) speeds.push_back({speed, 0.0, 0.0});
  std::vector<Speeds> found;
  for (const int threads : {1, 2, 3}) {
    std::size_t k = 0;
    row_curve(balls, speeds, {.threads = threads}, [&](std::size_t, const RowResult& result) {
      Speeds after;
      for (const Estimate& each : result.velocities_after) after.push_back(each.value), after.push_back(each.error);
      if (threads == 1) found.push_back(after);
      EXPECT_EQ(after, found[k++]) << threads;
    });
  }
}

TEST(RowFlight, ThatFailsDoesNotEndTheRest) {
  Row pair = test::equal(sphere(0.3), 2);
  pair.wall_before = true;
  const std::vector<Speeds> speeds{{0.0, -1.0}, {0.0, -0.05}};
  std::vector<RowResult> found;
  row_curve(pair, speeds, {}, [&](std::size_t, const RowResult& result) { found.push_back(result); });
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NE(found[0].reason.find("of the energy is unaccounted for"), std::string::npos) << found[0].reason;
  EXPECT_FALSE(found[0].converged);
  EXPECT_TRUE(std::isnan(found[0].velocities_after[1].value) && std::isnan(found[0].finest.energy_error));
  ASSERT_EQ(found[0].finest.contacts.size(), 2U);
  EXPECT_EQ(found[0].finest.contacts[0].left, -1);
  EXPECT_TRUE(found[1].converged) << found[1].reason;
  EXPECT_NO_THROW(check(pair, speeds, {}));
  test::expect_refusal([&] { check(pair, speeds, {.threads = -1}); }, {"threads", "-1"});
  test::expect_refusal([&] { check(pair, {{0.1}}, {}); }, {"speed"});
}

// What stands at an end is computed from its first touch on: a ball comes back the same from however far away.
TEST(RowFlight, ToABlockChangesNothing) {
  Row row;
  row.kinds = {sphere(0.3), sphere({0.3, 0.5, 1.0, 1.0}), half_space(HalfSpace{.poisson = 0.3})};
  row.bodies = {1, 0, 2};
  Speeds after;
  for (const double gap : {0.3, 300.0}) {
    row.gaps = {gap, 0.0};
    const RowResult found = stoss::row(row, {0.05, 0.0, 0.0}, {.tolerance = 1e-2});
    EXPECT_LT(found.finest.time, 40.0);
    after.push_back(found.velocities_after[0].value);
    row.gaps = {0.0, gap};
    const RowImpact later = row_impact(row, {0.05, 0.0, 0.0}, 4.0);
    EXPECT_LT(later.velocities_after[1], 0.0);
    EXPECT_LT(std::abs(later.energy_error), 1e-3);
  }
  EXPECT_NEAR(after[0], after[1], 1e-9 * 0.05);
}

/// Displacements that the observer sees are those of the velocities, flights included.
TEST(RowFlight, ShowsWhereBodiesAre) {
  const Row row = row_with(growing([](double radius) { return sphere({0.3, radius, 1.0, 1.0}); }), 2.0);
  const Speeds speeds{0.05, 0.0, 0.0};
  Speeds moved(3);
  double before = 0.0, longest = 0.0;
  Speeds last = speeds;
  RowWatch watch;
  bool first = true;
  watch.observer = [&](const RowSnapshot& now) {
    if (!first) longest = std::max(longest, now.time - before);
    for (std::size_t b = 0; !first && b < 3; ++b) {
      moved[b] += 0.5 * (last[b] + now.velocity[b]) * (now.time - before);
      EXPECT_NEAR(now.displacement[b], moved[b], 2e-3);
    }
    if (first) moved = now.displacement;
    first = false, before = now.time, last = now.velocity;
  };
  const RowImpact seen = row_impact(row, speeds, 8.0, {}, watch), silent = row_impact(row, speeds, 8.0);
  EXPECT_GT(longest, 20.0);  // no instants in a flight of all
  EXPECT_EQ(seen.velocities_after, silent.velocities_after);
  const RowImpact halfway = row_impact(row, speeds, 8.0, {}, {.until = 30.0});
  EXPECT_NEAR(halfway.time, 30.0, halfway.step);
}

}  // namespace
}  // namespace stoss
