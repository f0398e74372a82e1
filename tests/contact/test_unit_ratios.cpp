// The units of one body in those of another, against what they are of: E, ρ, sizes.
#include "contact/unit_ratios.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "support/disk_pairs.hpp"

namespace stoss {
namespace {

TEST(Units, OfADiskFollowFromItsModulusDensityAndRadius) {
  const Disk first{0.33, 1.7, 2.5, 0.6};
  for (const Disk& second : test::other_disks) {
    const UnitRatios units(disk(second, 5.0), disk(first, 5.0));
    const double length = second.radius / first.radius, young = second.young / first.young;
    const double density = second.density / first.density;
    EXPECT_NEAR(units.length, length, 1e-13);
    EXPECT_NEAR(units.time, length * std::sqrt(density / young), 1e-13);
    EXPECT_NEAR(units.mass, density * length * length, 1e-13);
    EXPECT_NEAR(units.compliance, 1.0 / young, 1e-13);
    EXPECT_NEAR(units.second_moment, density / (young * young) * length * length, 1e-12);
    EXPECT_NEAR(units.impedance, std::sqrt(young * density) * length, 1e-13);
  }
}

TEST(Units, OfARodFollowFromItsModulusDensityLengthAndSection) {
  const Rod first{1.7, 2.5, 0.6, 0.3}, second{0.4, 5.0, 3.0, 0.2};
  const UnitRatios units(rod(second, 5.0), rod(first, 5.0));
  const double length = second.length / first.length, young = second.young / first.young;
  const double density = second.density / first.density, area = second.area / first.area;
  EXPECT_NEAR(units.time, length * std::sqrt(density / young), 1e-13);
  EXPECT_NEAR(units.mass, density * area * length, 1e-13);
  EXPECT_NEAR(units.compliance, length / (young * area), 1e-13);
  EXPECT_NEAR(units.second_moment, units.compliance * units.time * units.time, 1e-13);
  EXPECT_NEAR(units.impedance, area * std::sqrt(young * density), 1e-13);
}

TEST(Units, OfMassAreWhatABodyCountsItsOwnMassIn) {
  Body body = rod(Rod{1.0, 1.0, 6.0, 1.0}, 5.0), other = rod(Rod{1.0, 1.0, 4.0, 1.0}, 5.0);
  body.mass = 3.0;  // so its unit is 2
  EXPECT_NEAR(UnitRatios(body, other).mass, 0.5, 1e-15);
  EXPECT_NEAR(UnitRatios(other, body).mass, 2.0, 1e-15);
}

TEST(Units, ThereAndBackAreNone) {
  for (const Disk& other : test::other_disks) {
    const Body one = disk(0.33, 5.0), two = disk(other, 5.0);
    const UnitRatios there(two, one), back(one, two);
    EXPECT_NEAR(there.length * back.length, 1.0, 1e-14);
    EXPECT_NEAR(there.time * back.time, 1.0, 1e-14);
    EXPECT_NEAR(there.mass * back.mass, 1.0, 1e-14);
    EXPECT_NEAR(there.compliance * back.compliance, 1.0, 1e-14);
    EXPECT_NEAR(there.second_moment * back.second_moment, 1.0, 1e-14);
    EXPECT_NEAR(there.impedance * back.impedance, 1.0, 1e-14);
  }
  const UnitRatios none(disk(0.33, 5.0), disk(0.9, 5.0));
  EXPECT_EQ(none.mass, 1.0);
  EXPECT_EQ(none.compliance, 1.0);
}

}  // namespace
}  // namespace stoss
