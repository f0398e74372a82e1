#include "contact/zener.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace stoss;

namespace {

// With s = λ^(−2/3) x the ball's speed stays 1 while x′ = 1 − x^(3/2) in τ = λ^(2/3) t, and it
// follows its force from where that is 0 but for the loss of speed, λ^(−5/3).
TEST(Zener, OfAVeryLightPlateTakesAFewHundredStepsAndStays) {
  double last = 2.0;
  for (const double inelasticity : {20.0, 100.0, 1e3, 1e4, 1e6, 1e9, 1e12}) {
    const ZenerImpact its = zener_impact(inelasticity);
    EXPECT_EQ(its.restitution, 0.0) << inelasticity;
    EXPECT_GT(its.duration, 0.0) << inelasticity;
    EXPECT_LT(its.duration, last) << inelasticity;
    last = its.duration;
    const double own = its.duration * std::pow(inelasticity, 2.0 / 3.0);
    EXPECT_GT(own, 2.0) << inelasticity;
    EXPECT_LT(own, 2.0 + 2.5 * std::log(inelasticity)) << inelasticity;
  }
}

TEST(Zener, GoesOnFromAnyMotionOnAVeryLightPlate) {
  for (const double inelasticity : {1e4, 1e8}) {
    const double speed = 0.5;
    const ZenerImpact its = zener_impact(inelasticity, {std::pow(speed / inelasticity, 2.0 / 3.0), speed});
    EXPECT_EQ(its.restitution, 0.0) << inelasticity;
  }
}

}  // namespace
