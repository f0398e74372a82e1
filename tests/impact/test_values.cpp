// Impacts with known answers: from spectral finite elements where the test or the row says so,
// elsewhere from finer runs of the modal method itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <numeric>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/impact/impact.hpp"
#include "support/csv.hpp"

namespace stoss {
namespace {

/// ν = 0.33, v = 0.1, at three cutoffs.
constexpr std::array cutoffs{25.0, 50.0, 100.0};

TEST(ImpactValues, HardWallWithStaticTail) {
  constexpr std::array expected{0.1009, 0.1024, 0.1027};
  for (std::size_t i = 0; i < cutoffs.size(); ++i) {
    const Body body = disk(0.33, cutoffs[i]);
    const Impact fixed =
        impact(body, HardWall{}, 0.1, {.resolution = {.step = 0.5 / cutoffs[i], .tail = Tail::quasistatic}});
    EXPECT_NEAR(fixed.lost_fraction, expected[i], 2e-4) << "cutoff " << cutoffs[i];
  }
}

TEST(ImpactValues, HardWallWithRadiatingTail) {
  constexpr std::array expected{0.1032, 0.1031, 0.1031};
  for (std::size_t i = 0; i < cutoffs.size(); ++i) {
    const Body body = disk(0.33, cutoffs[i]);
    const Impact fixed = impact(body, HardWall{}, 0.1, {.resolution = {.step = 0.25 / cutoffs[i]}});
    EXPECT_NEAR(fixed.lost_fraction, expected[i], 1.5e-4) << "cutoff " << cutoffs[i];
    const Impact recommended = impact(body, HardWall{}, 0.1);
    EXPECT_NEAR(recommended.lost_fraction, expected[i], 1.5e-4) << "cutoff " << cutoffs[i];
  }
}

class SoftWallValues : public ::testing::Test {
 protected:
  /// With the step refined to a quarter of the usual one.
  static Impact refined(double cutoff) {
    const Body body = disk(0.33, cutoff);
    return impact(body, ExponentialWall{}, 0.1,
                  {.resolution = {.step = 0.25 * fixed_resolution(contact(body, ExponentialWall{}), 0.1).step,
                                  .tail = Tail::none}});
  }
};

TEST_F(SoftWallValues, OfTheLostFraction) {
  constexpr std::array expected{0.099881, 0.096137, 0.093990};
  std::array<double, 3> found{};
  for (std::size_t i = 0; i < cutoffs.size(); ++i) {
    found[i] = refined(cutoffs[i]).lost_fraction;
    EXPECT_NEAR(found[i], expected[i], 3e-5) << "cutoff " << cutoffs[i];
  }
  // The left-out modes cost 1/cutoff; extrapolated, this is the value of all modes by finite elements.
  double all_modes = 0.0;
  for (const auto& row : test::read_csv("restitution_exponential_wall.csv")) {
    if (row.number("poisson") == 0.33 && row.number("speed") == 0.1 && row.number("hardness") == 500.0) {
      all_modes = 1.0 - row.number("restitution") * row.number("restitution");
    }
  }
  EXPECT_NEAR(2.0 * found[2] - found[1], all_modes, 2e-4);
}

TEST_F(SoftWallValues, OfTheModesAfterTheImpact) {
  const Impact result = refined(50.0);
  const std::map<int, double> expected{{2, 0.0362}, {3, 0.0139}, {0, 0.00638}, {4, 0.0156}};
  std::size_t compared = 0;
  for (const ModeEnergy& mode : result.energy.modes) {
    if (mode.index != 0 || !expected.contains(mode.order)) continue;
    EXPECT_NEAR(mode.after / expected.at(mode.order), 1.0, 0.01) << "mode (" << mode.order << ", 0)";
    ++compared;
  }
  EXPECT_EQ(compared, expected.size());
}

TEST(ImpactReference, RestitutionAtHardWall) {
  std::map<double, Body> bodies;
  int by_finite_elements = 0;
  for (const auto& row : test::read_csv("restitution_hard_wall.csv")) {
    const double poisson = row.number("poisson"), speed = row.number("speed");
    if (!bodies.contains(poisson)) bodies.emplace(poisson, disk(poisson, 100.0));
    const Impact result = impact(bodies.at(poisson), HardWall{}, speed);
    const double lost = row.number("lost_fraction");
    EXPECT_NEAR(result.lost_fraction, lost, 1e-3 * lost + row.number("uncertainty")) << poisson << ", " << speed;
    if (row.has("finite_elements_restitution")) {
      ++by_finite_elements;
      EXPECT_NEAR(result.restitution, row.number("finite_elements_restitution"),
                  row.number("finite_elements_uncertainty") + 5e-5)
          << poisson << ", " << speed;
    }
  }
  EXPECT_EQ(by_finite_elements, 8);
}

TEST(ImpactReference, ContactAtHardWallIsThatOfFiniteElements_long) {
  std::map<double, Body> bodies;
  for (const auto& row : test::read_csv("contact_hard_wall.csv")) {
    const double poisson = row.number("poisson"), speed = row.number("speed");
    SCOPED_TRACE("nu = " + std::to_string(poisson) + ", v = " + std::to_string(speed));
    if (!bodies.contains(poisson)) bodies.emplace(poisson, disk(poisson, 100.0));
    std::vector<double> force;
    const Impact result =
        impact(bodies.at(poisson), HardWall{}, speed, {}, {[&](const Snapshot& now) { force.push_back(now.force); }});
    EXPECT_NEAR(result.contact_time, row.number("contact_time"),
                row.number("contact_time_uncertainty") + 2.0 * result.resolution.step);
    // The reference averages the force over 0.05 R/c.
    const auto window = std::lround(0.05 / result.resolution.step);
    double largest = 0.0;
    for (auto from = force.begin(); force.end() - from >= window; ++from) {
      largest = std::max(largest, std::accumulate(from, from + window, 0.0) / static_cast<double>(window));
    }
    EXPECT_NEAR(largest / row.number("max_force_over_piRE"), 1.0, 2e-3);
    EXPECT_GE(result.max_force, largest);
    EXPECT_NEAR(result.max_compression, row.number("max_compression"), 2e-5);
    const double degree = std::numbers::pi / 180.0;
    EXPECT_NEAR(result.max_half_width / degree, row.number("max_contact_half_angle_deg"), 1.0 + 1e-9);
    EXPECT_EQ(result.contacts, 1);
  }
}

class DefaultAccuracy : public ::testing::TestWithParam<double> {};

TEST_P(DefaultAccuracy, EnergyErrorIsBelowOneInTenThousand) {
  for (const double cutoff : {25.0, 50.0}) {
    const Body body = disk(GetParam(), cutoff);
    for (const double speed : {1e-4, 0.01, 0.05, 0.2, 0.4}) {  // others: the identities
      for (const Tail tail : {Tail::quasistatic, Tail::radiating}) {
        const Impact result = impact(body, HardWall{}, speed, {.resolution = {.tail = tail}});
        EXPECT_NEAR(result.energy_error, 0.0, 1e-4)
            << "cutoff " << cutoff << ", v = " << speed << (tail == Tail::radiating ? ", radiating" : ", static");
        EXPECT_LE(result.momentum_error, 1e-12);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Poisson, DefaultAccuracy, ::testing::Values(-0.5, 0.0, 0.33, 0.7, 0.9, 0.95));

}  // namespace
}  // namespace stoss
