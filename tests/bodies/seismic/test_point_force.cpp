// A point force that lasts on a half-space, against closed forms.
#include "bodies/half_space/point_force.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bodies/half_space/lasting_force.hpp"

namespace stoss::bodies::half_space {
namespace {

constexpr double pi = std::numbers::pi;

/// C. L. Pekeris, Proc. Natl. Acad. Sci. 41, 469 (1955): πμr/F times the displacement into the depth at ν = ¼.
double of_pekeris(double time) {
  const double root = std::sqrt(3.0), square = time * time, pole = 0.75 + 0.25 * root;
  if (time < 1.0 / root) return 0.0;
  const double first = root / std::sqrt(square - 0.25);
  const double second = std::sqrt(3.0 * root + 5.0) / std::sqrt(std::abs(pole - square));
  const double third = std::sqrt(3.0 * root - 5.0) / std::sqrt(square + 0.25 * root - 0.75);
  if (time < 1.0) return (6.0 - first - second + third) / 32.0;
  return square < pole ? (6.0 - second) / 16.0 : 3.0 / 8.0;
}

TEST(PointForce, IsOfPekerisOnTheSurface) {
  const PointForce force(0.25, 2.0, 0.0);
  for (const double time : {0.58, 0.7, 0.9, 0.99, 1.001, 1.02, 1.05, 1.08, 1.0876, 1.2, 3.0, 100.0}) {
    EXPECT_NEAR(pi * 2.0 * force.at(2.0 * time).normal, of_pekeris(time), 1e-8 * (1.0 + std::abs(of_pekeris(time))))
        << time;
  }
  EXPECT_EQ(force.at(2.0 * 0.57).normal, 0.0);
}

TEST(PointForce, EndsInTheStaticAnswer) {
  for (const double nu : {-0.3, 0.0, 0.25, 0.3, 0.45}) {
    for (const double depth : {0.0, 0.01, 0.3, 1.0, 5.0}) {
      const PointForce force(nu, 1.0, depth);
      const Displaced late = force.at(1e5), rest = force.at_rest();
      EXPECT_NEAR(late.normal, rest.normal, 1e-7 * rest.normal) << nu << " " << depth;
      EXPECT_NEAR(late.radial, rest.radial, 1e-7 * rest.normal) << nu << " " << depth;
    }
  }
}

TEST(PointForce, GoesOverToTheSurface) {
  const PointForce surface(0.3, 1.0, 0.0);
  double before = 1.0;
  for (const double depth : {1e-2, 1e-3, 1e-4}) {
    const PointForce inside(0.3, 1.0, depth);
    double apart = 0.0;
    for (const double time : {0.6, 0.7, 0.8, 0.9, 0.98, 1.02, 1.2, 1.6, 4.0, 20.0}) {
      const Displaced in = inside.at(time), on = surface.at(time);
      apart = std::max({apart, std::abs(in.normal - on.normal), std::abs(in.radial - on.radial)});
    }
    EXPECT_LT(apart, 0.15 * before) << depth;  // of the first order in the depth
    before = apart;
  }
  EXPECT_LT(before, 2e-4);
}

TEST(PointForce, ReachesTheAxisAsAPressureWave) {
  const PointForce force(0.25, 0.0, 1.0);
  const double arrival = 1.0 / std::sqrt(3.0);
  EXPECT_EQ(force.at(0.999 * arrival).normal, 0.0);
  // The jump of the first wave straight below: 1/(2πR ρc_p²) times 2 of the free surface, here μ = ρ = 1.
  EXPECT_NEAR(force.at(arrival * (1.0 + 1e-9)).normal, 1.0 / (2.0 * pi * 3.0), 1e-6);
  EXPECT_EQ(force.at(2.0).radial, 0.0);
}

TEST(PointForce, KeepsItsSizeIfAllLengthsAndTimesGrow) {
  const PointForce one(0.3, 1.0, 0.4), ten(0.3, 10.0, 4.0);
  for (const double time : {0.7, 1.0, 1.1, 1.3, 3.0}) {
    EXPECT_NEAR(ten.at(10.0 * time).normal, 0.1 * one.at(time).normal, 1e-9);
    EXPECT_NEAR(ten.at(10.0 * time).radial, 0.1 * one.at(time).radial, 1e-9);
  }
}

TEST(LastingForce, IsTheIntegralOfIt) {
  for (const double depth : {0.0, 0.001, 0.1, 1.0}) {
    const PointForce force(0.3, 1.0, depth);
    const LastingForce lasting(force, 6.0, {});
    constexpr std::size_t count = 6000;
    const auto steps = lasting.over_steps(1e-3, count), three = lasting.over_steps(3e-3, count / 3);
    for (std::size_t i = 0; i < three.size(); ++i) {
      EXPECT_NEAR(steps[3 * i].whole.normal + steps[3 * i + 1].whole.normal + steps[3 * i + 2].whole.normal,
                  three[i].whole.normal, 1e-12);
      // The moment about the middle of three.
      const double sides = 1e-3 * (steps[3 * i + 2].whole.normal - steps[3 * i].whole.normal);
      const double own =
          steps[3 * i].moment.normal + steps[3 * i + 1].moment.normal + steps[3 * i + 2].moment.normal + sides;
      EXPECT_NEAR(three[i].moment.normal, own, 2e-7 * 1e-3) << depth << " " << i;
    }
    for (const double time : {0.8, 0.95, 1.2, 2.0, 5.0}) {  // where it is smooth
      const auto i = static_cast<std::size_t>(time / 1e-3);
      const double middle = (static_cast<double>(i) + 0.5) * 1e-3;
      EXPECT_NEAR(steps[i].whole.normal / 1e-3, force.at(middle).normal, 2e-6) << depth << " " << time;
      EXPECT_NEAR(steps[i].whole.radial / 1e-3, force.at(middle).radial, 2e-6) << depth << " " << time;
    }
  }
}

}  // namespace
}  // namespace stoss::bodies::half_space
