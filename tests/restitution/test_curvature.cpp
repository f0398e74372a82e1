// Converged results of disks so unequal that the near side of one stands for it.
#include "restitution/curvature.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <vector>

#include "impact/recommended.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/restitution.hpp"
#include "support/print.hpp"

namespace stoss {
namespace {

double wave_speed(const Disk& disk) { return std::sqrt(disk.young / disk.density); }

RefinableContact pair_of(const Disk& second) { return {disk(0.33), disk(second)}; }

struct Case {
  Disk second;
  double speed;
};

void PrintTo(const Case& its, std::ostream* out) {
  PrintTo(its.second, out);
  *out << ", speed " << its.speed;
}

class NearSideOf : public ::testing::TestWithParam<Case> {};

// The whole disk has few enough modes at one coarse cutoff.
TEST_P(NearSideOf, IsCorrectedToTheWhole) {
  const auto [second, speed] = GetParam();
  const RefinableContact pair = pair_of(second);
  ASSERT_LT(pair.part(), 0.5);
  const double cutoff = 11.0 / time_scale(pair.at(0));
  const Contact whole = contact(disk(Disk{0.33}, cutoff), disk(second, cutoff * second.radius / wave_speed(second)));
  const Impact known = impact(whole, speed, {.resolution = refined_resolution(whole, speed, 0.0)});
  const Contact& part = pair.at(cutoff, 1.0, {});
  Impact found = impact(part, speed, {.resolution = refined_resolution(part, speed, 0.0)});
  const CurvatureCorrection correction = curvature_correction(pair, speed, {});
  const double before = std::abs(found.restitution - known.restitution);
  correct(correction, part, found);
  // Grids and contours end between different nodes: ε differs by some 1e-5 without any part.
  EXPECT_NEAR(found.restitution, known.restitution, 2.0 * correction.error + 5e-5);
  EXPECT_LT(std::abs(found.restitution - known.restitution), 0.1 * before + 5e-5);
  EXPECT_LT(2.0 * found.restitution * correction.error, 5e-4 * found.lost_fraction);
  EXPECT_NEAR(found.lost_fraction, known.lost_fraction, 2e-4 * known.lost_fraction);
  EXPECT_NEAR(found.energy.lost_to_first, known.energy.lost_to_first, 1e-3);
  EXPECT_NEAR(found.energy.lost_to_first + found.energy.lost_to_second + found.energy_error, found.lost_fraction, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Every, NearSideOf,
                         ::testing::Values(Case{{0.33, 100.0, 1.0, 1.0}, 0.1}, Case{{0.33, 100.0, 1.0, 1.0}, 1e-4},
                                           Case{{-0.5, 100.0, 1.0, 1.0}, 0.02}, Case{{0.33, 2.2, 1e-3, 1e3}, 1e-4}));
INSTANTIATE_TEST_SUITE_P(Every_long, NearSideOf,
                         ::testing::Values(Case{{0.33, 100.0, 1.0, 1.0}, 1e-8}, Case{{0.9, 100.0, 1.0, 1.0}, 0.02},
                                           Case{{0.2, 60.0, 1.0, 2.0}, 0.3}, Case{{0.0, 60.0, 1e-3, 0.8}, 1e-3}));

// Finite elements with disk and half-plane meshed together: 1 − ε² = 0.67529(1).
TEST(NearSide, AgreesWithFiniteElements_long) {
  for (const double tolerance : {1e-3, 2e-4}) {
    const Restitution found = restitution(pair_of({0.33, 1000.0, 1.0, 1.0}), 0.1, {.tolerance = tolerance});
    EXPECT_NEAR(found.lost_fraction.value, 0.675294, found.lost_fraction.error + 1e-5);
    EXPECT_LE(found.lost_fraction.error, tolerance * found.lost_fraction.value);
  }
}

TEST(NearSide, MeetsTheUsualToleranceAtEveryRatio) {
  for (const Disk& second : {Disk{0.33, 46.0, 1.0, 1.0}, Disk{0.33, 1000.0, 1e-3, 1e3}, Disk{-0.5, 1000.0, 1.0, 1.0}}) {
    const RefinableContact pair = pair_of(second);
    for (const double own : {1e-8, 0.1}) {
      const double speed = std::max(1e-8, own / mach_number(pair.at(0), 1.0));
      EXPECT_NO_THROW((void)restitution(pair, speed)) << second.radius << ' ' << second.poisson << ' ' << speed;
    }
  }
}

TEST(NearSide, SaysWhatToleranceItMeets) {
  try {
    (void)restitution(pair_of({0.33, 1000.0, 1.0, 1.0}), 0.1, {.tolerance = 1e-6});
    FAIL();
  } catch (const RestitutionNotConverged& error) {
    EXPECT_NE(error.best.reason.find("near side"), std::string::npos) << error.best.reason;
    EXPECT_LT(error.best.lost_fraction.error, 1e-3);
  }
}

TEST(NearSide, LeavesWholeBodiesAlone) {
  const RefinableContact pair = pair_of({0.33, 20.0, 1.0, 1.0});
  EXPECT_EQ(pair.part(), 1.0);
  const CurvatureCorrection none = curvature_correction(pair, 0.1, {});
  EXPECT_EQ(none.shift, 0.0);
  EXPECT_EQ(none.error, 0.0);
}

}  // namespace
}  // namespace stoss
