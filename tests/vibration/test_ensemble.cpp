// Spectra and their samples: which modes, how much energy, and random numbers that nothing else changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/vibration/ensemble.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

bool same(const Oscillation& a, const Oscillation& b) {
  return a.body == b.body && a.order == b.order && a.index == b.index && a.energy == b.energy && a.phase == b.phase;
}

TEST(ThermalSpectrum, NamesEveryModeUpToTheHighest) {
  // A rod's modes are lπ, those of a second rod of half the length 2lπ.
  const Spectrum alone = thermal(RefinableContact(rod()), 0.01, 20.0);
  ASSERT_EQ(alone.size(), 6U);
  const RefinableContact pair(rod(), rod(Rod{.length = 0.5}));
  const Spectrum both = thermal(pair, 0.01, 20.0);
  ASSERT_EQ(both.size(), 9U);
  EXPECT_EQ(std::count_if(both.begin(), both.end(), [](const MeanEnergy& mode) { return mode.body == 1; }), 3);
  for (const MeanEnergy& mode : both) EXPECT_EQ(mode.energy, 0.01);

  // Whichever level of the ladder they are counted at.
  const RefinableContact ball(sphere(0.3));
  for (const double highest : {4.0, 5.6, 5.7, 12.0, 40.0}) {
    const Contact& fine = ball.at(16);
    std::size_t count = 0;
    for (const ModeGroup& group : fine.groups) {
      count += static_cast<std::size_t>(
          std::count_if(group.omega.begin(), group.omega.end(), [&](double omega) { return omega <= highest; }));
    }
    EXPECT_EQ(thermal(ball, 1.0, highest).size(), count) << highest;
  }
}

TEST(ThermalSpectrum, LeavesBodiesAtRestThatAreNotThereAsAWhole) {
  const Spectrum ball = thermal(RefinableContact(sphere(0.3)), 0.1, 6.0);
  const Spectrum on_block = thermal(RefinableContact(sphere(0.3), half_space(HalfSpace{.poisson = 0.3})), 0.1, 6.0);
  ASSERT_EQ(on_block.size(), ball.size());
  for (std::size_t k = 0; k < ball.size(); ++k) {
    EXPECT_EQ(on_block[k].body, 0);
    EXPECT_EQ(on_block[k].order, ball[k].order);
    EXPECT_EQ(on_block[k].index, ball[k].index);
  }
  const RefinableContact large(disk(0.33), disk(Disk{.poisson = 0.33, .radius = 100.0}));
  ASSERT_LT(large.part(), 1.0);
  for (const MeanEnergy& mode : thermal(large, 0.1, 10.0)) EXPECT_EQ(mode.body, 0);
}

TEST(ThermalSpectrum, HasTheFrequenciesOfItsModes) {
  const RefinableContact pair(rod(), rod(Rod{.length = 0.5}));
  const Spectrum both = thermal(pair, 0.01, 20.0);
  const std::vector<double> found = frequencies(pair, both);
  ASSERT_EQ(found.size(), both.size());
  std::vector<double> expected;
  for (const MeanEnergy& mode : both) {
    expected.push_back(std::numbers::pi * (mode.body == 0 ? 1.0 : 2.0) * (mode.index + 1));
  }
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-12) << k;
  // One of a mode beyond the first cutoffs has it too.
  EXPECT_NEAR(frequencies(pair, {{.index = 39, .energy = 1.0}}).front(), 40.0 * std::numbers::pi, 1e-9);
  EXPECT_EQ(usual_highest(pair), 10.0);
}

TEST(ThermalSpectrum, RefusesWhatItCannotMean) {
  const RefinableContact body(disk(0.33));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {-0.1, 2e6, nan, infinite}) {
    test::expect_refusal([&] { (void)thermal(body, bad, 10.0); }, {"temperature", "0 to 1e6"});
  }
  for (const double bad : {0.0, -3.0, 128.1, 1e9, nan, infinite}) {
    test::expect_refusal([&] { (void)thermal(body, 0.1, bad); }, {"highest", "128"});
  }
  test::expect_refusal([&] { (void)thermal(body, 0.1, 0.5); }, {"highest: got 0.5", "lowest mode"});
  EXPECT_EQ(usual_highest(body), 10.0);
  test::expect_refusal([&] { (void)thermal(RefinableContact(rigid(disk(0.33)), rigid(disk(0.33))), 0.1, 10.0); }, {});
}

TEST(DrawnVibration, HasExponentialEnergiesAndUniformPhases) {
  const Spectrum spectrum{{0, 2, 0, 0.5}, {0, 3, 1, 2.0}};
  constexpr int count = 20000;
  double first = 0.0, second = 0.0, squares = 0.0, product = 0.0, cosine = 0.0, sine = 0.0, normal = 0.0;
  for (int k = 0; k < count; ++k) {
    const Vibration sample = draw(spectrum, 3, static_cast<std::uint64_t>(k));
    const double x = sample[0].energy / 0.5, y = sample[1].energy / 2.0, phase = sample[0].phase;
    ASSERT_GT(std::min(x, y), 0.0);
    ASSERT_GE(phase, 0.0);
    ASSERT_LE(phase, 2.0 * std::numbers::pi);
    first += x / count;
    second += y / count;
    squares += x * x / count;
    product += (x - 1.0) * (y - 1.0) / count;
    cosine += std::cos(phase) / count;
    sine += std::sin(phase) / count;
    normal += std::pow(2.0 * x * std::pow(std::cos(phase), 2), 2) / count;
  }
  const double error = 1.0 / std::sqrt(count);  // five of each below
  EXPECT_NEAR(first, 1.0, 5.0 * error);
  EXPECT_NEAR(second, 1.0, 5.0 * error);
  EXPECT_NEAR(squares, 2.0, 5.0 * std::sqrt(20.0) * error);
  EXPECT_NEAR(product, 0.0, 5.0 * error);
  EXPECT_NEAR(cosine, 0.0, 5.0 * error);
  EXPECT_NEAR(sine, 0.0, 5.0 * error);
  EXPECT_NEAR(normal, 3.0, 5.0 * std::sqrt(96.0) * error);  // the fourth moment of a normal number
}

TEST(DrawnVibration, OfAModeDependsOnNothingButSeedSampleAndMode) {
  const RefinableContact pair(disk(0.33), disk(Disk{.poisson = 0.33, .radius = 2.0}));
  const Spectrum few = thermal(pair, 0.1, 4.0), many = thermal(pair, 0.1, 9.0);
  ASSERT_GT(many.size(), few.size());
  for (const std::uint64_t sample : {std::uint64_t{0}, std::uint64_t{5}, std::uint64_t{1} << 40U}) {
    const Vibration small = draw(few, 11, sample), large = draw(many, 11, sample), other = draw(many, 12, sample);
    for (const Oscillation& mode : small) {
      EXPECT_EQ(std::count_if(large.begin(), large.end(), [&](const Oscillation& one) { return same(one, mode); }), 1);
    }
    std::vector<double> phases;
    for (std::size_t k = 0; k < large.size(); ++k) {
      EXPECT_NE(large[k].energy, other[k].energy);
      phases.push_back(large[k].phase);
    }
    std::sort(phases.begin(), phases.end());
    EXPECT_EQ(std::adjacent_find(phases.begin(), phases.end()), phases.end());
  }
  EXPECT_NE(draw(few, 11, 0)[0].phase, draw(few, 11, std::uint64_t{1} << 32U)[0].phase);
  EXPECT_NE(draw(few, 11, 0)[0].phase, draw(few, 11 + (std::uint64_t{1} << 32U), 0)[0].phase);
}

TEST(DrawnVibration, RestsAtTemperatureZero) {
  EXPECT_TRUE(draw(thermal(RefinableContact(disk(0.33)), 0.0, 10.0), 1, 1).empty());
  test::expect_refusal([] { (void)draw({{0, 2, 0, -1.0}}, 1, 1); }, {"energy: got -1", "0 to 1e6"});
  test::expect_refusal([] { (void)draw({{0, 2, 0, std::nan("")}}, 1, 1); }, {"energy: got nan"});
}

}  // namespace
}  // namespace stoss
