// What a contact says of itself: modes of both bodies, and the scales of their collision, whoever is called the first.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"
#include "support/disk_pairs.hpp"

namespace stoss {
using namespace bodies::disk;

namespace {

constexpr double cutoff = 14.0;

class DiskPair : public ::testing::TestWithParam<Disk> {
 protected:
  const Disk one{0.33, 1.0, 1.0, 1.0};
  const Disk other = GetParam();
  const Contact here = test::pair_of(one, other, cutoff);
  const Contact there = test::swapped_pair(one, other, cutoff);
  const test::DiskUnits unit{other};  // those of `one` are 1
};

TEST_P(DiskPair, HasTheModesOfBothInUnitsOfTheFirst) {
  const auto of_one = bodies::disk::modes(one.poisson, cutoff),
             of_other = bodies::disk::modes(other.poisson, cutoff * unit.time);
  ASSERT_EQ(mode_count(here), of_one.size() + of_other.size());
  const double m1 = std::numbers::pi, m2 = std::numbers::pi * unit.mass, reduced = m1 * m2 / (m1 + m2);
  EXPECT_NEAR(here.mass, reduced, 1e-14);
  EXPECT_NEAR(here.extent, 1.0 + other.radius, 1e-14);
  EXPECT_EQ(here.cutoff, cutoff);
  std::size_t k = 0;
  for (std::size_t g = 0; g < here.groups.size(); ++g) {
    const bool of_first = g < here.first_groups;
    EXPECT_NEAR(modal_mass(here, g), of_first ? m1 : m2, 1e-13);
    const ModeGroup& group = here.groups[g];
    for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
      const Mode& mode = of_first ? of_one[k] : of_other[k - of_one.size()];
      const double amplitude = std::sqrt(reduced / modal_mass(here, g));
      EXPECT_EQ(group.order, mode.order);
      EXPECT_NEAR(group.omega[l], mode.omega / (of_first ? 1.0 : unit.time), 1e-12);
      EXPECT_NEAR(group.upper[l] + group.lower[l], amplitude * mode.radial, 1e-14);
    }
  }
  EXPECT_EQ(k, mode_count(here));
}

TEST_P(DiskPair, HasScalesThatDoNotDependOnWhoIsFirst) {
  constexpr double speed = 0.1, approach = 0.05;
  const double wave = unit.length / unit.time;
  EXPECT_NEAR(mach_number(there, speed / wave), mach_number(here, speed), 1e-14);
  EXPECT_NEAR(own_compression(there, approach / unit.length), own_compression(here, approach), 1e-15);
  EXPECT_NEAR(longest_time(there) * unit.time, longest_time(here), 1e-14);
  EXPECT_NEAR(time_scale(there) * unit.time, time_scale(here), 1e-14);
  EXPECT_NEAR(expected_half_width(there, speed / wave) * unit.length, expected_half_width(here, speed), 1e-14);
  EXPECT_NEAR(greatest_half_width(there) * unit.length, greatest_half_width(here), 1e-14);
  EXPECT_NEAR(highest_wave_number(there) / unit.length, highest_wave_number(here), 1e-12);
  EXPECT_NEAR(unresolved_share(there), 1.0 - unresolved_share(here), 1e-14);
  EXPECT_EQ(there.groups.size() - there.first_groups, here.first_groups);
}

TEST_P(DiskPair, HasScalesThatFollowFromSizeAndMaterial) {
  const double softness = 1.0 + 1.0 / other.young;  // a common force compresses by 1/E₁ and 1/E₂
  const double of_one = 1.0 / softness, of_other = 1.0 / (other.young * softness);
  EXPECT_NEAR(mach_number(here, 0.1), 0.1 * std::max(of_one, of_other / test::wave_speed(other)), 1e-14);
  EXPECT_NEAR(own_compression(here, 0.05), 0.05 * std::max(of_one, of_other / other.radius), 1e-14);
  EXPECT_NEAR(longest_time(here), std::max(1.0, unit.time), 1e-14);
  EXPECT_NEAR(time_scale(here), std::sqrt(softness * unit.mass / (1.0 + unit.mass)), 1e-14);
  EXPECT_NEAR(greatest_half_width(here), 0.5 * std::numbers::pi * std::min(1.0, other.radius), 1e-14);
  // ρc of the pressure wave.
  const auto impedance = [](const Disk& d) {
    return d.density * test::wave_speed(d) / std::sqrt(1.0 - d.poisson * d.poisson);
  };
  EXPECT_NEAR(unresolved_share(here), impedance(other) / (impedance(one) + impedance(other)), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Every, DiskPair, ::testing::ValuesIn(test::other_disks));

TEST(ContactScales, AreOneAtAWall) {
  const Contact wall = contact(disk(0.33, cutoff));
  EXPECT_EQ(mach_number(wall, 0.1), 0.1);
  EXPECT_EQ(own_compression(wall, 0.1), 0.1);
  EXPECT_EQ(longest_time(wall), 1.0);
  EXPECT_EQ(time_scale(wall), 1.0);
  EXPECT_EQ(unresolved_share(wall), 1.0);
  EXPECT_EQ(modal_mass(wall, 0), wall.mass);
}

TEST(ContactScales, OfEqualBodiesAreHalfOfEach) {
  const Disk one{0.33};
  const Contact equal = test::pair_of(one, one, cutoff);
  EXPECT_EQ(mach_number(equal, 0.2), 0.1);
  EXPECT_EQ(own_compression(equal, 0.2), 0.1);
  EXPECT_EQ(unresolved_share(equal), 0.5);
  EXPECT_NEAR(time_scale(equal), 1.0, 1e-15);
  EXPECT_NEAR(expected_half_width(equal, 0.2), expected_half_width(contact(disk(0.33, cutoff)), 0.1), 1e-14);
}

TEST(ContactScales, OfRodsAreThoseOfTheShorterTransit) {
  const Rod one{}, other{2.5, 1.0, 4.0, 0.5};  // transit time 5, impedance ρcA = 1
  const Contact here = contact(rod(one), rod(other), 30.0), there = contact(rod(other), rod(one), 150.0);
  EXPECT_NEAR(time_scale(here), 1.0, 1e-14);
  EXPECT_NEAR(time_scale(there), 0.2, 1e-14);
  EXPECT_NEAR(longest_time(here), 5.0, 1e-13);
  EXPECT_NEAR(unresolved_share(here), 0.5, 1e-14);
  EXPECT_EQ(greatest_half_width(here), 0.0);
  EXPECT_EQ(expected_half_width(here, 0.1), 0.0);
  EXPECT_TRUE(has_single_point(here));
}

TEST(ExpectedHalfWidth, IsThatOfTheImpactWithinThirtyPercent) {
  struct At {
    Disk first, second;
    double speed;
  };
  const Disk unit{0.33};
  for (const At& at :
       {At{unit, unit, 0.01}, At{unit, unit, 0.2}, At{unit, {0.33, 3.0, 1.0, 1.0}, 0.02},
        At{unit, {0.33, 0.2, 1.0, 1.0}, 0.02}, At{unit, {0.0, 1.0, 10.0, 1.0}, 0.1},
        At{unit, {0.5, 1.0, 0.1, 1.0}, 0.02}, At{unit, {0.2, 1.0, 1.0, 5.0}, 0.1}, At{unit, {0.2, 0.5, 2.0, 3.0}, 0.1},
        At{{-0.4}, {0.3, 3.0, 0.5, 0.2}, 0.1}, At{{0.9}, {0.9, 5.0, 1.0, 1.0}, 0.05}}) {
    const Contact pair = test::pair_of(at.first, at.second, 20.0 / std::max(1.0, test::DiskUnits(at.second).time));
    const Impact result = impact(pair, at.speed);
    EXPECT_NEAR(expected_half_width(pair, at.speed) / result.max_half_width, 1.0, 0.3)
        << at.second.poisson << ' ' << at.second.radius << ' ' << at.second.young << ' ' << at.speed;
  }
}

TEST(Contact, TellsItsBodiesAndWhichOfTheirModesStay) {
  const Contact at_wall = contact(disk(0.33, 10.0)), on_plane = contact(disk(0.33), half_plane(HalfPlane{}), 10.0);
  EXPECT_EQ(body_of(at_wall, 0), at_wall.first);
  EXPECT_EQ(body_of(at_wall, 1), nullptr);
  EXPECT_EQ(body_of(on_plane, 1), on_plane.second);
  EXPECT_EQ(body_of(on_plane, 2), nullptr);
  EXPECT_EQ(lasting_groups(at_wall), at_wall.groups.size());
  EXPECT_EQ(lasting_groups(on_plane), on_plane.first_groups);
  EXPECT_LT(on_plane.first_groups, on_plane.groups.size());
  EXPECT_TRUE(is_whole(*on_plane.first));
  EXPECT_FALSE(is_whole(*on_plane.second));
}

}  // namespace
}  // namespace stoss
