// Bodies that the library does not know: made here from bare numbers, run through the same engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "stoss/bodies/rod.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"
#include "support/body_tools.hpp"
#include "support/refusal.hpp"
#include "support/runge_kutta.hpp"
#include "support/toy_bodies.hpp"

namespace stoss {
namespace {

TEST(RodBody, HasModesAtMultiplesOfPiAndTheComplianceOfTheOthers) {
  const Body body = rod(100.0);
  ASSERT_EQ(body.groups.size(), 1U);
  ASSERT_EQ(mode_count(body), 31U);
  double kept = 0.0;
  for (std::size_t i = 0; i < 31; ++i) {
    EXPECT_DOUBLE_EQ(body.groups[0].omega[i], (static_cast<double>(i) + 1.0) * std::numbers::pi);
    EXPECT_DOUBLE_EQ(body.groups[0].upper[i], std::numbers::sqrt2);
    kept += 2.0 / (body.groups[0].omega[i] * body.groups[0].omega[i]);
  }
  const ContactGrid grid = test::grid_of(body, 0.0, 1);
  ASSERT_EQ(grid.coordinate.size(), 1U);
  EXPECT_EQ(grid.impedance.front(), 1.0);
  EXPECT_NEAR(body.residual_compliance(grid.points, {}).front(), 1.0 / 3.0 - kept, 1e-15);
  EXPECT_NEAR(body.residual_compliance(grid.points, {}).front(), 2.0 / (std::numbers::pi * 100.0), 1e-4);
  EXPECT_EQ(body.mass, 1.0);
}

TEST(RodBody, RefusesCutoffsOutOfRange) {
  for (const double bad : {3.0, 0.0, -1.0, 1e9, std::nan("")}) {
    test::expect_refusal([&] { (void)rod(bad); }, {"cutoff", "got", "3.14"});
  }
}

class RodInOtherUnits : public ::testing::TestWithParam<test::WallCase> {};

TEST_P(RodInOtherUnits, GivesTheSameImpact) {
  constexpr double length = 2.0, wave_speed = 0.5, line_density = 3.0, time = length / wave_speed, speed = 0.1;
  const Body body = test::rod_in_other_units(length, wave_speed, line_density, 60.0 / time);
  auto [wall, tail] = GetParam();
  double plane = 0.0;  // of a soft wall: where its potential is the unit of energy, here and there another one
  if (auto* soft = std::get_if<ExponentialWall>(&wall)) {
    soft->hardness /= length;
    soft->strength *= line_density * wave_speed * wave_speed * length;
    plane = std::log(soft->strength) / soft->hardness;
  }
  const Impact here = impact(rod(60.0), GetParam().wall, speed, {.resolution = {.step = 0.002, .tail = tail}});
  const Impact there = impact(body, wall, speed * wave_speed, {.resolution = {.step = 0.002 * time, .tail = tail}});
  EXPECT_NEAR(there.restitution, here.restitution, 1e-9);
  EXPECT_NEAR(there.contact_time / time, here.contact_time, 1e-9);
  EXPECT_NEAR((there.max_compression - plane) / length, here.max_compression, 1e-9);
  EXPECT_NEAR(there.max_force * time / wave_speed, here.max_force, 1e-9);  // F/m
  EXPECT_NEAR(there.energy.unresolved, here.energy.unresolved, 1e-9);
  EXPECT_EQ(there.steps, here.steps);
}

INSTANTIATE_TEST_SUITE_P(Walls, RodInOtherUnits, ::testing::ValuesIn(test::every_wall));

/// ε of two masses on a spring at an exponential wall by Runge and Kutta, from far away to far away.
double dumbbell_by_runge_kutta(double mass, double omega, double hardness, double speed) {
  const auto slope = [&](const std::array<double, 4>& y) {  // x, ẋ, Q, Q̇
    const double force = hardness * std::exp(hardness * (y[0] + y[2]));
    return std::array{y[1], -force / mass, y[3], -omega * omega * y[2] - force / mass};
  };
  constexpr double h = 2e-4;
  std::array y{-60.0 / hardness, speed, 0.0, 0.0};
  for (double t = 0.0; t < 3.0 * 60.0 / (hardness * speed); t += h) y = test::runge_kutta_step(y, h, slope);
  return -y[1] / speed;
}

TEST(Dumbbell, AgreesWithRungeKutta) {
  double largest_loss = 0.0;
  for (const double omega : {3.0, 7.0, 20.0}) {
    for (const double speed : {0.1, 0.4}) {
      const Body body = test::dumbbell(2.0, omega);
      const double expected = dumbbell_by_runge_kutta(2.0, omega, 40.0, speed);
      const Impact found =
          impact(body, ExponentialWall{40.0, 1.0}, speed, {.resolution = {.step = 2.5e-4, .tail = Tail::none}});
      EXPECT_NEAR(found.restitution, expected, 2e-6) << "omega " << omega << ", speed " << speed;
      EXPECT_NEAR(found.energy.modes.front().after, 1.0 - expected * expected, 1e-5);
      largest_loss = std::max(largest_loss, 1.0 - expected * expected);
    }
  }
  EXPECT_GT(largest_loss, 0.1);
}

}  // namespace
}  // namespace stoss
