// The contact points of two bodies, at equal distance from the axis, and what both are there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "support/disk_pairs.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

using std::numbers::pi;

/// Recess of a circle at the distance y from the axis.
double recess_of(double radius, double y) { return radius - std::sqrt(radius * radius - y * y); }

/// Impedance of both arcs of a disk that stand above the length dy of the axis' normal.
double impedance_of(const Disk& disk, double y, double dy) {
  const double sine = y / disk.radius, cosine = std::sqrt(1.0 - sine * sine);
  const double pressure = 1.0 / std::sqrt(1.0 - disk.poisson * disk.poisson);
  const double shear = 1.0 / std::sqrt(2.0 * (1.0 + disk.poisson));
  const double mobility = (cosine * cosine / pressure + sine * sine / shear) / std::sqrt(disk.young * disk.density);
  return 2.0 * dy / cosine / mobility;
}

class PairGrid : public ::testing::TestWithParam<Disk> {
 protected:
  const Disk one{0.33};
  const Disk other = GetParam();
  const Contact pair = test::pair_of(one, other, 14.0);
};

TEST_P(PairGrid, LiesOnTheSmallerCircleWithRecessesThatAdd) {
  const double smaller = std::min(1.0, other.radius);
  for (const double half_width : {0.02, 0.3 * smaller, 0.5 * pi * smaller}) {
    constexpr int nodes = 40;
    const ContactGrid grid = contact_grid(pair, half_width, nodes);
    ASSERT_EQ(grid.points.count, 40U);
    EXPECT_EQ(grid.points.radius, smaller);
    EXPECT_GE(grid.points.spacing * nodes * smaller, half_width * (1.0 - 1e-12));
    for (std::size_t i = 0; i < grid.points.count; ++i) {
      const double alpha = (static_cast<double>(i) + 0.5) * grid.points.spacing, y = smaller * std::sin(alpha);
      EXPECT_NEAR(grid.coordinate[i], smaller * alpha, 1e-14);
      EXPECT_NEAR(grid.recess[i], recess_of(1.0, y) + recess_of(other.radius, y), 1e-14);
      const double dy = smaller * std::cos(alpha) * grid.points.spacing;
      const double z1 = impedance_of(one, y, dy), z2 = impedance_of(other, y, dy);
      EXPECT_NEAR(grid.impedance[i] * (1.0 / z1 + 1.0 / z2), 1.0, 1e-12);
    }
  }
}

TEST_P(PairGrid, HasTheShapesOfEachAtItsOwnAngles) {
  const ContactGrid grid = contact_grid(pair, 0.1, 16);
  const std::size_t points = grid.points.count;
  for (std::size_t g = 0; g < pair.groups.size(); ++g) {
    const double radius = g < pair.first_groups ? 1.0 : other.radius;
    const auto order = static_cast<double>(pair.groups[g].order);
    for (std::size_t i = 0; i < points; ++i) {
      const double phi = std::asin(grid.points.radius * std::sin(grid.points.angle(i)) / radius);
      EXPECT_NEAR(grid.shape[pair.groups[g].upper_row * points + i], std::cos((order + 1.0) * phi), 1e-12);
      EXPECT_NEAR(grid.shape[pair.groups[g].lower_row * points + i], std::cos((order - 1.0) * phi), 1e-12);
    }
  }
}

TEST_P(PairGrid, EndsWhereTheSmallerDiskIsWidest) {
  const double greatest = 0.5 * pi * std::min(1.0, other.radius);
  EXPECT_NO_THROW((void)contact_grid(pair, greatest, 40));
  test::expect_refusal([&] { (void)contact_grid(pair, 1.01 * greatest, 40); }, {"half_width", "smaller"});
}

INSTANTIATE_TEST_SUITE_P(Every, PairGrid, ::testing::ValuesIn(test::other_disks));

TEST(RodPairGrid, IsOnePointWithImpedancesInSeries) {
  const Contact pair = contact(rod(), rod(Rod{0.4, 2.0, 3.0, 0.5}), 30.0);
  const ContactGrid grid = contact_grid(pair, 0.0, 1);
  ASSERT_EQ(grid.points.count, 1U);
  EXPECT_EQ(grid.recess.front(), 0.0);
  EXPECT_NEAR(1.0 / grid.impedance.front(), 1.0 + 1.0 / (0.5 * std::sqrt(6.0)), 1e-14);
}

}  // namespace
}  // namespace stoss
