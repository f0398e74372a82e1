// The near side of a disk: a smaller disk of the same material with the contour of the whole, in units of the whole.
#include "bodies/disk/near_side.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "contact/unit_ratios.hpp"
#include "stoss/errors.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

const Disk whole{0.2, 30.0, 2.0, 3.0};
constexpr double size = 0.25, cutoff = 80.0;
const ContactPoints points{0.03, 0.02, 24};

void expect_near(const std::vector<double>& found, const std::vector<double>& known, double scale) {
  ASSERT_EQ(found.size(), known.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i] / (scale * known[i]), 1.0, 1e-11) << i;
}

TEST(NearSide, AnswersAsASmallerDisk) {
  const Body part = near_side(whole, size, cutoff);
  Disk smaller = whole;
  smaller.radius *= size;
  const Body small = disk(smaller, cutoff * size);
  const UnitRatios units(small, part);
  EXPECT_NEAR(units.length, size, 1e-15);
  EXPECT_NEAR(small.mass * units.mass, part.mass, 1e-14);
  const ContactPoints on_small{points.radius / size, points.spacing, points.count};
  const Surface here = part.surface(points), there = small.surface(on_small);
  expect_near(here.measure, there.measure, units.length);
  expect_near(here.impedance, there.impedance, units.impedance);
  EXPECT_EQ(here.shape, there.shape);
  expect_near(part.residual_compliance(points, {}), small.residual_compliance(on_small, {}), units.compliance);
  expect_near(part.residual_second_moment(points, {}), small.residual_second_moment(on_small, {}), units.second_moment);
  ASSERT_EQ(part.groups.size(), small.groups.size());
  for (std::size_t g = 0; g < part.groups.size(); ++g) {
    expect_near(part.groups[g].omega, small.groups[g].omega, 1.0 / units.time);
    EXPECT_EQ(part.groups[g].upper, small.groups[g].upper);
  }
  EXPECT_NEAR(part.stable_step, small.stable_step * units.time, 1e-15);
}

TEST(NearSide, HasTheContourTheSizeAndTheMassOfTheWhole) {
  const Body part = near_side(whole, size, cutoff), all = disk(whole, cutoff);
  expect_near(part.surface(points).recess, all.surface(points).recess, 1.0);
  EXPECT_EQ(part.extent, all.extent);
  EXPECT_EQ(part.scale.length, all.scale.length);
  EXPECT_NEAR(whole_mass(part), all.mass, 1e-15);
  EXPECT_NEAR(part.mass, all.mass * size * size, 1e-15);
  EXPECT_EQ(part.cutoff, cutoff);
  EXPECT_EQ(part.highest_cutoff, 1000.0 / size);
  validate(part);
}

// To its far side and back.
TEST(NearSide, EndsWithTheEchoOfThePressureWave) {
  const double pressure_speed = 1.0 / std::sqrt(1.0 - 0.2 * 0.2);
  EXPECT_NEAR(near_side(whole, size, cutoff).part.echo, 4.0 * size / pressure_speed, 1e-15);
  EXPECT_TRUE(std::isinf(disk(whole, cutoff).part.echo));
}

TEST(NearSide, OfFullSizeIsTheDisk) {
  const Body part = near_side(whole, 1.0, 20.0), all = disk(whole, 20.0);
  EXPECT_EQ(part.mass, all.mass);
  EXPECT_EQ(part.groups.back().omega, all.groups.back().omega);
  EXPECT_EQ(part.residual_compliance(points, {}), all.residual_compliance(points, {}));
}

TEST(NearSide, IsWhatADiskMakesOfItself) {
  const Body part = disk(whole, 1.0).near_side(size, 30.0, {});
  EXPECT_EQ(mode_count(part), mode_count(near_side(whole, size, 30.0)));
  EXPECT_FALSE(part.near_side);
}

TEST(NearSide, RefusesWhatItIsNot) {
  test::expect_refusal([] { (void)near_side(whole, 1.5, 20.0); }, {"size", "1.5", "0 to 1"});
  test::expect_refusal([] { (void)near_side(whole, 0.0, 20.0); }, {"size", "0"});
  test::expect_refusal([] { (void)near_side(whole, 0.5, 3000.0); }, {"cutoff", "1500", "1000"});
  const Body part = near_side(whole, 0.02, 80.0);
  EXPECT_THROW((void)part.surface({0.03, 0.02, 60}), NotConverged);  // points beyond its edge
}

}  // namespace
}  // namespace stoss
