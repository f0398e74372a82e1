// The coefficient of restitution with its error.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/restitution/restitution.hpp"
#include "stoss/version.hpp"
#include "support/csv.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

TEST(Restitution, OfARodIsOneWithinItsError) {
  for (const double speed : {1e-6, 0.1}) {
    try {
      (void)restitution(rod(), speed, {.absolute = 0.0});
      FAIL() << "the loss of a rod is nothing but error, so no relative tolerance is met";
    } catch (const RestitutionNotConverged& error) {
      const Restitution& best = error.best;
      EXPECT_FALSE(best.converged);
      EXPECT_NEAR(best.restitution.value, 1.0, best.restitution.error);
      EXPECT_LT(best.restitution.error, 0.02);
      EXPECT_NEAR(best.contact_time.value, 2.0, best.contact_time.error);
      EXPECT_LT(best.contact_time.error, 0.02);
    }
  }
}

TEST(Restitution, MeetsItsToleranceAndSaysHow) {
  const RefinableContact body(disk(0.33));
  std::size_t runs = 0;
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    const Restitution result = restitution(body, 0.1, {.tolerance = tolerance});
    EXPECT_TRUE(result.converged);
    EXPECT_TRUE(result.reason.empty());
    EXPECT_EQ(result.tolerance, tolerance);
    EXPECT_GT(result.lost_fraction.error, 0.0);
    EXPECT_LE(result.lost_fraction.error, tolerance * result.lost_fraction.value);
    // ε = √(1 − loss) carries the error of the loss over 2ε, where that is small.
    EXPECT_NEAR(2.0 * result.restitution.value * result.restitution.error / result.lost_fraction.error, 1.0, 1e-2);
    EXPECT_GE(result.runs.size(), std::max<std::size_t>(3, runs));
    runs = result.runs.size();
    long steps = 0;
    for (std::size_t i = 0; i < runs; ++i) {
      const auto& run = result.runs[i];
      if (i > 0) {
        EXPECT_GT(run.cutoff, result.runs[i - 1].cutoff);
      }
      EXPECT_LE(run.resolution.step * run.cutoff, 0.5 + 1e-12);
      EXPECT_GT(run.resolution.nodes, 0);
      steps += run.steps;
    }
    EXPECT_EQ(steps, result.steps);
    EXPECT_EQ(result.runs.back().lost_fraction, result.finest.lost_fraction);
    EXPECT_EQ(result.runs.back().unresolved, result.finest.energy.unresolved);
    // The value is that of the last run but for what the modes above the cutoff would have returned of what they took.
    EXPECT_LT(result.lost_fraction.value, result.finest.lost_fraction);
    EXPECT_GT(result.lost_fraction.value, result.finest.lost_fraction - 0.2 * result.finest.energy.unresolved);
    EXPECT_NEAR(result.restitution.value, std::sqrt(1.0 - result.lost_fraction.value), 1e-15);
    EXPECT_EQ(result.finest.impulse_time, result.impulse_time.value);
    EXPECT_EQ(result.finest.contact_time, result.contact_time.value);
    EXPECT_EQ(result.finest.cutoff, result.runs.back().cutoff);
    EXPECT_EQ(result.finest.contact, disk(0.33, result.finest.cutoff).name);
    EXPECT_NEAR(result.finest.energy_error, 0.0, 1e-3);
  }
}

TEST(Restitution, RecordsRunsThatCanBeRepeated) {
  const Restitution result = restitution(disk(-0.5), 0.02);
  for (const auto& run : result.runs) {
    const Impact repeated =
        impact(disk(-0.5, run.cutoff), HardWall{}, 0.02, {.resolution = Resolution(run.resolution)});
    EXPECT_EQ(repeated.lost_fraction, run.lost_fraction);
    EXPECT_EQ(repeated.contact_time, run.contact_time);
    EXPECT_EQ(repeated.max_force, run.max_force);
    EXPECT_EQ(repeated.steps, run.steps);
  }
}

TEST(Restitution, CoversTheWholeRange) {
  for (const double poisson : {-0.95, 0.0, 0.995}) {
    const RefinableContact body{disk(poisson)};
    for (const double speed : {1e-8, 1e-5, 0.02, 0.5, 1.0}) {
      const Restitution result = restitution(body, speed, {.tolerance = 0.05});
      EXPECT_TRUE(result.converged) << poisson << ", " << speed;
      EXPECT_GT(result.restitution.value, 0.0);
      EXPECT_LT(result.restitution.value, 1.0);
      EXPECT_EQ(result.finest.beyond_small_strain, speed >= 0.5);
    }
  }
}

TEST(Restitution, IsContentWithAnAbsoluteError) {
  const RefinableContact body(disk(0.33));
  const Restitution relative = restitution(body, 0.1, {.tolerance = 1e-3});
  for (const double absolute : {1e-2, 3e-4, 3e-5}) {
    const Restitution result = restitution(body, 0.1, {.tolerance = 1e-12, .absolute = absolute});
    EXPECT_TRUE(result.converged);
    EXPECT_EQ(result.absolute, absolute);
    EXPECT_LE(result.lost_fraction.error, absolute);
    // It aims at what is asked for: no more than a run too fine.
    if (absolute >= 3e-4) {
      EXPECT_LE(result.finest.cutoff, relative.finest.cutoff);
    }
  }
  const Restitution rod_at_wall = restitution(rod(), 0.1, {.absolute = 0.05});
  EXPECT_NEAR(rod_at_wall.restitution.value, 1.0, rod_at_wall.restitution.error);
  for (const double bad : {-1e-9, 0.6, std::nan("")}) {
    test::expect_refusal([&] { (void)restitution(body, 0.1, {.absolute = bad}); }, {"absolute", "0 to 0.5"});
  }
}

TEST(Restitution, WhatCannotConvergeEndsWithTheBestValue) {
  const RefinableContact body{disk(0.33)};
  try {
    (void)restitution(body, 0.3, {.tolerance = 1e-12, .absolute = 0.0});
    FAIL();
  } catch (const RestitutionNotConverged& error) {
    EXPECT_FALSE(error.best.converged);
    EXPECT_NEAR(error.best.lost_fraction.value, 0.29364, 3e-5);
    EXPECT_GT(error.best.lost_fraction.error, 0.0);
    EXPECT_LT(error.best.lost_fraction.error, 1e-5);
    EXPECT_NE(error.best.reason.find("did not reach the tolerance: that needs modes "), std::string::npos);
    EXPECT_NE(std::string(error.what()).find(error.best.reason), std::string::npos);
    EXPECT_GE(error.best.finest.cutoff, 181.0);  // what it costs little to know
  }
}

/// What stands for the results of runs that differ by chance: a disk and a rod in turn.
Restitution of_a_disk_and_a_rod(double poisson, double speed) {
  bool odd = false;
  const BodyMaker either = [&odd, poisson](double cutoff, const Poll&) {
    odd = !odd;
    return odd ? disk(poisson, std::min(cutoff, 20.0)) : rod(std::min(cutoff, 20.0));
  };
  try {
    return restitution(either, speed);
  } catch (const RestitutionNotConverged& error) {
    return error.best;
  }
}

TEST(Restitution, AnErrorAsLargeAsTheValueIsUnknown) {
  const Restitution some = of_a_disk_and_a_rod(0.33, 0.1);
  EXPECT_FALSE(some.converged);
  EXPECT_TRUE(std::isfinite(some.contact_time.value));
  EXPECT_TRUE(std::isinf(some.contact_time.error)) << "contact times of 2 and 6";
  EXPECT_TRUE(std::isinf(some.max_force.error));
  // Shares have a scale of their own: 0.1 ± 0.6 says something, 0.5 ± 3 does not.
  EXPECT_GT(some.lost_fraction.error, 0.1);
  EXPECT_LE(some.lost_fraction.error, 1.0);
  EXPECT_LE(some.restitution.error, 1.0);
  const Restitution none = of_a_disk_and_a_rod(0.9, 0.3);
  EXPECT_TRUE(std::isfinite(none.lost_fraction.value));
  EXPECT_TRUE(std::isinf(none.lost_fraction.error));
  EXPECT_TRUE(std::isinf(none.restitution.error));
}

TEST(Restitution, APollThatThrowsEndsIt) {
  struct Enough {};
  int calls = 0;
  const auto poll = [&calls] {
    if (++calls == 3) throw Enough{};
  };
  EXPECT_THROW((void)restitution(disk(0.33), 0.1, {.tolerance = 1e-6, .absolute = 0.0, .poll = poll}), Enough);
  EXPECT_EQ(calls, 3);
}

TEST(Restitution, RefusesBadInput) {
  test::expect_refusal([] { (void)restitution(disk(0.33), 0.0); }, {"speed", "got 0,", "1e-8 to 1"});
  test::expect_refusal([] { (void)restitution(disk(0.33), std::nan("")); }, {"speed", "nan"});
  test::expect_refusal([] { (void)restitution(disk(1.5), 0.1); }, {"poisson", "got 1.5,", "-0.95 to 0.995"});
  for (const double bad : {0.0, -1e-3, 0.9, std::nan(""), HUGE_VAL}) {
    test::expect_refusal([&] { (void)restitution(disk(0.33), 0.1, {.tolerance = bad}); },
                         {"tolerance", "1e-15 to 0.5"});
  }
  test::expect_refusal([] { (void)restitution(BodyMaker{}, 0.1); }, {"body", "function"});
}

TEST(RefinableContact, MakesEachLevelOnce) {
  int made = 0;
  const RefinableContact body([&made](double cutoff, const Poll&) {
    ++made;
    return rod(cutoff);
  });
  const RefinableContact copy = body;
  EXPECT_EQ(&body.at(3), &copy.at(3));
  EXPECT_EQ(made, 1);
  EXPECT_EQ(body.at(3).cutoff, body.cutoff(3));
  EXPECT_DOUBLE_EQ(body.cutoff(10), 32.0);
  test::expect_refusal([&] { (void)body.at(-1); }, {"level", "-1"});
  test::expect_refusal([&] { (void)body.at(body.highest_level() + 1); }, {"level"});
}

TEST(Version, HasThreeNumbers) {
  int major = -1, minor = -1, patch = -1;
  EXPECT_EQ(std::sscanf(std::string(version()).c_str(), "%d.%d.%d", &major, &minor, &patch), 3);
}

}  // namespace
}  // namespace stoss
