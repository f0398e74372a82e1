// Rough faces: values of finite elements, both limits, and what is the same in all units.
#include <gtest/gtest.h>

#include <cmath>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/csv.hpp"

namespace stoss {
namespace {

Restitution at_rough_wall(const BodyMaker& body, double asperities, double speed, double tolerance = 1e-3) {
  return restitution(RefinableContact(body, ExponentialWall{1.0 / asperities}), speed,
                     {.tolerance = tolerance, .absolute = 0.0});
}

// Spectral finite elements without modes, cutoff or law of an edge (tests/data/make_rough_restitution.py): to a tenth
// of what is asked for by default, and within the error of nearly all.
TEST(Roughness, BallsAndDisksLoseWhatFiniteElementsSay) {
  int met = 0;
  for (const auto& row : test::read_csv("rough_restitution.csv")) {
    const bool ball = row.text("body") == "ball";
    const double poisson = row.number("poisson"), speed = row.number("speed"), its = row.number("lost_fraction");
    const double length = row.number("asperities"), mass = ball ? 4.0 / 3.0 * std::acos(-1.0) : std::acos(-1.0);
    SCOPED_TRACE(::testing::Message() << row.text("body") << " " << poisson << ", " << speed << ", " << length);
    for (const double tolerance : {1e-3, 1e-4}) {
      const Restitution made = at_rough_wall(ball ? sphere(poisson) : disk(poisson), length, speed, tolerance);
      const double bar = std::hypot(made.lost_fraction.error, row.number("uncertainty"));
      EXPECT_NEAR(made.lost_fraction.value, its, std::min(2.0 * bar, tolerance * its));
      const double force = row.number("max_force");  // the largest of those after each step
      EXPECT_NEAR(made.max_force.value * mass, force, 1e-3 * force + 2.0 * made.max_force.error * mass);
      EXPECT_NEAR(made.contact_time.value, row.number("contact_time"), 5e-3 * row.number("contact_time"));
    }
    ++met;
  }
  EXPECT_EQ(met, 7);
}

// Other ones, with their errors. The first is 2.6 of these off from the value above, 0.0043806: it is not made better
// here, but counts within three (docs/developer/numerics.md, section 16).
TEST(Roughness, BallsLoseWhatOtherFiniteElementsSay) {
  struct OfElements {
    double speed, asperities, lost, error;
  };
  for (const OfElements& its : {OfElements{0.1, 0.02, 0.004396, 6e-6}, OfElements{0.1, 0.005, 0.012037, 9e-6},
                                OfElements{0.02, 0.005, 0.0003289, 9e-7}}) {
    const Restitution made = at_rough_wall(sphere(0.3), its.asperities, its.speed);
    EXPECT_NEAR(made.lost_fraction.value, its.lost, 3.0 * std::hypot(its.error, made.lost_fraction.error));
  }
}

// Disks at the paper's wall with all modes. Finite elements weight by dφ where pressure acts on the projected area
// here: a difference of the order of (a/R)², 2.3·10⁻⁴ of 1 − ε² at αR = 500 and v = 0.1.
TEST(Roughness, DisksLoseWhatFiniteElementsSay) {
  int met = 0;
  for (const auto& row : test::read_csv("restitution_exponential_wall.csv")) {
    const double speed = row.number("speed"), hardness = row.number("hardness"), poisson = row.number("poisson");
    if (poisson != 0.33 || (hardness != 250.0 && hardness != 500.0 && hardness != 2000.0)) continue;
    const double error = speed >= 0.2 ? 5e-5 : 1e-5, half_width = std::sqrt(speed);  // a, within a factor
    const Restitution made = at_rough_wall(disk(poisson), 1.0 / hardness, speed);
    const double weight = 0.03 * half_width * half_width * made.lost_fraction.value;
    EXPECT_NEAR(made.restitution.value, row.number("restitution"),
                3.0 * std::hypot(error, made.restitution.error) + weight)
        << speed << ", " << hardness;
    ++met;
  }
  EXPECT_EQ(met, 15);
}

TEST(Roughness, DoesNotMatterWhereItIsFarBelowTheCompression) {
  const double smooth = restitution(sphere(0.3), 0.1).lost_fraction.value;
  double last = at_rough_wall(sphere(0.3), 1e-2, 0.1).lost_fraction.value;
  for (const double asperities : {1e-3, 1e-4, 1e-5}) {
    const double lost = at_rough_wall(sphere(0.3), asperities, 0.1).lost_fraction.value;
    EXPECT_GT(lost, last);
    EXPECT_LT(lost, smooth * (1.0 + 2e-3));
    last = lost;
  }
  EXPECT_NEAR(last, smooth, 2e-3 * smooth);
}

TEST(Roughness, OfLongAsperitiesNothingRings) {
  for (const BodyMaker& body : {sphere(0.3), disk(0.33)}) {
    EXPECT_LT(restitution(rough(body, 0.2), 0.01).lost_fraction.value, 1e-6);
  }
}

// A layer of asperities takes nothing: a material with a loss loses less with them, as the contact is slower.
TEST(Roughness, DissipatesNothing) {
  const BodyMaker lossy = sphere(Sphere{.poisson = 0.22, .loss_time = 0.01});
  double last = restitution(lossy, 0.1).lost_fraction.value;
  for (const double asperities : {1e-3, 1e-2, 1e-1}) {
    const double lost = restitution(rough(lossy, asperities), 0.1, {.tolerance = 1e-2}).lost_fraction.value;
    EXPECT_LT(lost, last) << asperities;
    last = lost;
  }
  EXPECT_LT(last, 0.003);
}

TEST(Roughness, OfBothFacesTogetherCounts) {
  const BodyMaker ball = sphere(0.3), block = half_space(HalfSpace{.poisson = 0.3});
  const RestitutionOptions options{.tolerance = 1e-2};
  const double one = restitution(RefinableContact(rough(ball, 0.01), block), 0.05, options).lost_fraction.value;
  const double other = restitution(RefinableContact(ball, rough(block, 0.01)), 0.05, options).lost_fraction.value;
  const double both =
      restitution(RefinableContact(rough(ball, 0.006), rough(block, 0.008)), 0.05, options).lost_fraction.value;
  EXPECT_NEAR(one, other, 1e-12);
  EXPECT_NEAR(one, both, 1e-12);
  EXPECT_LT(one, restitution(RefinableContact(ball, block), 0.05, options).lost_fraction.value);
}

}  // namespace
}  // namespace stoss
