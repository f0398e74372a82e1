// Greatest force and contact time of rods, against the exact waves of d'Alembert.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "stoss/bodies/rod.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/vibration.hpp"
#include "stoss/restitution/curve.hpp"

namespace stoss {
namespace {

// The first plateau, Zv with 1/Z = 1/Z₁ + 1/Z₂, is the highest. Modes overshoot it by 9 % of the jump at any cutoff.
TEST(ForceOfRods, IsThatOfThePlateau) {
  constexpr double speed = 0.01;
  for (const double cutoff : {20.0, 50.0, 200.0, 1000.0}) {
    EXPECT_NEAR(impact(rod(cutoff), HardWall{}, speed).max_force / speed, 1.0, 5e-3) << cutoff;
    for (const Rod& other : std::vector<Rod>{{.length = 1.3},
                                             {.length = 0.4},
                                             {.area = 2.0},
                                             {.young = 0.3, .area = 0.7},
                                             {.length = 2.0, .young = 3.0, .density = 0.5, .area = 1.4}}) {
      const double impedance = std::sqrt(other.young * other.density) * other.area;
      const Impact found = impact(contact(rod(Rod{}), rod(other), cutoff, speed), speed);
      EXPECT_NEAR(found.max_force / speed * (1.0 + impedance) / impedance, 1.0, 1e-2) << cutoff << " " << found.contact;
    }
  }
}

// At a wall F = Z (v + w) with the velocity w of its free end: of the lowest mode a whole period, √(2e) v at most.
TEST(ForceOfRods, IsThatOfTheirVibrationToo) {
  constexpr double speed = 0.01, energy = 0.1;
  for (const double cutoff : {50.0, 200.0}) {
    const Contact wall = contact(rod(cutoff));
    const State start = approach(wall, speed, {{0, 0, 0, energy, 0.7}});
    const Impact found = impact(wall, speed, {.start = start});
    EXPECT_NEAR(found.max_force / speed, 1.0 + std::sqrt(2.0 * energy), 2e-2) << cutoff;
  }
}

TEST(ForceOfRods, HasAnErrorOfItsOwnSize) {
  for (const Rod& other : std::vector<Rod>{{.length = 1.3}, {.area = 2.0}, {.length = 0.4, .area = 0.5}}) {
    const double impedance = other.area, exact = 0.01 * impedance / (1.0 + impedance);
    const Restitution found =
        best_restitution(RefinableContact(rod(), rod(other)), 0.01, {.tolerance = 1e-15, .absolute = 0.02});
    EXPECT_NEAR(found.max_force.value, exact, found.max_force.error);
    EXPECT_LT(found.max_force.error, 0.06 * exact);
  }
}

// Of equal impedances the force ends at 2L₁/c₁, and the ends touch until 2L₂/c₂.
TEST(ContactTimeOfRods, EndsWithTheForce) {
  for (const double length : {1.05, 1.3, 2.0, 2.7}) {
    for (const double cutoff : {50.0, 181.0, 362.0, 1000.0}) {
      for (const double speed : {0.01, 0.1}) {
        const Impact found = impact(contact(rod(Rod{}), rod(Rod{.length = length}), cutoff, speed), speed);
        EXPECT_NEAR(found.contact_time, 2.0, 4.0 / cutoff) << length << ' ' << cutoff << ' ' << speed;
        EXPECT_EQ(found.contacts, 1) << length << ' ' << cutoff << ' ' << speed;
      }
    }
    const Restitution found = best_restitution(RefinableContact(rod(), rod(Rod{.length = length})), 0.1,
                                               {.tolerance = 1e-15, .absolute = 1e-3});
    EXPECT_NEAR(found.contact_time.value, 2.0, found.contact_time.error) << length;
    EXPECT_LT(found.contact_time.error, 0.1) << length;
  }
}

// A heavier rod stays in contact, at forces that fall by (Z₁ − Z₂)/(Z₁ + Z₂) = 1/3 each 2L₁/c₁, until 2L₂/c₂.
TEST(ContactTimeOfRods, LastsAsLongAsTheyPush) {
  const Impact found = impact(contact(rod(Rod{}), rod(Rod{.length = 3.3, .area = 0.5}), 400.0, 0.05), 0.05);
  EXPECT_NEAR(found.contact_time, 6.6, 0.02);
  EXPECT_EQ(found.contacts, 1);
}

}  // namespace
}  // namespace stoss
