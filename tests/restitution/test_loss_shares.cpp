// Which body absorbs the loss: the shares of a converged value add up to it.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {
namespace {

constexpr double rounding = 1e-15;

struct Meeting {
  std::string name;
  RefinableContact contact;
  double slowest, fastest;
};

void PrintTo(const Meeting& meeting, std::ostream* out) { *out << meeting.name; }

std::vector<Meeting> meetings() {
  const BodyMaker ball = sphere(0.3), lossy_ball = sphere(Sphere{.poisson = -0.4, .loss_time = 3e-3});
  return {{"disk", RefinableContact(disk(0.33)), 1e-6, 0.3},
          {"sphere", RefinableContact(ball), 1e-8, 0.3},
          {"lossy_sphere", RefinableContact(lossy_ball), 1e-5, 0.2},
          {"very_lossy_sphere", RefinableContact(sphere(Sphere{.poisson = 0.3, .loss_time = 1.0})), 1e-5, 0.2},
          {"lossy_disk", RefinableContact(disk(Disk{.poisson = 0.33, .loss_time = 0.05})), 1e-5, 0.2},
          {"two_disks", RefinableContact(disk(0.33), disk(Disk{.poisson = 0.2, .radius = 0.4})), 1e-4, 0.3},
          {"two_spheres", RefinableContact(lossy_ball, sphere(Sphere{.radius = 2.0, .young = 0.5})), 1e-5, 0.2},
          {"near_side", RefinableContact(disk(0.33), disk(Disk{.poisson = 0.33, .radius = 100.0})), 1e-2, 0.2},
          {"half_space", RefinableContact(lossy_ball, half_space(HalfSpace{.poisson = 0.2})), 1e-4, 0.1},
          {"rods", RefinableContact(rod(), rod(Rod{.length = 2.5})), 1e-2, 0.3}};
}

class LossShares : public testing::TestWithParam<Meeting> {};

TEST_P(LossShares, AddUpToTheLoss) {
  const auto& [name, contact, slowest, fastest] = GetParam();
  std::mt19937_64 random(3);
  for (int i = 0; i < 8; ++i) {
    const double speed = slowest * std::pow(fastest / slowest, 0x1p-64 * static_cast<double>(random()));
    const Restitution found = restitution(contact, speed, {.tolerance = 1e-2});
    EXPECT_NEAR(found.lost_to_first + found.lost_to_second, found.lost_fraction.value, rounding) << speed;
    EXPECT_GE(found.lost_to_first, 0.0) << speed;
    EXPECT_GE(found.lost_to_second, 0.0) << speed;
    EXPECT_LE(found.dissipated, found.lost_fraction.value + rounding) << speed;
    // They are those of the finest impact but for what its own 1 − ε² and ledger are off by.
    const Impact& finest = found.finest;
    const double correction =
        std::abs(finest.lost_fraction - found.lost_fraction.value) + std::abs(finest.energy_error) + rounding;
    EXPECT_NEAR(found.lost_to_first, finest.energy.lost_to_first, correction) << speed;
    EXPECT_NEAR(found.lost_to_second, finest.energy.lost_to_second, correction) << speed;
  }
}

INSTANTIATE_TEST_SUITE_P(Restitution, LossShares, testing::ValuesIn(meetings()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(LossSharesOfOne, CloseWhereTheLedgerMissesSevenBars) {
  const Restitution found = restitution(sphere(Sphere{.poisson = -0.40127095, .loss_time = 0.0031246041}), 2.5725e-4);
  EXPECT_GT(std::abs(found.finest.energy.lost_to_first - found.lost_fraction.value), 5.0 * found.lost_fraction.error);
  EXPECT_NEAR(found.lost_to_first, found.lost_fraction.value, rounding);
  EXPECT_EQ(found.lost_to_second, 0.0);
}

TEST(LossSharesOfOne, LeaveARigidBodyAndAWallWithoutAny) {
  const RefinableContact contact(rigid(sphere(0.3)), half_space(HalfSpace{.poisson = 0.3}));
  const Restitution block = restitution(contact, 0.01), wall = restitution(sphere(0.3), 0.01);
  EXPECT_EQ(block.lost_to_first, 0.0);
  EXPECT_NEAR(block.lost_to_second, block.lost_fraction.value, rounding);
  EXPECT_EQ(wall.lost_to_second, 0.0);
  EXPECT_EQ(wall.dissipated, 0.0);
}

TEST(LossSharesOfOne, OfVibratingBodiesAreAllEnergyButThatOfTheTranslation) {
  constexpr double vibration = 0.3;
  const RefinableContact contact(disk(0.33), disk(Disk{.poisson = 0.2, .radius = 2.0}));
  const Restitution found =
      restitution(contact, 0.1, {.tolerance = 1e-15, .absolute = 1e-3, .vibration = {{0, 2, 0, vibration, 1.0}}});
  const double epsilon = found.restitution.value;
  EXPECT_NEAR(found.lost_to_first + found.lost_to_second + epsilon * epsilon / (1.0 + vibration), 1.0, 1e-12);
}

}  // namespace
}  // namespace stoss
