// That bodies turn too far for linear kinematics while they touch.
#include <gtest/gtest.h>

#include <cmath>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/impact/oblique.hpp"

namespace stoss {
namespace {

TEST(Turning, OfAFastSpinIsSaid) {
  for (const Body& body : {sphere(0.3, 12.0), disk(0.3, 12.0)}) {
    const ObliqueImpact fast = oblique_impact(contact(body), 0.05, {0.5, -0.5, 0.0, 0.1});  // rolls
    EXPECT_NEAR(fast.turned, 0.5 * fast.normal.contact_time, 0.02 * fast.turned) << body.name;
    EXPECT_GT(fast.turned, 2.5);
    EXPECT_TRUE(fast.beyond_small_turn);
    const ObliqueImpact slow = oblique_impact(contact(body), 0.05, {0.01, -0.01, 0.0, 0.1});
    EXPECT_NEAR(slow.turned, 0.01 * slow.normal.contact_time, 0.01 * slow.turned);
    EXPECT_FALSE(slow.beyond_small_turn);
  }
}

TEST(Turning, IsThatOfTheSecondBodyAndOfTheLineOfCentersToo) {
  const Contact pair = contact(sphere(0.3, 12.0), sphere(0.3, 12.0));
  const ObliqueImpact spinning = oblique_impact(pair, 0.05, {0.0, 0.0, 0.3, 0.1});
  EXPECT_NEAR(spinning.turned, 0.3 * spinning.normal.contact_time, 0.1 * spinning.turned);
  EXPECT_TRUE(spinning.beyond_small_turn);
  const ObliqueImpact passing = oblique_impact(pair, 0.05, {0.6, 0.0, 0.0, 0.0});
  EXPECT_NEAR(passing.turned, 0.3 * passing.normal.contact_time, 1e-9);
  EXPECT_TRUE(passing.beyond_small_turn);
}

}  // namespace
}  // namespace stoss
