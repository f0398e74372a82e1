// Single collisions of rods: two methods against the exact formulas of rods at rest, and against each other.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "numeric/random.hpp"
#include "support/rods_at_rest.hpp"
#include "vibration/rod_vibrations.hpp"

namespace stoss {
namespace {

const std::vector<Rod> unequal{{.length = 1.0}, {.length = 1.4, .area = 1.3}};

/// A vibration of the lowest modes of a rod, by the velocities √2 Σ (a cos ωt + b sin ωt) of its right end.
struct Motion {
  static constexpr int modes = 6;
  std::vector<double> a{}, b{};

  Motion(std::uint32_t rod, std::uint32_t trial, double amplitude) {
    for (std::uint32_t l = 0; l < modes; ++l) {
      const auto [u, w] = numeric::uniform(5, {rod, trial, l});
      a.push_back(amplitude * (2.0 * u - 1.0));
      b.push_back(amplitude * (2.0 * w - 1.0));
    }
  }
};

void give(RodModes& modes, std::size_t rod, const Motion& motion) {
  const RodMeasures measures(unequal[rod]);
  for (int l = 1; l <= Motion::modes; ++l) {
    const auto k = static_cast<std::size_t>(l - 1);
    const double omega = l * std::numbers::pi / measures.transit, sign = l % 2 == 0 ? 1.0 : -1.0;
    modes.set(rod, l, -sign * motion.b[k] / omega, sign * measures.mass * motion.a[k]);
  }
}

/// As many pieces as asked for, each the mean of the wave.
void give(RodWaves& waves, std::size_t rod, const Motion& motion, int pieces) {
  const double transit = RodMeasures(unequal[rod]).transit, duration = 2.0 * transit / pieces;
  const auto phi = [&](double time) {
    double sum = 0.0;
    for (int l = 1; l <= Motion::modes; ++l) {
      const auto k = static_cast<std::size_t>(l - 1);
      const double omega = l * std::numbers::pi / transit;
      sum += (motion.a[k] * std::sin(omega * time) - motion.b[k] * std::cos(omega * time)) / omega;
    }
    return sum / std::numbers::sqrt2;
  };
  std::vector<RodWave::Piece> list;
  for (int i = 0; i < pieces; ++i) list.push_back({duration, (phi((i + 1) * duration) - phi(i * duration)) / duration});
  waves.wave(rod).set(std::move(list));
}

RodWaves fine_waves(const std::vector<Rod>& rods) { return {rods, {.pieces = 1'000'000}}; }

double reduced(const std::vector<Rod>& rods) {
  const double one = RodMeasures(rods[0]).mass, other = RodMeasures(rods[1]).mass;
  return one * other / (one + other);
}

const std::vector<std::vector<Rod>> at_rest{{{.length = 10, .area = 3}, {.length = 25, .area = 1}},
                                            {{.length = 10, .area = 5}, {.length = 73, .area = 1}},
                                            {{.length = 20, .area = 3}, {.length = 10, .area = 1}},
                                            {{.length = 30, .area = 2}, {.length = 11, .area = 5}}};

TEST(RodCollisions, CharacteristicsMeetTheExactFormulasAtRest) {
  const double expected[] = {0.7875, 0.596178, 0.75, 0.710929};
  for (std::size_t k = 0; k < at_rest.size(); ++k) {
    RodWaves waves = fine_waves(at_rest[k]);
    const double exact = test::restitution_at_rest(at_rest[k][0], at_rest[k][1]);
    EXPECT_NEAR(exact, expected[k], 5e-7);
    EXPECT_NEAR(waves.meet(0, 1, 0.3).restitution, exact, 1e-13);
    const double energy = waves.energy(0) + waves.energy(1);
    EXPECT_NEAR(energy / (0.5 * reduced(at_rest[k]) * 0.09), 1.0 - exact * exact, 1e-13);
  }
}

TEST(RodCollisions, ModesConvergeToTheExactFormulasAtRest) {
  for (const std::vector<Rod>& rods : at_rest) {
    const double exact = test::restitution_at_rest(rods[0], rods[1]);
    RodModes coarse(rods, {.modes = 50}), fine(rods, {.modes = 400});
    EXPECT_NEAR(coarse.meet(0, 1, 0.3).restitution, exact, 3e-3);
    EXPECT_NEAR(fine.meet(0, 1, 0.3).restitution, exact, 4e-4);
  }
}

TEST(RodCollisions, MethodsAgreeForRodsThatVibrate) {
  for (std::uint32_t trial = 0; trial < 4; ++trial) {
    const Motion left(0, trial, 0.3 * (trial + 1)), right(1, trial, 0.3 * (trial + 1));
    std::vector<double> by_pieces;
    double energy = 0.0;
    for (const int pieces : {100, 400, 1600, 6400}) {
      RodWaves waves = fine_waves(unequal);
      give(waves, 0, left, pieces);
      give(waves, 1, right, pieces);
      by_pieces.push_back(waves.meet(0, 1, 1.0).restitution);
      energy = waves.energy(0);
    }
    // Second order in the duration of the pieces.
    EXPECT_LT(std::abs(by_pieces[3] - by_pieces[2]), std::abs(by_pieces[1] - by_pieces[0]) / 16.0 + 1e-9);
    std::vector<double> errors;
    for (const int count : {25, 400}) {
      RodModes modes(unequal, {.modes = count});
      give(modes, 0, left);
      give(modes, 1, right);
      errors.push_back(std::abs(modes.meet(0, 1, 1.0).restitution - by_pieces[3]));
      if (count == 400) {
        EXPECT_NEAR(modes.energy(0), energy, 0.01 * energy + 1e-3);
      }
    }
    EXPECT_LT(errors[1], 1e-3) << trial;
    EXPECT_LT(errors[1], errors[0] / 3.0) << trial;
  }
}

TEST(RodCollisions, EnergyAndVibrationAreThoseOfTheModes) {
  const Motion motion(0, 0, 0.4);
  RodModes modes(unequal, {});
  RodWaves waves = fine_waves(unequal);
  give(modes, 1, motion);
  give(waves, 1, motion, 2000);
  const double energy = modes.energy(1);
  EXPECT_NEAR(waves.energy(1), energy, 1e-4 * energy);
  modes.age(1, 0.73, 0.5);
  waves.age(1, 0.73, 0.5);
  EXPECT_NEAR(modes.energy(1), 0.5 * energy, 1e-12);
  EXPECT_NEAR(waves.energy(1), 0.5 * energy, 1e-4 * energy);
}

TEST(RodCollisions, CharacteristicsRunBack) {
  for (std::uint32_t trial = 0; trial < 4; ++trial) {
    RodWaves waves = fine_waves(unequal);
    give(waves, 0, Motion(0, trial, 0.5), 100);
    give(waves, 1, Motion(1, trial, 0.5), 100);
    const double left = waves.energy(0), right = waves.energy(1);
    const double restitution = waves.meet(0, 1, 1.0).restitution;
    const double total = waves.energy(0) + waves.energy(1);
    EXPECT_NEAR(total + 0.5 * reduced(unequal) * (restitution * restitution - 1.0), left + right, 1e-12);
    waves.reverse(0);
    waves.reverse(1);
    EXPECT_NEAR(waves.meet(0, 1, restitution).restitution * restitution, 1.0, 1e-9);
    EXPECT_NEAR(waves.energy(0), left, 1e-9);
    EXPECT_NEAR(waves.energy(1), right, 1e-9);
  }
}

TEST(RodCollisions, MergedPiecesKeepTheMeanAndReportTheirEnergy) {
  RodWaves waves = fine_waves(unequal);
  give(waves, 0, Motion(0, 1, 0.5), 3000);
  RodWave& wave = waves.wave(0);
  const double energy = wave.energy(), mean = wave.mean();
  const double lost = wave.merge(100);
  EXPECT_LE(wave.size(), 100U);
  EXPECT_GT(lost, 0.0);
  EXPECT_LT(lost, 0.01 * energy);
  EXPECT_NEAR(wave.energy() + lost, energy, 1e-13 * energy);
  EXPECT_NEAR(wave.mean(), mean, 1e-15);
}

}  // namespace
}  // namespace stoss
