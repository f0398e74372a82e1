// Contacts that are ellipses, as a point of unequal curvatures has them, against Hertz' own formulas.
#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <memory>
#include <numbers>

#include "contact/ellipse.hpp"
#include "stoss/bodies/modal_body.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/ladder.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/modal_sphere.hpp"

namespace stoss {
namespace modal_ellipses {
namespace {

struct Ellipse {
  double first, second;  ///< relative principal curvatures
  double counts;         ///< curvature of a ball that yields as much
};

/// Hertz' pressure p₀ = E* over the half-axes 1 and b: z = (p₀/E*) [bK − …] (Johnson 1985, eq. 4.24 to 4.26).
Ellipse hertz(double b) {
  const double square = 1.0 - b * b, e = std::sqrt(square);
  const double first = boost::math::ellint_1(e), second = boost::math::ellint_2(e);
  const double compression = b * first, force = 2.0 / 3.0 * std::numbers::pi * b;
  return {2.0 * b / square * (first - second), 2.0 * b / square * (second / (b * b) - first),
          16.0 * std::pow(compression, 3) / (9.0 * force * force)};
}

TEST(ModalEllipse, YieldsAsHertzSays) {
  for (const double b : {0.95, 0.8, 0.6, 0.5, 0.41}) {
    const Ellipse its = hertz(b);
    const double mean = 0.5 * (its.first + its.second);
    ASSERT_LT(its.second / its.first, 4.0);
    for (const double other : {0.0, 0.3 * its.first}) {  // that a partner has part of both
      Body body;
      body.curvature = mean - other;
      body.curvature_difference = its.second - its.first;
      body.surface = [](const ContactPoints&) { return Surface{{0.0, 1.0}, {1.0, 1.0}, {1.0, 1.0}, {}}; };
      const auto round = as_round(std::make_shared<const Body>(body), other);
      EXPECT_NEAR((round->curvature + other) / its.counts, 1.0, 3e-5) << b;
      const ContactPoints points{.radius = 1.0, .spacing = 0.1, .count = 2};
      const double distance = std::sin(points.angle(1)), less = body.curvature - round->curvature;
      EXPECT_NEAR(round->surface(points).recess[1], 1.0 - 0.5 * less * distance * distance, 1e-12);
    }
  }
}

Restitution value_of(double difference, double speed, bool ball = false) {
  ModalBody body = test::modal_sphere(0.3, 12.0);
  body.curvature_difference = difference;
  try {
    if (ball) return restitution(RefinableContact(modal_body(body), sphere(0.3)), speed);
    return restitution(RefinableContact(modal_body(body)), speed);
  } catch (const RestitutionNotConverged& error) {
    return error.best;
  }
}

// Force F ∝ δ^{3/2}/√H, so at one speed it lasts longer by H^{1/5}, and the greatest force is less by H^{−1/5}.
TEST(ModalEllipse, LastsAsLongAsItsHertzContact) {
  constexpr double difference = 2.0 * 0.5;  // 3 : 1
  const Restitution round = value_of(0.0, 1e-5), oval = value_of(difference, 1e-5);
  const double softer = 0.8242;  // H/M at 3 : 1
  EXPECT_NEAR(oval.contact_time.value / round.contact_time.value, std::pow(softer, 0.2), 0.006);
  EXPECT_NEAR(oval.max_force.value / round.max_force.value, std::pow(softer, -0.2), 0.006);
}

// One principal curvature is −0.15, that of the ball 1: relative ones of 3.15 and 0.85.
TEST(ModalEllipse, OfASaddleAndABallLastsAsLong) {
  constexpr double difference = 2.0 * 1.15, t = 1.15 / 2.0;
  const Restitution round = value_of(0.0, 1e-5, true), saddle = value_of(difference, 1e-5, true);
  const double softer = 1.0 - t * t * (0.66713 + t * t * (0.12242 + t * t * 0.08633));
  EXPECT_NEAR(saddle.contact_time.value / round.contact_time.value, std::pow(softer, 0.2), 0.006);
  EXPECT_NEAR(saddle.max_force.value / round.max_force.value, std::pow(softer, -0.2), 0.006);
}

TEST(ModalEllipse, HasAnErrorWhereModesBendOverIt) {
  const Estimate round = value_of(0.0, 1e-3).lost_fraction, oval = value_of(0.6, 1e-3).lost_fraction;
  EXPECT_GT(oval.error / oval.value, round.error / round.value);
}

TEST(ModalEllipse, ThatIsLongIsRefusedAtWallsToo) {
  ModalBody body = test::modal_sphere(0.3, 12.0);
  body.curvature_difference = 1.3;  // 4.7 : 1
  EXPECT_THROW((void)RefinableContact(modal_body(body)).at(0), InvalidInput);
  EXPECT_NO_THROW((void)RefinableContact(modal_body(body), sphere(0.3)).at(0));
  body.curvature_difference = 2.0;
  EXPECT_NO_THROW((void)RefinableContact(modal_body(body), sphere(0.3)).at(0));  // relative ones 3 : 1
}

}  // namespace
}  // namespace modal_ellipses
}  // namespace stoss
