// The tangential force of Hertz' contact: Mindlin's closed forms, histories with known answers, and springs one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "quasistatic/oblique/tangential_contact.hpp"
#include "stoss/quasistatic/oblique/mindlin.hpp"
#include "support/refusal.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Mindlin, IsTheClosedForm) {
  for (const double x : {0.0, 1e-12, 0.1, 0.5, 0.9, 1.0}) {
    EXPECT_NEAR(mindlin_force(x), 1.0 - std::pow(1.0 - x, 1.5), 1e-15);
    EXPECT_EQ(mindlin_force(-x), -mindlin_force(x));
    EXPECT_NEAR(mindlin_displacement(mindlin_force(x)), x, 2e-15);
    EXPECT_NEAR(std::pow(mindlin_stick_radius(mindlin_force(x)), 2), 1.0 - x, 1e-15);
  }
  EXPECT_EQ(mindlin_force(3.0), 1.0);
  EXPECT_EQ(mindlin_force(-3.0), -1.0);
  EXPECT_NEAR(mindlin_force(1e-200), 1.5e-200, 1e-215);
}

TEST(Mindlin, TractionHasTheForceAndObeysCoulomb) {
  boost::math::quadrature::tanh_sinh<double> integrate;
  for (const double force : {-0.7, 0.0, 0.2, 0.99, 1.0}) {
    const double c = mindlin_stick_radius(force);
    const auto ring = [&](double r) { return 3.0 * r * mindlin_traction(force, r); };  // over (2/3)π a² μp₀
    EXPECT_NEAR(integrate.integrate(ring, 0.0, c) + (c < 1.0 ? integrate.integrate(ring, c, 1.0) : 0.0), force, 1e-13);
    for (double r = 0.0; r < 1.2; r += 0.05) {
      const double limit = r < 1.0 ? std::sqrt(1.0 - r * r) : 0.0, traction = std::abs(mindlin_traction(force, r));
      EXPECT_LE(traction, limit + 1e-16);
      EXPECT_NEAR(r > c ? traction : limit, limit, 1e-15);
    }
  }
}

TEST(Mindlin, RatioIsThatOfBothFlexibilities) {
  EXPECT_DOUBLE_EQ(mindlin_ratio(0.0), 1.0);
  EXPECT_DOUBLE_EQ(mindlin_ratio(0.3), 1.4 / 1.7);
  // Johnson, eq. 7.42: δ_max = 3μN (2 − ν)/(16Ga) is μd/κ with Hertz' d = 3N (1 − ν)/(8Ga).
  for (const double nu : {-0.5, 0.2, 0.49}) {
    EXPECT_NEAR(3.0 * (1.0 - nu) / 8.0 / mindlin_ratio(nu), 3.0 * (2.0 - nu) / 16.0, 1e-15);
  }
}

TEST(Mindlin, RefusesWhatHasNoMeaning) {
  test::expect_refusal([] { (void)mindlin_ratio(0.5); }, {"poisson"});
  test::expect_refusal([] { (void)mindlin_force(nan); }, {"displacement: got nan", "finite"});
  for (const double wrong : {1.001, -1.001, nan}) {
    test::expect_refusal([&] { (void)mindlin_displacement(wrong); }, {"tangential", "-1 to 1"});
    test::expect_refusal([&] { (void)mindlin_stick_radius(wrong); }, {"tangential", "-1 to 1"});
    test::expect_refusal([&] { (void)mindlin_traction(wrong, 0.5); }, {"tangential", "-1 to 1"});
  }
  test::expect_refusal([] { (void)mindlin_traction(0.5, -0.1); }, {"distance", "-0.1", "0 or more"});
}

/// A contact under constant force.
TangentialContact pressed(double approach) {
  TangentialContact contact;
  contact.move(approach, 0.0);
  return contact;
}

TEST(TangentialContact, IsMindlinsUnderConstantForce) {
  for (const double d : {1e-6, 0.3, 1.0}) {
    TangentialContact contact = pressed(d);
    const double most = std::pow(d, 1.5);
    for (const double x : {0.0, 0.01, 0.2, 0.5, 0.99, 1.0, 1.7}) {
      contact.move(d, x * d);
      EXPECT_NEAR(contact.force(), most * mindlin_force(x), 1e-14 * most) << x;
      EXPECT_NEAR(contact.stick_radius(),
                  x == 0.0 ? contact.radius() : contact.radius() * std::sqrt(std::max(1.0 - x, 0.0)), 1e-14);
    }
  }
}

TEST(TangentialContact, HasTheLoopsOfMindlinAndDeresiewicz) {
  // Every branch is the first one, twice as large, until a loop has closed; then the branch before goes on.
  TangentialContact contact = pressed(1.0);
  const auto branch = [](double at, double turn, double force) {
    return force + 2.0 * mindlin_force(0.5 * (at - turn));
  };
  contact.move(1.0, 0.8);
  const double top = contact.force();
  for (const double u : {0.7, 0.3, -0.2}) {
    contact.move(1.0, u);
    EXPECT_NEAR(contact.force(), branch(u, 0.8, top), 1e-14);
  }
  const double bottom = contact.force();
  for (const double u : {0.0, 0.5, 0.8}) {
    contact.move(1.0, u);
    EXPECT_NEAR(contact.force(), branch(u, -0.2, bottom), 1e-14);
  }
  contact.move(1.0, 0.9);
  EXPECT_NEAR(contact.force(), mindlin_force(0.9), 1e-14);
}

TEST(TangentialContact, SticksWhereBothForcesGrowTogether) {
  // |dU| < dd from the beginning: T = (U/d) N without slip (Mindlin and Deresiewicz).
  TangentialContact contact;
  for (const double d : {0.1, 0.35, 0.8}) {
    contact.move(d, -0.6 * d);
    EXPECT_NEAR(contact.force(), -0.6 * std::pow(d, 1.5), 1e-15);
    EXPECT_EQ(contact.stick_radius(), contact.radius());
  }
  // At constant U what leaves takes its force along, and what stays slips once it must.
  contact.move(0.2, -0.6 * 0.8);
  EXPECT_NEAR(contact.force(), -std::pow(0.2, 1.5), 1e-15);
  contact.move(0.0, 0.0);
  EXPECT_EQ(contact.force(), 0.0);
}

TEST(TangentialContact, TakesAStraightPathInOneStep) {
  // Rates that do not change: the law has no error of its own, however long the move.
  const std::array<std::array<double, 2>, 5> corners{{{0.7, 0.5}, {1.0, 1.2}, {0.9, 0.3}, {0.4, 0.35}, {0.6, -0.1}}};
  TangentialContact coarse, fine;
  double d = 0.0, u = 0.0;
  for (const auto& [to_d, to_u] : corners) {
    coarse.move(to_d, to_u);
    constexpr int parts = 137;
    for (int i = 1; i <= parts; ++i) {
      const double share = static_cast<double>(i) / parts;
      fine.move(d + share * (to_d - d), u + share * (to_u - u));
    }
    d = to_d, u = to_u;
    EXPECT_NEAR(coarse.force(), fine.force(), 1e-13) << d << " " << u;
  }
}

TEST(TangentialContact, IsSpringsSideBySide) {
  // N springs at x, each of which sticks or slips by itself, along a path with many turns.
  constexpr std::size_t count = 4000;
  constexpr double widest = 1.1;
  std::vector<double> q(count, 0.0);
  TangentialContact contact;
  double last_d = 0.0, last_u = 0.0;
  for (int i = 1; i <= 600; ++i) {
    const double t = i / 600.0;
    const double d = std::max(0.0, std::sin(std::numbers::pi * t) * (1.0 + 0.2 * std::sin(17.0 * t)));
    const double u = 0.7 * std::sin(9.0 * t) + 0.2 * std::sin(31.0 * t);
    double force = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      const double x = widest * (static_cast<double>(k) + 0.5) / count;
      const double limit = std::max(d - x * x, 0.0), before = std::max(last_d - x * x, 0.0);
      const double share = before == 0.0 && limit > 0.0 ? limit / (d - last_d) : 1.0;  // since it has touched
      q[k] = std::clamp(q[k] + share * (u - last_u), -limit, limit);
      force += 1.5 * q[k] * widest / count;
    }
    contact.move(d, u);
    last_d = d, last_u = u;
    ASSERT_NEAR(contact.force(), force, 1e-6) << t;
    ASSERT_LE(std::abs(contact.force()), std::pow(d, 1.5) + 1e-14);
  }
}

}  // namespace
}  // namespace stoss
