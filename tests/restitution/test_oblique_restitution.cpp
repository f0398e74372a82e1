// Converged oblique impacts: their errors against finite elements and finer runs, and their limits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "contact/along.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/plate.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/restitution/oblique.hpp"

namespace stoss {
namespace oblique_restitution_tests {
namespace {

struct Case {
  double friction, tangential, restitution, tangential_restitution, doubt;
};

// Finite elements, linear kinematics, ν = 0.33, v = 0.1 at a rigid wall.
TEST(ObliqueRestitution, IsThatOfFiniteElementsWithinItsErrors) {
  const RefinableContact wall(disk(0.33));
  for (const Case& its : {Case{0.1, 0.2, 0.94700, -0.7118, 2e-4}, Case{0.3, 0.1, 0.94595, 0.4926, 2e-4},
                          Case{1.0, 0.1, 0.94155, 0.4759, 1e-3}}) {
    const ObliqueRestitution result = oblique_restitution(wall, 0.1, {its.tangential, 0.0, 0.0, its.friction});
    EXPECT_TRUE(result.converged);
    EXPECT_LE(result.restitution.error, 1e-2);
    EXPECT_LE(result.tangential_restitution.error, 1e-2);
    EXPECT_NEAR(result.restitution.value, its.restitution, result.restitution.error + 5e-5);
    EXPECT_NEAR(result.tangential_restitution.value, its.tangential_restitution,
                result.tangential_restitution.error + its.doubt);
    EXPECT_EQ(result.restitution.value, result.finest.restitution);
    EXPECT_FALSE(result.unstable);
    EXPECT_GE(result.runs.size(), 3U);
  }
}

TEST(ObliqueRestitution, TellsOfTheSlipWhereThereWasNone) {
  const RefinableContact wall(disk(0.33));
  const ObliqueRestitution result = oblique_restitution(wall, 0.1, {0.0, 0.0, 0.0, 1.0});
  EXPECT_NEAR(result.sliding_after.value, 0.0, 1e-12);
  EXPECT_LE(result.sliding_after.error, 1e-3);
  EXPECT_EQ(result.tangential_restitution.error, std::numeric_limits<double>::infinity());
  EXPECT_NEAR(result.restitution.value, 0.94877, result.restitution.error + 5e-5);
}

// Rings of finer runs (ω_c = 45, 96 rings): ε_t = 0.8072, 0.4348 at ψ = κ s/μv = 2, 1.
TEST(ObliqueRestitution, OfSpheresIsThatOfFinerRuns) {
  const RefinableContact ball(sphere(0.3));
  constexpr double kappa = 2.0 * 0.7 / 1.7, friction = 0.3;
  const auto result = [&](double speed, double psi) {
    return oblique_restitution(ball, speed, {psi * friction * speed / kappa, 0.0, 0.0, friction});
  };
  const ObliqueRestitution fast = result(0.1, 2.0), slow = result(0.01, 1.0);
  EXPECT_NEAR(fast.tangential_restitution.value, 0.80724, fast.tangential_restitution.error);
  EXPECT_NEAR(fast.restitution.value, 0.991287, fast.restitution.error);
  EXPECT_NEAR(slow.tangential_restitution.value, 0.43471, slow.tangential_restitution.error);
}

TEST(ObliqueRestitution, MeetsMuchLargerBodiesAndHalfPlanes) {
  const RefinableContact great(disk(0.33), disk(Disk{0.1, 20.0, 2.0}));
  const RefinableContact plane(disk(0.33), half_plane(HalfPlane{0.1, 2.0}));
  const Obliquity obliquity{0.02, 0.0, 0.0, 0.3};
  const ObliqueRestitution on_great = oblique_restitution(great, 0.05, obliquity);
  const ObliqueRestitution on_plane = oblique_restitution(plane, 0.05, obliquity);
  EXPECT_NEAR(on_great.tangential_restitution.value, on_plane.tangential_restitution.value, 2e-2);
  EXPECT_NEAR(on_great.restitution.value, on_plane.restitution.value, 1e-2);
  EXPECT_LT(on_great.tangential_restitution.error, 1e-2);
}

TEST(ObliqueRestitution, TellsWhereFrictionHasNoLimit) {
  const RefinableContact wall(disk(0.33)), same(disk(0.33), disk(0.33));
  const ObliqueRestitution unstable = oblique_restitution(wall, 0.05, {0.2, 0.0, 0.0, 1.6}, {.tolerance = 0.05});
  EXPECT_TRUE(unstable.unstable);
  EXPECT_FALSE(unstable.converged);
  EXPECT_EQ(unstable.sliding_after.error, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(oblique_restitution(same, 0.1, {0.2, 0.0, 0.0, 1.6}, {.tolerance = 0.05}).unstable);
}

// β of a disk in plane stress at a rigid wall is (1 − ν)/2, and that of two kinds their weighted difference.
TEST(ObliqueRestitution, KnowsHowMuchDirectionsMix) {
  const auto along = [](const Contact& contact) { return contacts_along(contact, {}); };
  EXPECT_NEAR(mixing(along(contact(disk(0.33, 8.0)))), 0.335, 1e-6);
  EXPECT_NEAR(stable_friction(along(contact(disk(0.33, 8.0)))), 1.0593, 1e-4);
  EXPECT_EQ(mixing(along(contact(disk(0.33, 8.0), disk(0.33, 8.0)))), 0.0);
  const Contact pair = contact(disk(0.33, 8.0), disk(Disk{0.1, 2.0, 3.0}, 8.0 * 2.0 / std::sqrt(3.0)));
  EXPECT_NEAR(mixing(along(pair)), (0.335 - 0.45 / 3.0) / (1.0 + 1.0 / 3.0), 1e-6);
  EXPECT_EQ(mixing(along(contact(sphere(0.3, 8.0)))), 0.0);
}

/// Contacts in which rings move in one direction.
std::vector<RefinableContact> balls() {
  return {RefinableContact(sphere(0.3)),
          {sphere(0.3), sphere(Sphere{0.1, 2.0, 3.0})},
          {sphere(0.3), half_space(HalfSpace{0.2, 1.5})},
          {sphere(0.3), plate(Plate{.thickness = 1.0, .poisson = 0.3})}};
}

// Equal balls: nothing is left out, so no impact estimates it. Each step of a normal impact is polled once, and once
// more for the motion along the surface.
TEST(ObliqueRestitution, CostsTheStepsThatItSays) {
  const RefinableContact same(sphere(0.3), sphere(0.3));
  for (const double speed : {1e-3, 0.05}) {
    for (const double friction : {0.0, 0.2}) {
      const Obliquity before{speed, 0.0, 0.0, friction};
      (void)oblique_restitution(same, speed, before);  // makes the bodies
      long polls = 0;
      const ObliqueRestitution result = oblique_restitution(same, speed, before, {.poll = [&polls] { ++polls; }});
      long steps = 0, twice = 0;
      for (const ObliqueRun& run : result.runs) {
        steps += run.steps;
        if (friction > 0.0 && std::isfinite(run.sliding_after)) twice += run.steps;
      }
      EXPECT_EQ(result.steps, steps);
      EXPECT_LE(polls, steps + twice + 150 * static_cast<long>(result.runs.size()));  // each has a response along
      EXPECT_GE(polls, steps);
    }
  }
}

TEST(ObliqueRestitution, OfBallsHasTheRestitutionOfCentralImpactsWithinBothErrors) {
  for (const RefinableContact& ball : balls()) {
    for (const double speed : {1e-5, 1e-3, 0.1}) {
      const Restitution central = best_restitution(ball, speed, {});
      for (const double tolerance : {1e-2, 1e-3}) {
        const ObliqueRestitution result =
            oblique_restitution(ball, speed, std::vector{Obliquity{0.4 * speed, 0.0, 0.0, 0.2}},
                                {.tolerance = tolerance})
                .front();
        EXPECT_NEAR(result.restitution.value, central.restitution.value,
                    result.restitution.error + central.restitution.error);
        EXPECT_LE(result.restitution.error,
                  std::max(10.0 * central.restitution.error, 1e-4 * central.lost_fraction.value));
      }
      const ObliqueRestitution smooth = oblique_restitution(ball, speed, Obliquity{0.4 * speed, 0.0, 0.0, 0.0});
      EXPECT_EQ(smooth.restitution.value, central.restitution.value);
      EXPECT_EQ(smooth.restitution.error, central.restitution.error);
      EXPECT_EQ(smooth.steps, central.steps);
      EXPECT_EQ(smooth.runs.size(), central.runs.size());
    }
  }
}

// Some rules are converged after three runs, others need more. All ask for the same points, as none slides fast.
TEST(ObliqueRestitution, OfBallsDoesNotDependOnItsNeighbours) {
  const RefinableContact ball(sphere(0.1), sphere(Sphere{0.45, 3.0, 2.0}));
  constexpr double speed = 0.1;
  std::vector<Obliquity> fan{{0.02, 0.0, 0.0, 0.0}};
  for (const double sliding : {0.1, 0.3, 0.5, 0.8, 1.0}) fan.push_back({sliding * 0.2 * speed, 0.0, 0.0, 0.2});
  const ObliqueOptions options{.tolerance = 2e-4};
  const std::vector<ObliqueRestitution> all = oblique_restitution(ball, speed, fan, options);
  for (std::size_t k = 0; k < fan.size(); ++k) {
    const ObliqueRestitution one = oblique_restitution(ball, speed, fan[k], options);
    EXPECT_EQ(all[k].restitution.value, one.restitution.value);
    EXPECT_EQ(all[k].restitution.error, one.restitution.error);
    EXPECT_EQ(all[k].steps, one.steps);
    EXPECT_EQ(all[k].sliding_after.error, one.sliding_after.error);
  }
}

// Of a vibration all modes are kept in the first run already.
TEST(ObliqueRestitution, BeginsAboveTheModesThatVibrate) {
  const RefinableContact ball(sphere(0.3));
  const Vibration vibration{{.order = 6, .index = 0, .energy = 0.1}};
  const ObliqueRestitution result =
      oblique_restitution(ball, 0.05, Obliquity{0.02, 0.0, 0.0, 0.2}, {.tolerance = 0.05, .vibration = vibration});
  EXPECT_TRUE(std::isfinite(result.restitution.error));
  EXPECT_TRUE(result.converged);
}

}  // namespace
}  // namespace oblique_restitution_tests
}  // namespace stoss
