// Contact on rings: a sphere pressed to a wall, against Hertz and against a much finer grid; where spheres can touch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"
#include "support/pressing.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

using test::Press;
using test::Pressing;

Contact at_wall(double poisson) { return contact(sphere(Sphere{poisson}, 0.5)); }

TEST(Rings, WithTheEdgeLawFollowTheExactContactAtAShiftedCompression) {
  constexpr int coarse = 32, fine = 500;
  constexpr double width = 0.2;
  for (const double poisson : {0.0, 0.3, 0.49}) {
    Pressing few(at_wall(poisson), width, coarse), many(at_wall(poisson), width, fine);
    double worst = 0.0, without = 0.0, wide = 0.0;
    for (int i = 0; i < 40; ++i) {
      const double compression = 0.025 * (1.0 + 0.007 * i);  // half-widths over some two spacings
      const Press exact = many.with_law(compression - few.shift() + many.shift());
      const Press press = few.with_law(compression);
      worst = std::max(worst, std::abs(press.force / exact.force - 1.0));
      without = std::max(without, std::abs(few.without_law(compression) / exact.force - 1.0));
      wide = std::max(wide, std::abs(press.half_width - exact.half_width) / few.spacing());
    }
    EXPECT_LT(worst, 6e-5) << poisson;
    EXPECT_GT(without, 10.0 * worst) << poisson;
    EXPECT_LT(wide, 0.12) << poisson;  // of a spacing
  }
}

/// The approach of the centre of mass to first order beyond Hertz (docs/theory/spheres.md).
TEST(Rings, ObeyTheLawForTheCentreOfMass) {
  struct Constant {
    double poisson, k;
  };
  for (const Constant& at : {Constant{0.0, -1.931081}, Constant{0.3, -1.540051}, Constant{0.49, -1.332548}}) {
    const double nu = at.poisson, soft = 1.0 - nu * nu;
    const Contact contact = at_wall(nu);
    double before = 0.0;
    for (const double radius : {0.02, 0.002, 0.0002}) {
      const double hertz = radius * radius;
      Pressing pressing(contact, 1.3 * radius, 200);
      const double force = pressing.with_law(hertz).force;
      const double a = std::cbrt(0.75 * force * soft);
      const double g = (1.0 - 2.0 * nu) * (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu));
      const double law =
          a * a + force / std::numbers::pi *
                      (soft * (g * (19.0 / 12.0 - std::log(2.0 * a)) + at.k) - 0.5 * (1.0 + nu) * (1.0 - 2.0 * nu));
      const double off = std::abs((hertz - pressing.shift()) / law - 1.0);
      EXPECT_LT(off, 0.7 * hertz + 3e-5) << nu << ", " << radius;                      // the law's own error is O(F a)
      EXPECT_LT(off, std::abs(hertz / (a * a) - 1.0) + 1e-9) << nu << ", " << radius;  // Hertz alone is further off
      before = off;
    }
    EXPECT_LT(before, 3e-5);
  }
}

TEST(Rings, KnowTheHertzianHalfWidthOfSlowImpacts) {
  const Contact wall = at_wall(0.3);
  EXPECT_NEAR(expected_half_width(wall, 1e-4), 0.0325, 3e-4);  // 0.03257 with all that is beyond Hertz
  // Equal spheres at twice the speed touch as widely.
  const Contact pair = contact(sphere(Sphere{0.3}, 0.5), sphere(Sphere{0.3}, 0.5));
  EXPECT_NEAR(expected_half_width(pair, 2e-4), expected_half_width(wall, 1e-4), 1e-15);
  EXPECT_NEAR(touch(pair).softness, 2.0 * 0.91, 1e-15);
  EXPECT_NEAR(mach_number(pair, 2e-4), 1e-4, 1e-18);
  // A softer second body in other units: 1/E* = 0.91/E + 0.96/E', 1/R* = 1 + 1/2.
  const Contact mixed =
      contact(sphere(Sphere{0.3}, 0.5), sphere(Sphere{0.2, 2.0, 0.1, 3.0}, 0.5 * 2.0 * std::sqrt(30.0)));
  EXPECT_NEAR(touch(mixed).softness, 0.91 + 9.6, 1e-12);
  EXPECT_NEAR(touch(mixed).curvature, 1.5, 1e-12);
}

TEST(Rings, OfUnequalSpheresAreThoseOfTheSmaller) {
  const Contact pair = contact(sphere(Sphere{0.3}, 0.5), sphere(Sphere{0.3, 2.0}, 1.0));
  const ContactGrid grid = contact_grid(pair, 0.6, 32);
  for (std::size_t i = 0; i < 32; ++i) {
    const double y = std::sin(grid.points.angle(i));
    EXPECT_NEAR(grid.recess[i], 1.0 - std::sqrt(1.0 - y * y) + 2.0 - std::sqrt(4.0 - y * y), 1e-14);
  }
  EXPECT_NO_THROW(EdgeContact(residual_compliance(pair, grid), edge_law(pair, grid, 0.0), 32, {}));
}

TEST(Rings, RefuseDisks) {
  test::expect_refusal([] { (void)contact(sphere(Sphere{0.3}, 0.5), disk(Disk{0.3}, 0.5)); },
                       {"against", "same kind of end"});
}

}  // namespace
}  // namespace stoss
