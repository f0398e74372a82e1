// Hollow spheres of lossy materials: without a hole those of the sphere, elastic far from their times, slow ones Ting's
// law, and the energy of all.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "stoss/bodies/hollow_sphere.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "stoss/quasistatic/relaxing_impact.hpp"
#include "stoss/relaxation/constant_quality.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {
namespace {

constexpr double poisson = 0.3, softness = 1.0 - poisson * poisson;

BodyMaker shell(double inner, double loss_time = 0.0) {
  return hollow_sphere({.poisson = poisson, .inner = inner, .loss_time = loss_time});
}

BodyMaker relaxing_shell(double inner, const Relaxation& relaxation) { return relaxing(shell(inner), relaxation); }

double mass_of(double inner) { return 4.0 * std::numbers::pi / 3.0 * (1.0 - inner * inner * inner); }

/// All of the energy, and that the material took some of it.
void expect_closed(const Restitution& result) {
  const Impact& its = result.finest;
  const EnergyLedger& ledger = its.energy;
  EXPECT_GT(ledger.dissipated, 0.0);
  EXPECT_LT(std::abs(its.energy_error), 2e-4);
  EXPECT_NEAR(its.lost_fraction, ledger.vibration + ledger.dissipated + ledger.unresolved + ledger.stored, 2e-4);
}

}  // namespace

TEST(LossyHollowSpheres, WithoutAHoleAreSpheres) {
  const double inner = 0.02;  // what it changes is its volume, 8e-6
  const Relaxation terms{{{0.4, 0.5}, {0.2, 5.0}}};
  for (const double speed : {1e-3, 0.05}) {
    const Restitution relaxes = restitution(relaxing_shell(inner, terms), speed),
                      solid = restitution(relaxing(sphere(Sphere{poisson}), terms), speed);
    EXPECT_NEAR(relaxes.lost_fraction.value / solid.lost_fraction.value, 1.0, 1e-4) << speed;
    EXPECT_NEAR(relaxes.dissipated / solid.dissipated, 1.0, 1e-4) << speed;
    const Restitution lossy = restitution(shell(inner, 0.03), speed),
                      whole = restitution(sphere(Sphere{.poisson = poisson, .loss_time = 0.03}), speed);
    EXPECT_NEAR(lossy.lost_fraction.value / whole.lost_fraction.value, 1.0, 1e-4) << speed;
    EXPECT_NEAR(lossy.dissipated / whole.dissipated, 1.0, 1e-4) << speed;
  }
}

TEST(LossyHollowSpheres, LoseNoEnergyUnseen) {
  for (const double inner : {0.5, 0.8, 0.95}) {
    for (const double speed : {1e-4, 1e-2}) {
      expect_closed(restitution(relaxing_shell(inner, {{{0.3, 5.0}}}), speed, {.tolerance = 1e-2}));
      expect_closed(restitution(relaxing_shell(inner, constant_quality(50.0, lowest_of_body, highest_of_body)), speed,
                                {.tolerance = 1e-2}));
      expect_closed(restitution(shell(inner, 0.02), speed, {.tolerance = 1e-2}));
    }
  }
}

// What relaxes far more slowly than an impact is elastic with E(0), what relaxes far faster is so with E∞: as fast at
// √(E∞/E(0)) of the speed.
TEST(LossyHollowSpheres, AreElasticFarFromTheirTimes) {
  for (const double inner : {0.7, 0.9}) {
    const Restitution elastic = restitution(shell(inner), 0.01);
    const Restitution slow = restitution(relaxing_shell(inner, {{{0.5, 1e6}}}), 0.01);
    EXPECT_NEAR(slow.lost_fraction.value, elastic.lost_fraction.value,
                slow.lost_fraction.error + elastic.lost_fraction.error + 2e-5);
    const Restitution fast = restitution(relaxing_shell(inner, {{{0.5, 1e-6}}}), 0.01 * std::sqrt(0.5));
    EXPECT_NEAR(fast.lost_fraction.value, elastic.lost_fraction.value,
                fast.lost_fraction.error + elastic.lost_fraction.error + 2e-5);
  }
}

// What little damping takes grows in proportion to it. (What rings is lost with and without it.)
TEST(LossyHollowSpheres, LoseInProportionToALittleDamping) {
  constexpr double speed = 3e-3, curved = 0.02;
  const auto expect_in_proportion = [](const Estimate& none, const Estimate& one, const Estimate& two) {
    const double more = two.value - none.value;
    EXPECT_GT(one.value - none.value, 20.0 * (one.error + none.error));
    EXPECT_NEAR(more, 2.0 * (one.value - none.value), two.error + 2.0 * one.error + none.error + curved * more);
  };
  for (const double inner : {0.7, 0.9}) {
    const auto lost = [](const BodyMaker& body) { return restitution(body, speed, {.tolerance = 3e-4}).lost_fraction; };
    const Estimate elastic = lost(shell(inner));
    expect_in_proportion(elastic, lost(shell(inner, 1e-3)), lost(shell(inner, 2e-3)));
    const auto of_quality = [&](double quality) {
      return lost(relaxing_shell(inner, constant_quality(quality, lowest_of_body, highest_of_body)));
    };
    const Estimate unlimited = of_quality(1e8);  // a modulus of all time that is E(0) as well
    EXPECT_NEAR(unlimited.value, elastic.value, unlimited.error + elastic.error);
    expect_in_proportion(unlimited, of_quality(1000.0), of_quality(500.0));
  }
}

// The slower the impact, the more of it is Hertz' contact, which knows no hole; what the shell gives way has a share of
// a/R ~ v^{2/5}.
TEST(LossyHollowSpheres, TendToTingsLaw_long) {
  for (const double inner : {0.3, 0.5}) {
    double before = 1.0;
    for (const double speed : {1e-4, 1e-6, 1e-8}) {
      const double unit = std::pow(mass_of(inner) * 0.75 * softness, 0.4) * std::pow(speed, -0.2);
      const Relaxation its{{{0.5, unit}}};
      const Restitution engine = restitution(relaxing_shell(inner, its), speed, {.tolerance = 1e-4});
      const double slow =
          1.0 - quasistatic::relaxing_impact({1.0, {{{softness, its}}}, mass_of(inner)}, speed).restitution;
      const double off = std::abs((1.0 - engine.restitution.value) / slow - 1.0);
      EXPECT_LT(off, engine.restitution.error / slow + std::pow(speed, 0.4)) << inner << " " << speed;
      EXPECT_LT(off, 0.3 * before);
      before = off;
    }
  }
}

}  // namespace stoss
