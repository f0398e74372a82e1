// Steps and grids that an impact chooses for itself, and those that it refuses.
#include <gtest/gtest.h>

#include <cmath>

#include "impact/recommended.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/impact/impact.hpp"
#include "support/body_tools.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

TEST(Resolution, DefaultNodesSufficeAtAHighCutoff) {
  const Body body = disk(0.33, 300.0);
  const Impact chosen = impact(body, HardWall{}, 0.1, {.resolution = {.step = 2e-3}});
  const Impact finer =
      impact(body, HardWall{}, 0.1, {.resolution = {.step = 2e-3, .nodes = 2 * chosen.resolution.nodes}});
  EXPECT_GT(chosen.resolution.nodes, 64);
  EXPECT_NEAR(chosen.lost_fraction, finer.lost_fraction, 2e-5);
}

TEST(Resolution, ABodySaysHowManyPointsItNeeds) {
  const Body usual = disk(0.33, 25.0);
  Body fine = usual;
  fine.sampling = {.points = 100.0, .cutoff = 10.0, .power = 1.0, .along_edge = 0.0, .fewest = 300};
  EXPECT_EQ(fixed_resolution(contact(fine), 0.1).nodes, 300);
  EXPECT_EQ(refined_resolution(contact(fine), 0.1, 0.1).nodes, 256);  // 100 · 2.5, in eights
  fine.sampling.along_edge = 40.0;
  EXPECT_EQ(refined_resolution(contact(fine), 0.1, 0.25).nodes, 504);  // 40 · 25 · √¼
}

TEST(Resolution, OfAPairTheBodyThatAsksForMorePointsDecides) {
  const Body usual = disk(0.33, 25.0);
  Body fine = usual;
  fine.sampling = {.points = 100.0, .cutoff = 10.0, .power = 1.0, .along_edge = 0.0, .fewest = 300};
  for (const Contact& pair : {contact(fine, usual), contact(usual, fine)}) {
    EXPECT_EQ(fixed_resolution(pair, 0.2).nodes, 300);
    EXPECT_EQ(refined_resolution(pair, 0.2, 0.1).nodes, 256);
  }
}

TEST(Resolution, RefusesNodesThatAliasTheKeptModes) {
  const Body body = disk(0.33, 400.0);
  test::expect_refusal([&] { (void)impact(body, HardWall{}, 0.1, {.resolution = {.nodes = 64}}); }, {"nodes", "64"});
}

TEST(Resolution, RefusesNonsense) {
  const Body body = disk(0.33, 12.5);
  test::expect_refusal([&] { (void)fixed_resolution(contact(body, HardWall{}), std::nan("")); }, {"speed", "nan"});
  test::expect_refusal(
      [&] {
        (void)fixed_resolution(contact(body, ExponentialWall{-5.0, 1.0}), 0.1).nodes;
      },
      {"hardness", "-5"});
  test::expect_refusal([&] { (void)test::grid_of(body, std::nan(""), 32); }, {"half_width", "nan"});
  test::expect_refusal([&] { (void)test::grid_of(body, 1e-4, 1'000'000); }, {"nodes"});
  EXPECT_TRUE(body.residual_compliance(ContactPoints{1.0, 0.1, 0}, {}).empty());
  EXPECT_TRUE(body.residual_second_moment(ContactPoints{1.0, 0.1, 0}, {}).empty());
  test::expect_refusal([&] { (void)impact(body, HardWall{}, 0.1, {.resolution = {.half_width = 4.0}}); },
                       {"half_width", "4"});
  test::expect_refusal([&] { (void)impact(body, HardWall{}, 0.1, {.resolution = {.half_width = std::nan("")}}); },
                       {"half_width"});
}

TEST(Resolution, MotionThatLosesItsEnergyIsNotConverged) {
  const Body body = disk(0.95, 50.0);
  const auto coarse = [&] {
    (void)impact(body, HardWall{}, 0.4, {.resolution = {.step = 0.02, .tail = Tail::quasistatic}});
  };
  EXPECT_NE(test::message_of<NotConverged>(coarse).find("smaller step"), std::string::npos);
}

TEST(Resolution, ASoftWallMayActOnTheWholeFrontOfTheDisk) {
  const Impact soft = impact(disk(0.33, 12.5), ExponentialWall{5.0, 1.0}, 0.1, {.resolution = {.tail = Tail::none}});
  EXPECT_NEAR(soft.restitution, 1.0, 1e-3);
  EXPECT_NEAR(soft.energy_error, 0.0, 1e-8);
}

TEST(Resolution, ASlowImpactOnASoftWallIsOneContact) {
  const Impact slow = impact(disk(0.33, 12.5), ExponentialWall{500.0, 1.0}, 1e-5);
  EXPECT_EQ(slow.contacts, 1);
  EXPECT_GT(slow.contact_time, 0.0);
  EXPECT_NEAR(slow.restitution, 1.0, 1e-9);
}

}  // namespace
}  // namespace stoss
