// The paper's static calculation, modes at an exponential wall: against a minimisation over the modes themselves, the
// limits of a hard wall and of all modes, and an impact so slow that it is nearly static.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/quasistatic.hpp"
#include "support/contact_problem.hpp"
#include "support/refusal.hpp"

namespace stoss {
using namespace bodies::disk;
using namespace quasistatic;

namespace {

using std::numbers::pi;

struct Minimum {
  double force = 0.0, energy = 0.0;
};

/// Newton's method over the coordinates of all modes of a disk, with the wall's integral by the trapezoidal rule.
Minimum by_modes(double poisson, double cutoff, const ExponentialWall& wall, double compression) {
  const std::vector<Mode> modes = bodies::disk::modes(poisson, cutoff);
  const double center = compression - 1.0 - std::log(wall.strength) / wall.hardness;
  constexpr int points = 600;
  const double h = pi / points;
  std::vector<double> coordinate(modes.size(), 0.0);
  Minimum minimum;
  for (int step = 0; step < 100; ++step) {
    std::vector<long double> hessian(modes.size() * modes.size(), 0.0L), gradient(modes.size());
    minimum = {};
    for (std::size_t k = 0; k < modes.size(); ++k) {
      const double stiffness = pi * modes[k].omega * modes[k].omega;
      hessian[k * modes.size() + k] = stiffness;
      gradient[k] = -stiffness * coordinate[k];
      minimum.energy += 0.5 * stiffness * coordinate[k] * coordinate[k] / pi;
    }
    std::vector<double> shape(modes.size());
    for (int i = 0; i <= points; ++i) {
      const double phi = -0.5 * pi + i * h;
      double x = center + std::cos(phi);
      for (std::size_t k = 0; k < modes.size(); ++k) {
        const double angle = modes[k].order * phi;
        shape[k] =
            modes[k].radial * std::cos(angle) * std::cos(phi) - modes[k].tangential * std::sin(angle) * std::sin(phi);
        x += coordinate[k] * shape[k];
      }
      const double weight = (i == 0 || i == points ? 0.5 : 1.0) * h;
      const double potential = weight * wall.strength * std::exp(wall.hardness * x);
      const double force = wall.hardness * potential;
      minimum.energy += potential / pi;
      minimum.force += force / pi;
      for (std::size_t k = 0; k < modes.size(); ++k) {
        gradient[k] -= force * shape[k];
        for (std::size_t j = 0; j < modes.size(); ++j) {
          hessian[k * modes.size() + j] += wall.hardness * force * shape[k] * shape[j];
        }
      }
    }
    const std::vector<long double> direction = test::gauss(hessian, gradient);
    for (std::size_t k = 0; k < modes.size(); ++k) coordinate[k] += static_cast<double>(direction[k]);
    const auto largest = *std::max_element(direction.begin(), direction.end());
    if (std::abs(largest) < 1e-16L && std::abs(*std::min_element(direction.begin(), direction.end())) < 1e-16L) break;
  }
  return minimum;
}

TEST(QuasistaticSoftContact, IsTheMinimumOverTheModes) {
  for (const double cutoff : {3.0, 5.0}) {
    for (const ExponentialWall wall : {ExponentialWall{30.0, 1.0}, ExponentialWall{500.0, 0.01}}) {
      for (const double delta : {-0.03, 0.0, 0.04}) {
        const Minimum expected = by_modes(0.33, cutoff, wall, delta);
        const SoftStaticContact found = soft_static_contact(disk(0.33, cutoff), wall, delta);
        EXPECT_NEAR(found.force, expected.force, 1e-10 * expected.force) << cutoff << " " << delta;
        EXPECT_NEAR(found.energy, expected.energy, 1e-10 * expected.energy) << cutoff << " " << delta;
        EXPECT_NEAR(found.wall_energy, found.force / wall.hardness, 1e-11 * found.wall_energy);
      }
    }
  }
}

TEST(QuasistaticSoftContact, ActsOnTheFrontHalfOfTheDisk) {
  // The rules of both sides stop at ±π/2, where the pressure of a soft wall does not vanish: they differ by O(h²).
  for (const double hardness : {1.0, 3.0, 10.0}) {
    const ExponentialWall wall{hardness, 0.01};
    const double expected = by_modes(0.33, 3.0, wall, -0.4).force;
    EXPECT_NEAR(soft_static_contact(disk(0.33, 3.0), wall, -0.4).force, expected, 2e-5 * expected) << hardness;
  }
}

TEST(QuasistaticSoftContact, StrengthOnlyMovesTheWall) {
  const Body body = disk(0.33, 12.5);
  const SoftStaticContact one = soft_static_contact(body, {500.0, 1.0}, 0.03);
  const SoftStaticContact other = soft_static_contact(body, {500.0, 1e-3}, 0.03);
  EXPECT_EQ(one.force, other.force);
  EXPECT_EQ(one.energy, other.energy);
}

TEST(QuasistaticSoftContact, ForceIsTheDerivativeOfTheEnergy) {
  const Body body = disk(0.33, 25.0);
  for (const double hardness : {50.0, 500.0, 1e4}) {
    for (const double delta : {-0.01, 0.0, 0.02, 0.1}) {
      const double h = 0.2 / hardness;
      const auto energy = [&](double k) { return soft_static_contact(body, {hardness}, delta + k * h).energy; };
      const double slope =
          (45.0 * (energy(1) - energy(-1)) - 9.0 * (energy(2) - energy(-2)) + (energy(3) - energy(-3))) / (60.0 * h);
      const double force = soft_static_contact(body, {hardness}, delta).force;
      EXPECT_NEAR(slope, force, 2e-5 * force) << hardness << " " << delta;
    }
  }
}

TEST(QuasistaticSoftContact, DoesNotDependOnTheNodes) {
  const Body body = disk(0.33, 54.1);
  for (const double hardness : {50.0, 500.0, 5000.0}) {
    for (const double delta : {0.0, 0.03, 0.2}) {
      const SoftStaticContact usual = soft_static_contact(body, {hardness}, delta);
      const SoftStaticContact finer = soft_static_contact(body, {hardness}, delta, {.nodes = 2 * usual.nodes});
      EXPECT_NEAR(usual.force / finer.force, 1.0, 1e-10) << hardness << " " << delta;
      EXPECT_EQ(usual.modes, static_cast<int>(mode_count(body)));
    }
  }
}

/// At a wall on which a pressure 0.1 stands at the given compression, for which a harder one differs by 1/α only.
double soft_force(double cutoff, double hardness, double delta) {
  const double plane = std::log(0.1 / hardness) / hardness;
  return soft_static_contact(disk(0.33, cutoff), {hardness}, delta + plane).force;
}

TEST(QuasistaticSoftContact, TendsToTheHardWallWithAllModes) {
  for (const double delta : {0.03, 0.1}) {
    const double exact = static_contact(0.33, delta).force;
    const auto hard = [&](double cutoff) {
      return 2.0 * soft_force(cutoff, 8000.0, delta) - soft_force(cutoff, 4000.0, delta);
    };
    const double coarse = hard(50.0), fine = hard(100.0);
    EXPECT_GT(coarse / exact - 1.0, 1.5 * (fine / exact - 1.0));  // like 1/cutoff
    EXPECT_GT(fine, exact);                                       // fewer modes are stiffer
    EXPECT_NEAR((2.0 * fine - coarse) / exact, 1.0, 2e-3) << delta;
  }
}

TEST(QuasistaticSoftContact, IsWhatASlowImpactComesTo) {
  const Body body = disk(0.33, 12.5);
  double deepest = -2.0, force = 0.0;
  const ImpactObserver observer = [&](const Snapshot& now) {
    if (now.center > deepest) {
      deepest = now.center;
      force = now.force;
    }
  };
  (void)impact(body, ExponentialWall{}, 0.003, {}, {observer});
  const SoftStaticContact at_rest = soft_static_contact(body, ExponentialWall{}, deepest + 1.0);
  EXPECT_LT(deepest, -1.0);  // not yet at the plane V = 1
  EXPECT_NEAR(force / at_rest.force, 1.0, 0.1);
}

TEST(QuasistaticSoftContact, RodIsASpring) {
  // One node: F = αV e^{α(δ − WF)} with W = Σ 2/(lπ)².
  const SoftStaticContact contact = soft_static_contact(rod(50.0), {500.0}, 0.05);
  double compliance = 0.0;
  for (int l = 1; l * pi <= 50.0; ++l) compliance += 2.0 / (l * pi * l * pi);
  EXPECT_NEAR(contact.force, 500.0 * std::exp(500.0 * (0.05 - compliance * contact.force)), 1e-9 * contact.force);
}

TEST(QuasistaticSoftContact, RefusesWhatItIsNotMeantFor) {
  const Body body = disk(0.33, 5.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {-0.51, 0.51, nan}) {
    test::expect_refusal([&] { (void)soft_static_contact(body, {}, wrong); }, {"compression", "-0.5 to 0.5"});
    test::expect_refusal([&] { (void)soft_static_contact(rod(50.0), {}, wrong); }, {"compression", "-0.5 to 0.5"});
  }
  test::expect_refusal([&] { (void)soft_static_contact(body, {0.5}, 0.01); }, {"hardness"});
  test::expect_refusal([&] { (void)soft_static_contact(body, {}, 0.01, {.nodes = 63}); }, {"nodes", "64 to 2048"});
  test::expect_refusal([&] { (void)soft_static_contact(Body{}, {}, 0.01); }, {"body"});
}

}  // namespace
}  // namespace stoss
