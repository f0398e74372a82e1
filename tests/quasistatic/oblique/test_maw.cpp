// Maw's oblique impact: exact limits, phases, the curve of a sphere, and whether the stated errors are honest.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "quasistatic/oblique/tangential_contact.hpp"
#include "stoss/errors.hpp"
#include "stoss/quasistatic/oblique/maw.hpp"
#include "stoss/quasistatic/oblique/mindlin.hpp"
#include "support/refusal.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

const double sphere = 1.75 * mindlin_ratio(0.3);  // χ

double sum_of_times(const MawImpact& impact) {
  return impact.sliding + impact.sticking + impact.slipping + impact.reversed;
}

TEST(Maw, SlidesThroughoutFromTheLimitOn) {
  for (const double chi : {0.1, 0.5, 0.7, sphere, 30.0}) {
    const double limit = sliding_limit(chi);
    EXPECT_DOUBLE_EQ(limit, std::max(1.0, 4.0 * chi - 1.0));
    for (const double psi1 : {limit, 1.1 * limit, 1e5}) {
      const MawImpact impact = maw(psi1, chi);
      EXPECT_DOUBLE_EQ(impact.psi2, psi1 - 4.0 * chi);
      EXPECT_EQ(impact.psi2_error, 0.0);
      EXPECT_EQ(impact.impulse, 1.0);
      EXPECT_EQ(impact.sliding, 1.0);
      EXPECT_NEAR(impact.friction_loss, 4.0 * psi1 - 8.0 * chi, 4e-16 * psi1);  // μ times N times the mean of s
    }
  }
  // Below the limit it sticks before it leaves, which matters to second order: the slope is continuous, 1.
  double before = 0.0;
  for (const double below : {0.4, 0.2, 0.1}) {
    const double psi1 = sliding_limit(sphere) - below;
    const double excess = (maw(psi1, sphere, 1e-7).psi2 - psi1 + 4.0 * sphere) / (below * below);
    EXPECT_GT(excess, 0.0);
    EXPECT_NEAR(excess / (before > 0.0 ? before : excess), 1.0, 0.25);
    before = excess;
  }
}

TEST(Maw, FollowsTheNormalMotionAtOneHalf) {
  for (const double psi1 : {1e-3, 0.3, 0.9, 0.999}) {
    const MawImpact impact = maw(psi1, 0.5);
    EXPECT_NEAR(impact.psi2, -psi1, 1e-6 * psi1);
    EXPECT_NEAR(impact.friction_loss, 0.0, 2e-6 * psi1 * psi1);
    EXPECT_LE(std::abs(impact.psi2 + psi1), impact.psi2_error);
  }
}

TEST(Maw, IsContinuousWherePhasesVanish) {
  // Neighbours in double precision of the values at which they do.
  for (const double chi : {std::nextafter(0.5, 1.0), 0.6, sphere, 999.9}) {
    for (const double psi1 :
         {std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0), std::nextafter(sliding_limit(chi), 0.0)}) {
      const MawImpact impact = maw(psi1, chi), near = maw(psi1 * (1.0 - 1e-12), chi);
      EXPECT_NEAR(impact.psi2, near.psi2, impact.psi2_error + near.psi2_error + 1e-10 * chi) << psi1;
      EXPECT_NEAR(sum_of_times(impact), 1.0, 1e-6) << psi1;
    }
  }
}

TEST(Maw, OfAMirrorImageIsTheMirrorImage) {
  for (const double psi1 : {0.4, 2.5, 7.0}) {
    const MawImpact impact = maw(psi1, sphere), image = maw(-psi1, sphere);
    EXPECT_EQ(image.psi2, -impact.psi2);
    EXPECT_EQ(image.impulse, -impact.impulse);
    EXPECT_DOUBLE_EQ(image.friction_loss, impact.friction_loss);
    EXPECT_EQ(image.psi2_error, impact.psi2_error);
    EXPECT_EQ(image.slipping, impact.slipping);
  }
}

TEST(Maw, HasTheTimesOfItsPhases) {
  const auto until = [](double velocity) {  // time until ḋ falls to it, over the contact time
    const double half = 0.5 * boost::math::ibeta(0.4, 0.5, 1.0 - velocity * velocity);
    return velocity > 0.0 ? half : 1.0 - half;
  };
  for (const double chi : {0.8, sphere, 5.0}) {
    for (double share = 0.05; share < 1.1; share += 0.1) {
      const double psi1 = share * sliding_limit(chi);
      const MawImpact coarse = maw(psi1, chi), fine = maw(psi1, chi, 1e-7);
      EXPECT_NEAR(sum_of_times(coarse), 1.0, 1e-9);
      for (const auto member : {&MawImpact::sliding, &MawImpact::sticking, &MawImpact::slipping, &MawImpact::reversed})
        EXPECT_NEAR(coarse.*member, fine.*member, 0.005) << chi << " " << psi1;
      if (psi1 < 1.0) {
        EXPECT_GT(coarse.sticking, 0.05);
      } else if (share < 1.0) {
        const double at_first = until((2.0 * chi - psi1) / (2.0 * chi - 1.0)),
                     sliding = maw_path(psi1, chi, 100).sliding;
        EXPECT_GT(sliding, at_first - 1e-6) << chi << " " << psi1;
        EXPECT_LT(sliding, chi < 2.0 ? at_first + 1e-6 : 1.0) << chi << " " << psi1;  // a stiffer one may slide again
      }
    }
  }
  EXPECT_EQ(maw(0.9, sphere).sliding, 0.0);
  EXPECT_GT(maw(1.1, sphere).sliding, 0.1);
  EXPECT_GT(maw(2.0, sphere).reversed, 0.1);
}

TEST(Maw, ConvergesAsTheSquareOfItsStep) {
  for (const double psi1 : {0.1, 0.5, 1.3, 2.0, 4.0}) {
    const double exact = maw(psi1, sphere, 1e-8).impulse;
    double before = 0.0, before_extrapolated = 0.0;
    for (const int steps : {256, 1024}) {
      const double value = maw_path(psi1, sphere, steps).impulse, finer = maw_path(psi1, sphere, 2 * steps).impulse;
      const double error = std::abs(value - exact), extrapolated = std::abs(finer + (finer - value) / 3.0 - exact);
      if (before > 0.0) {
        EXPECT_NEAR(before / error, 16.0, 1.0) << psi1;
        EXPECT_LT(extrapolated, 0.02 * error + 1e-8) << psi1;
        EXPECT_LT(extrapolated, 0.5 * before_extrapolated + 1e-8) << psi1;
      }
      before = error, before_extrapolated = extrapolated;
    }
  }
}

TEST(Maw, StatesHonestErrors) {
  std::mt19937 random(3);
  const auto uniform = [&random] { return static_cast<double>(random()) / 4294967296.0; };
  for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
    int inside = 0;
    constexpr int count = 100;
    for (int i = 0; i < count; ++i) {
      const double chi = i % 2 == 0 ? 0.5 + 1.5 * uniform() : std::pow(10.0, -2.0 + 3.0 * uniform());
      const double psi1 = sliding_limit(chi) * uniform();
      const MawImpact impact = maw(psi1, chi, tolerance);
      const double true_error = std::abs(impact.psi2 - maw(psi1, chi, 1e-6).psi2);
      EXPECT_LE(impact.psi2_error, tolerance * std::min(psi1, 1.0));
      EXPECT_LE(true_error, tolerance * std::min(psi1, 1.0)) << chi << " " << psi1;
      if (true_error <= impact.psi2_error + 1e-7) ++inside;
    }
    EXPECT_GE(inside, 98 * count / 100) << tolerance;
  }
}

TEST(Maw, RefusesOtherInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {0.0, -1.0, 1001.0, nan}) {
    test::expect_refusal([&] { (void)maw(1.0, wrong); }, {"chi", "above 0 to 1000", "kappa"});
    test::expect_refusal([&] { (void)sliding_limit(wrong); }, {"chi", "above 0 to 1000"});
  }
  test::expect_refusal([&] { (void)maw(nan, 1.0); }, {"psi1: got nan", "-1e6 to 1e6"});
  test::expect_refusal([&] { (void)maw(2e6, 1.0); }, {"psi1", "-1e6 to 1e6"});
  for (const double wrong : {0.0, 0.2, nan}) {
    test::expect_refusal([&] { (void)maw(1.0, 1.0, wrong); }, {"tolerance", "1e-8 to 0.1"});
  }
  const std::string message = test::message_of<NotConverged>([] { (void)maw(400.0, 1000.0, 1e-8); });
  EXPECT_NE(message.find("raise the tolerance"), std::string::npos) << message;
}

}  // namespace
}  // namespace stoss
