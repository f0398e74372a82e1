// The static contact of a sphere with a hard wall: convergence, books, and the laws of compression.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>

#include "stoss/quasistatic/compression.hpp"
#include "stoss/quasistatic/static_contact.hpp"
#include "support/refusal.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

using std::numbers::pi;

TEST(PointStaticContact, TellsHowGoodTheLawsAre) {
  struct Deviation {
    double compression, center, hertz;  // of δ at the force from the laws
  };
  for (const auto& at : {Deviation{1e-4, 2.0e-5, -5.08e-3}, {1e-3, 2.29e-4, -1.779e-2}, {1e-2, 2.69e-3, -6.165e-2}}) {
    const StaticContact contact = static_contact(Sphere{0.3}, at.compression, {.nodes = 80});
    const auto deviation = [&](PointLaw law) { return at.compression / compression(law, 0.3, contact.force) - 1.0; };
    EXPECT_NEAR(deviation(PointLaw::center), at.center, 1e-5) << at.compression;
    EXPECT_NEAR(deviation(PointLaw::hertz), at.hertz, 2e-5) << at.compression;
    EXPECT_NEAR(contact.half_width / contact_radius(PointLaw::hertz, 0.3, contact.force), 1.0,
                5e-4 + 0.6 * at.compression);
  }
}

TEST(PointStaticContact, LawOfTheCentreIsItsLimitForAllPoissonNumbers) {
  // What the law leaves out is of the order δ of its compression; the nodes are good for 2e-5.
  for (const double nu : {-0.5, 0.0, 0.2, 0.45, 0.49}) {
    const auto deviation = [&](PointLaw law, double delta) {
      const double force = static_contact(Sphere{nu}, delta, {.nodes = 64}).force;
      return std::abs(delta / compression(law, nu, force) - 1.0);
    };
    const double at_100 = deviation(PointLaw::center, 1e-2), at_1000 = deviation(PointLaw::center, 1e-3);
    EXPECT_LT(at_100, 1e-2) << nu;
    EXPECT_LT(at_1000, 0.15 * at_100 + 2e-5) << nu;
    EXPECT_LT(deviation(PointLaw::center, 1e-4), 0.15 * at_1000 + 2e-5) << nu;
    EXPECT_GT(deviation(PointLaw::hertz, 1e-4), 1e-3) << nu;
  }
}

TEST(PointStaticContact, ConvergesWithTheSquareOfTheNodes) {
  for (const double delta : {0.01, 0.1}) {
    const double best = static_contact(Sphere{0.3}, delta, {.nodes = 320}).force;
    const auto error = [&](int nodes) {
      const StaticContact contact = static_contact(Sphere{0.3}, delta, {.nodes = nodes});
      EXPECT_LT(std::abs(contact.force - best), contact.force_error) << nodes;
      return std::abs(contact.force / best - 1.0);
    };
    (void)error(20);
    EXPECT_NEAR(std::log2(error(40) / error(80)), 2.0, 0.35) << delta;
    EXPECT_LT(error(160), 4e-6);
  }
}

TEST(PointStaticContact, SatisfiesTheConditionsAndTheBooks) {
  for (const double delta : {1e-3, 0.1}) {
    const StaticContact contact = static_contact(Sphere{0.3}, delta, {.nodes = 64});
    const double h = contact.spacing;
    double load = 0.0;
    for (std::size_t i = 0; i < contact.position.size(); ++i) {
      EXPECT_GE(contact.pressure[i], 0.0);
      const double inner = contact.position[i] - 0.5 * h;
      load += 2.0 * pi * (std::cos(inner) - std::cos(inner + h)) * contact.pressure[i];
    }
    EXPECT_NEAR(load / (4.0 * pi / 3.0 * contact.force), 1.0, 1e-9);
    EXPECT_EQ(contact.poisson, 0.3);
    EXPECT_EQ(contact.compression, delta);
    const auto energy = [&](double factor) {
      return static_contact(Sphere{0.3}, factor * delta, {.nodes = 64}).energy;
    };
    const double slope = (energy(1.02) - energy(0.98)) / (0.04 * delta);
    EXPECT_NEAR(slope / contact.force, 1.0, 3e-4) << delta;
  }
}

TEST(PointStaticContact, RefusesWhatItIsNotMeantFor) {
  test::expect_refusal([] { (void)static_contact(Sphere{0.3}, 0.0); }, {"compression", "1e-12 to 0.5"});
  test::expect_refusal([] { (void)static_contact(Sphere{0.5}, 0.01); }, {"poisson: got 0.5"});
  test::expect_refusal([] { (void)static_contact(Sphere{0.3}, 0.01, {.nodes = 15}); }, {"nodes", "16 to 1024"});
}

}  // namespace
}  // namespace stoss
