// The event-driven gas of examples/gas: an ideal one in equilibrium, and Haff's law.
#include "../../examples/gas/gas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using gas::smooth;
using Disk = gas::Particle<2>;
using Gas = gas::Gas<2>;

constexpr std::size_t count = 500;

const gas::Rule elastic = smooth([](double, double) { return 1.0; });

std::vector<double> equal() { return std::vector<double>(count, 1.0); }

std::vector<double> mixed() {
  std::vector<double> radii;
  for (std::size_t i = 0; i < count; ++i) radii.push_back(1.0 + 1.5 * static_cast<double>(i) / count);
  return radii;
}

/// Value at contact of the pair distribution (D. Henderson, Mol. Phys. 30, 971, 1975).
double contact_value(double packing) { return (1.0 - 7.0 * packing / 16.0) / ((1.0 - packing) * (1.0 - packing)); }

/// Collisions of a disk in a unit of time, after Enskog: 2√π n σ g √(T/m), m = π.
double collision_rate(double packing, double temperature) {
  const double number = packing / std::numbers::pi;
  return 4.0 * std::sqrt(std::numbers::pi) * number * contact_value(packing) *
         std::sqrt(temperature / std::numbers::pi);
}

TEST(Gas, HasThePressureOfHenderson) {
  for (const double packing : {0.1, 0.3, 0.5}) {
    Gas gas(equal(), packing, 1.0, 1);
    gas.advance(20.0 / collision_rate(packing, 1.0), elastic);
    const double virial = gas.virial(), begin = gas.time();
    gas.advance(begin + 400.0 / collision_rate(packing, 1.0), elastic);
    const double factor = 1.0 + (gas.virial() - virial) / (2.0 * gas.energy() * (gas.time() - begin));
    // 1/√(10⁵ collisions) = 0.3 %, and 1/N = 0.2 % for the momentum that is 0.
    EXPECT_NEAR(factor / ((1.0 + packing * packing / 8.0) / ((1.0 - packing) * (1.0 - packing))), 1.0, 0.01) << packing;
  }
}

TEST(Gas, CollidesAtTheRateOfEnskog) {
  Gas gas(equal(), 0.2, 1.0, 2);
  const double rate = collision_rate(0.2, 1.0);
  gas.advance(20.0 / rate, elastic);
  const long before = gas.collisions();
  gas.advance(420.0 / rate, elastic);
  EXPECT_NEAR(2.0 * static_cast<double>(gas.collisions() - before) / count / 400.0, 1.0, 0.01);
}

TEST(Gas, KeepsEnergyAndMomentumAndDoesNotOverlap) {
  Gas gas(mixed(), 0.35, 1.0, 3);
  const double energy = gas.energy();
  gas.advance(160.0, elastic);
  EXPECT_GT(gas.collisions(), 20 * static_cast<long>(count));
  EXPECT_NEAR(gas.energy() / energy, 1.0, 1e-11);
  const std::vector<Disk> disks = gas.particles();
  double u = 0.0, w = 0.0, overlap = 0.0;
  for (const Disk& disk : disks) {
    u += disk.mass * disk.velocity[0];
    w += disk.mass * disk.velocity[1];
  }
  EXPECT_NEAR(u, 0.0, 1e-9);
  EXPECT_NEAR(w, 0.0, 1e-9);
  const double side = gas.side();
  for (std::size_t i = 0; i < disks.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double x = std::remainder(disks[i].place[0] - disks[j].place[0], side),
                   y = std::remainder(disks[i].place[1] - disks[j].place[1], side);
      overlap = std::max(overlap, disks[i].radius + disks[j].radius - std::hypot(x, y));
    }
  }
  EXPECT_LT(overlap, 1e-9);
}

TEST(Gas, OfUnequalDisksHasEquipartition) {
  Gas gas(mixed(), 0.3, 1.0, 4);
  double small = 0.0, large = 0.0;
  for (int k = 0; k < 200; ++k) {
    gas.advance(20.0 + 3.0 * k, elastic);
    for (const Disk& disk : gas.particles()) {
      (disk.radius < 1.75 ? small : large) += disk.translation();
    }
  }
  // Of N T, with fluctuations 1/√(250 × some 100 independent samples).
  EXPECT_NEAR(small / large, 1.0, 0.03);
}

TEST(Gas, RepeatsItselfAndDependsOnItsSeed) {
  const auto energies = [](std::uint64_t seed) {
    Gas gas(mixed(), 0.3, 1.0, seed);
    gas.advance(30.0, smooth([](double speed, double ratio) { return 1.0 - 0.1 * std::tanh(speed * ratio); }));
    return std::pair(gas.energy(), gas.particles()[7].place[0]);
  };
  EXPECT_EQ(energies(5), energies(5));
  EXPECT_NE(energies(5), energies(6));
}

/// Time of a gas that has cooled until each of the energies, with the energies and the collisions of a disk.
struct Cooling {
  std::vector<double> time, energy, collisions;
};

Cooling cooled(const gas::Law& law, double least, std::uint64_t seed) {
  Gas gas(equal(), 0.2, 1.0, seed);
  gas.advance(20.0 / collision_rate(0.2, 1.0), elastic);
  const double begin = gas.time(), energy = gas.energy();
  const long before = gas.collisions();
  Cooling seen;
  for (double time = 1.0; seen.energy.empty() || seen.energy.back() > least; time *= 1.2) {
    gas.advance(begin + time, smooth(law));
    seen.time.push_back(time);
    seen.energy.push_back(gas.energy() / energy);
    seen.collisions.push_back(static_cast<double>(gas.collisions() - before) / count);
  }
  return seen;
}

/// −d ln E/d ln t between two energies, by least squares.
double exponent(const Cooling& seen, double shift, double from, double to) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < seen.time.size(); ++i) {
    if (seen.energy[i] > from || seen.energy[i] < to) continue;
    const double a = std::log(seen.time[i] + shift), b = std::log(seen.energy[i]);
    n += 1.0;
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  return -(n * xy - x * y) / (n * xx - x * x);
}

TEST(Gas, ObeysTheLawOfHaff) {
  constexpr double e = 0.98, loss = 1.0 - e * e;
  const double tau = 4.0 / (loss * collision_rate(0.2, 1.0));
  const Cooling seen = cooled([](double, double) { return e; }, 2e-3, 7);
  // E = E₀ (1 + t/τ)^(−2): the small box keeps the gas homogeneous.
  EXPECT_NEAR(exponent(seen, tau, 0.8, 2e-3), 2.0, 0.04);
  // A collision takes (1 − ε²) T on average, distributed exponentially: E = E₀ exp(−(1 − ε²) C/N), but for some 2 % as
  // the tails of Maxwell's distribution are lost.
  for (std::size_t i = 0; i < seen.time.size(); ++i) {
    if (seen.collisions[i] < 1.0) continue;
    EXPECT_NEAR(-std::log(seen.energy[i]) / (loss * seen.collisions[i]), 1.0,
                0.02 + 3.0 / std::sqrt(count * seen.collisions[i]))
        << seen.time[i];
  }
}

TEST(Gas, OfViscoelasticDisksCoolsMoreSlowly) {
  const Cooling seen = cooled([](double speed, double) { return 1.0 - 0.03 * std::pow(speed, 0.2); }, 1e-3, 8);
  // dE/dt ∝ −E^(3/2 + 1/10): E ~ t^(−5/3), E^(−3/5) is a line in t that gives τ.
  const auto line = [&](std::size_t i) { return std::pow(seen.energy[i], -0.6); };
  const std::size_t half = seen.time.size() - 4;
  const double tau = seen.time[half] / (line(half) - 1.0);
  EXPECT_NEAR(exponent(seen, tau, 0.5, 1e-3), 5.0 / 3.0, 0.05);
  EXPECT_LT(exponent(seen, tau, 0.5, 1e-3), 1.8);
}

TEST(Gas, RefusesWhatHasNoRoom) {
  EXPECT_THROW(Gas(std::vector<double>(4, 1.0), 0.2, 1.0, 1), std::invalid_argument);
  EXPECT_THROW(Gas(equal(), 0.9, 1.0, 1), std::invalid_argument);
}

}  // namespace
