// What the coupling that rings leave out may change.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/oblique.hpp"

namespace stoss {
namespace neglected_coupling {
namespace {

void expect_none(const Coupling& coupling) {
  for (const double each : {coupling.dundurs, coupling.restitution, coupling.sliding_after, coupling.tangential_after,
                            coupling.tangential_restitution, coupling.spin_after, coupling.second_spin_after}) {
    EXPECT_EQ(each, 0.0);
  }
}

std::vector<ObliqueRestitution> rules(const RefinableContact& contact, double speed,
                                      const std::vector<Obliquity>& before) {
  return oblique_restitution(contact, speed, before, {.tolerance = 0.1});
}

TEST(NeglectedCoupling, IsNothingForEqualBodiesDisksAndSmoothOnes) {
  const Sphere small{.poisson = 0.3, .radius = 0.7, .young = 2.0};
  expect_none(rules({sphere(small), sphere(small)}, 0.01, {{0.01, 0.0, 0.0, 0.3}}).front().neglected);
  expect_none(rules(RefinableContact(sphere(0.3)), 0.01, {{0.01, 0.0, 0.0, 0.0}}).front().neglected);
  expect_none(rules(RefinableContact(disk(0.3)), 0.1, {{0.1, 0.0, 0.0, 0.3}}).front().neglected);
}

// Of disks it is computed, docs/results/oblique/coupling.csv: at a rigid wall minus between equal ones, β = 0.335.
TEST(NeglectedCoupling, IsLikeThatOfDisks) {
  constexpr double beta = 0.335, speed = 0.003;
  const double poisson = (1.0 - 2.0 * beta) / (2.0 - 2.0 * beta), kappa = 2.0 * (1.0 - poisson) / (2.0 - poisson);
  const RefinableContact wall(sphere(poisson));
  struct Row {
    double share, near, middle, far;  // μ/β; at x = 0.25, 1, 3
  };
  for (const Row& disk : {Row{0.1, 0.66, 0.36, -0.07}, Row{0.2, 0.62, 0.36, 0.01}, Row{0.5, 0.34, 0.16, -0.00},
                          Row{1.0, 0.13, 0.07, -0.01}, Row{2.0, 0.03, 0.01, -0.03}}) {
    const double friction = disk.share * beta;
    const auto along = [&](double x) { return Obliquity{x * friction * speed / kappa, 0.0, 0.0, friction}; };
    const auto added = rules(wall, speed, {along(0.25), along(1.0), along(3.0), along(10.0)});
    EXPECT_NEAR(added[0].neglected.tangential_restitution, disk.near, 0.15) << disk.share;
    EXPECT_NEAR(added[1].neglected.tangential_restitution, disk.middle, 0.08) << disk.share;
    EXPECT_NEAR(added[2].neglected.tangential_restitution, disk.far, 0.06) << disk.share;
    EXPECT_NEAR(added[3].neglected.tangential_restitution, 0.0, 0.01) << disk.share;
    EXPECT_NEAR(added[0].neglected.dundurs, beta, 1e-9);
  }
}

TEST(NeglectedCoupling, OfTheNormalIsThatOfAFinerImpact) {
  const RefinableContact wall(sphere(0.3));
  const auto rule = [&](double speed, double friction) {
    return rules(wall, speed, {{0.1 * speed, 0.0, 0.0, friction}}).front().neglected.restitution;
  };
  EXPECT_NEAR(rule(1e-3, 0.1), 0.998116 - 0.999879, 1e-4);
  EXPECT_NEAR(rule(0.1, 0.1), 0.991346 - 0.991231, 5e-5);
  EXPECT_NEAR(rule(0.1, 1.0), 0.992000 - 0.991231, 1e-4);
}

TEST(NeglectedCoupling, IsThatOfTheVelocities) {
  const RefinableContact pair(sphere(Sphere{0.1}), sphere(Sphere{.poisson = 0.4, .radius = 2.0}));
  const Obliquity before{0.002, 0.001, -0.0005, 0.2}, back{-0.002, -0.001, 0.0005, 0.2}, standing{0.0, 0.0, 0.0, 0.2};
  const auto results = rules(pair, 0.01, {before, back, standing});
  const Coupling &there = results[0].neglected, &mirrored = results[1].neglected, &none = results[2].neglected;
  EXPECT_NEAR(there.sliding_after, there.tangential_after + there.spin_after + 2.0 * there.second_spin_after, 1e-15);
  EXPECT_NEAR(there.tangential_restitution, -there.sliding_after / results[0].sliding, 1e-12);
  EXPECT_NE(there.sliding_after, 0.0);
  EXPECT_NEAR(mirrored.sliding_after, -there.sliding_after, 1e-9);
  EXPECT_EQ(mirrored.restitution, there.restitution);
  EXPECT_EQ(none.restitution, there.restitution);
  EXPECT_EQ(none.sliding_after, 0.0);
  EXPECT_EQ(none.tangential_restitution, 0.0);
}

// Momentum: what friction takes of v_t it gives to the spin, with an arm a little shorter than R.
TEST(NeglectedCoupling, KeepsTheMomentum) {
  const RefinableContact stone(sphere(0.25), half_space(HalfSpace{.poisson = 0.25, .young = 0.2}));
  const Coupling added = rules(stone, 1e-3, {{2e-4, 0.0, 0.0, 0.1}}).front().neglected;
  EXPECT_NE(added.tangential_after, 0.0);
  EXPECT_NEAR(added.spin_after, 2.5 * added.tangential_after, 0.02 * std::abs(added.spin_after));
  EXPECT_EQ(added.second_spin_after, 0.0);
  EXPECT_NEAR(added.dundurs, (0.2 - 1.0) / 1.2 * -1.0 / 3.0, 1e-9);
}

// A rigid sphere of any size is a wall but for its curvature.
TEST(NeglectedCoupling, IsThatOfAWallOnARigidSphere) {
  const Obliquity before{2e-4, 0.0, 0.0, 0.1};
  const Coupling wall = rules(RefinableContact(sphere(0.3)), 2e-3, {before}).front().neglected;
  const Coupling rigid_one =
      rules({sphere(0.3), rigid(sphere(Sphere{.poisson = 0.1, .radius = 20.0}))}, 2e-3, {before}).front().neglected;
  EXPECT_NEAR(rigid_one.dundurs, wall.dundurs, 1e-12);
  EXPECT_NEAR(rigid_one.restitution, wall.restitution, 0.1 * std::abs(wall.restitution));
  EXPECT_NEAR(rigid_one.tangential_restitution, wall.tangential_restitution, 0.05);
}

// Where friction is so high that waves grow, a rigid disk is no better than a wall.
TEST(NeglectedCoupling, OfARigidBodyIsThatOfAWall) {
  const Obliquity before{0.1, 0.0, 0.0, 3.0};
  EXPECT_TRUE(rules(RefinableContact(disk(0.3)), 0.1, {before}).front().unstable);
  EXPECT_TRUE(rules({disk(0.3), rigid(disk(0.3))}, 0.1, {before}).front().unstable);
}

}  // namespace
}  // namespace neglected_coupling
}  // namespace stoss
