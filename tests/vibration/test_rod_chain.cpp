// Chains of rods: what is conserved, and what is known exactly.
#include "stoss/vibration/rod_chain_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "numeric/random.hpp"
#include "stoss/errors.hpp"
#include "support/rods_at_rest.hpp"

namespace stoss {
namespace {

constexpr RodMethod methods[] = {RodMethod::modes, RodMethod::characteristics};

/// Rods of random lengths around 1.
std::vector<Rod> random_rods(std::size_t count, double spread) {
  std::vector<Rod> rods;
  for (std::size_t k = 0; k < count; ++k) {
    rods.push_back({.length = 1.0 + spread * (2.0 * numeric::uniform(1, {static_cast<std::uint32_t>(k)})[0] - 1.0)});
  }
  return rods;
}

/// Ten times as much room as the rods take.
RodChain chain_of(const std::vector<Rod>& rods, const RodChainOptions& options, std::uint64_t seed = 1) {
  double length = 0.0;
  for (const Rod& rod : rods) length += rod.length;
  return {rods, 11.0 * length, thermal_velocities(rods, 1.0, seed), options};
}

double energy(const RodChainSample& sample) {
  return sample.translation + sample.vibration + sample.dissipated + sample.unresolved;
}

TEST(RodChain, KeepsEnergyAndMomentum) {
  const std::vector<Rod> rods = random_rods(12, 0.2);
  const double mass = 12.0;
  for (const RodMethod method : methods) {
    for (const Tail tail : {Tail::radiating, Tail::quasistatic}) {
      RodChain chain = chain_of(rods, {.method = method, .modes = 10, .pieces = 60, .resolution = {.tail = tail}});
      const RodChainSample start = chain.sample();
      RodChainRecord record;
      run(chain, record, 1000);
      double most = 0.0;
      ASSERT_EQ(record.collisions.size(), 1000U);
      for (const RodChainSample& now : record.samples) {
        EXPECT_NEAR(energy(now), energy(start), 1e-10 * energy(start));
        EXPECT_NEAR(now.momentum, 0.0, 1e-12 * mass);
        most = std::max(most, now.vibration);
      }
      EXPECT_GT(most, 0.3 * energy(start));
      if (method == RodMethod::modes && tail == Tail::quasistatic) {
        EXPECT_EQ(chain.sample().unresolved, 0.0);
      }
    }
  }
}

TEST(RodChain, KeepsAccountOfWhatDecays) {
  for (const RodMethod method : methods) {
    for (const double decay_time : {0.0, 3.0}) {
      RodChain chain =
          chain_of(random_rods(8, 0.2), {.method = method, .modes = 10, .pieces = 60, .decay_time = decay_time});
      const double start = chain.sample().translation;
      RodChainRecord record;
      run(chain, record, 300);
      for (const RodChainSample& now : record.samples) EXPECT_NEAR(energy(now), start, 1e-10 * start);
      EXPECT_GT(record.samples.back().dissipated, 0.3 * start);
    }
  }
}

TEST(RodChain, EqualRodsAtRestExchangeTheirVelocities) {
  RodChain chain = chain_of(random_rods(9, 0.0), {.method = RodMethod::characteristics});
  std::vector<double> before = chain.velocities();
  RodChainRecord record;
  run(chain, record, 500);
  for (const RodCollision& each : record.collisions) EXPECT_NEAR(each.restitution, 1.0, 1e-12);
  std::vector<double> after = chain.velocities();
  std::sort(before.begin(), before.end());
  std::sort(after.begin(), after.end());
  for (std::size_t k = 0; k < before.size(); ++k) EXPECT_NEAR(after[k], before[k], 1e-11);
}

TEST(RodChain, CompletelyDampedRodsMeetAsRodsAtRest) {
  const std::vector<Rod> rods{{.length = 1.0},
                              {.length = 1.3, .area = 2.0},
                              {.length = 0.9, .young = 2.0},
                              {.length = 1.1, .density = 0.8},
                              {.length = 1.2}};
  for (const RodMethod method : methods) {
    RodChain chain = chain_of(rods, {.method = method, .decay_time = 0.0});
    RodChainRecord record;
    run(chain, record, 200);
    for (const RodCollision& each : record.collisions) {
      const double exact = test::restitution_at_rest(rods[each.pair], rods[(each.pair + 1) % rods.size()]);
      EXPECT_NEAR(each.restitution, exact, method == RodMethod::modes ? 4e-3 : 1e-12);
      EXPECT_EQ(each.vibration_before, 0.0);
    }
  }
}

TEST(RodChain, VibrationsDecayAsAsked) {
  const std::vector<Rod> rods = random_rods(3, 0.3);
  for (const RodMethod method : methods) {
    RodChain chain = chain_of(rods, {.method = method, .modes = 10, .decay_time = 2.5});
    chain.collide();
    chain.collide();
    const RodChainSample now = chain.sample();
    const double pause = 0.5 * (chain.next() - now.time);
    chain.fly(now.time + pause);
    EXPECT_NEAR(chain.sample().vibration, now.vibration * std::exp(-pause / 2.5), 1e-12 * now.vibration);
    EXPECT_EQ(chain.sample().translation, now.translation);
  }
}

TEST(RodChain, RunsBackWithTheStaticTail) {
  RodChain chain = chain_of(random_rods(4, 0.3), {.modes = 20, .resolution = {.tail = Tail::quasistatic}});
  const std::vector<double> start = chain.velocities();
  for (int k = 0; k < 5; ++k) chain.collide();
  chain.fly(0.5 * (chain.sample().time + chain.next()));
  const double vibration = chain.sample().vibration;
  chain.reverse();
  for (int k = 0; k < 5; ++k) chain.collide();
  const std::vector<double> end = chain.velocities();
  for (std::size_t k = 0; k < start.size(); ++k) EXPECT_NEAR(end[k], -start[k], 0.02);
  EXPECT_LT(chain.sample().vibration, 0.02 * vibration);
}

TEST(RodChain, IsTheSameEachTime) {
  const std::vector<Rod> rods = random_rods(6, 0.2);
  for (const RodMethod method : methods) {
    RodChainRecord one, other;
    RodChain first = chain_of(rods, {.method = method, .modes = 5}),
             second = chain_of(rods, {.method = method, .modes = 5});
    run(first, one, 300);
    run(second, other, 100);
    run(second, other, 200);
    ASSERT_EQ(other.collisions.size(), 300U);
    for (std::size_t k = 0; k < 300; ++k) {
      EXPECT_EQ(one.collisions[k].time, other.collisions[k].time);
      EXPECT_EQ(one.collisions[k].restitution, other.collisions[k].restitution);
    }
  }
}

TEST(RodChain, DrawsMaxwellsVelocities) {
  const std::vector<Rod> rods = random_rods(20'000, 0.5);
  const std::vector<double> velocities = thermal_velocities(rods, 3.0, 7);
  double momentum = 0.0, squares = 0.0, fourth = 0.0;
  for (std::size_t k = 0; k < rods.size(); ++k) {
    const double square = rods[k].length * velocities[k] * velocities[k] / 3.0;
    momentum += rods[k].length * velocities[k];
    squares += square / 20'000.0;
    fourth += square * square / 20'000.0;
  }
  EXPECT_NEAR(momentum, 0.0, 1e-9);
  EXPECT_NEAR(squares, 1.0, 3.0 * std::sqrt(2.0 / 20'000.0));
  EXPECT_NEAR(fourth, 3.0, 3.0 * std::sqrt(96.0 / 20'000.0));
  EXPECT_EQ(velocities, thermal_velocities(rods, 3.0, 7));
  EXPECT_NE(velocities, thermal_velocities(rods, 3.0, 8));
}

TEST(RodChain, StopsAtATimeOrWhenNothingMeets) {
  const std::vector<Rod> rods = random_rods(4, 0.2);
  RodChain chain = chain_of(rods, {.method = RodMethod::characteristics});
  RodChainRecord record;
  run(chain, record, 1'000'000, 50.0);
  EXPECT_EQ(chain.sample().time, 50.0);
  EXPECT_EQ(record.samples.back().time, 50.0);
  EXPECT_LE(record.collisions.back().time, 50.0);
  EXPECT_GT(chain.next(), 50.0);
  RodChain still(rods, 10.0, {1.0, 1.0, 1.0, 1.0});
  RodChainRecord nothing;
  run(still, nothing, 10);
  EXPECT_TRUE(nothing.collisions.empty());
  EXPECT_THROW(still.collide(), InvalidInput);
}

TEST(RodChain, ReportsInelasticCollapse) {
  RodChain chain = chain_of(random_rods(20, 0.9), {.method = RodMethod::characteristics, .decay_time = 0.0});
  RodChainRecord record;
  try {
    run(chain, record, 1'000'000);
    FAIL();
  } catch (const NotConverged& error) {
    EXPECT_NE(std::string(error.what()).find("inelastic collapse"), std::string::npos);
  }
  EXPECT_GT(record.collisions.size(), 2000U);
  EXPECT_LT(record.collisions.size(), 100'000U);
}

TEST(RodChain, RefusesWhatItCannotCompute) {
  const std::vector<Rod> rods = random_rods(3, 0.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto make = [](const std::vector<Rod>& of, double circumference, const std::vector<double>& velocities,
                       const RodChainOptions& options = {}) {
    return RodChain(of, circumference, velocities, options);
  };
  EXPECT_THROW(make({Rod{}}, 10.0, {1.0}), InvalidInput);
  EXPECT_THROW(make(rods, 3.0, {1.0, 2.0, 3.0}), InvalidInput);
  EXPECT_THROW(make(rods, nan, {1.0, 2.0, 3.0}), InvalidInput);
  EXPECT_THROW(make(rods, 10.0, {1.0, 2.0}), InvalidInput);
  EXPECT_THROW(make(rods, 10.0, {1.0, 2.0, nan}), InvalidInput);
  EXPECT_THROW(make({Rod{}, Rod{.length = -1.0}}, 10.0, {1.0, 2.0}), InvalidInput);
  EXPECT_THROW(make({Rod{}, Rod{.loss_time = 0.1}}, 10.0, {1.0, 2.0}), InvalidInput);
  EXPECT_THROW(make(rods, 10.0, {1.0, 2.0, 3.0}, {.modes = 0}), InvalidInput);
  EXPECT_THROW(make(rods, 10.0, {1.0, 2.0, 3.0}, {.pieces = 1}), InvalidInput);
  EXPECT_THROW(make(rods, 10.0, {1.0, 2.0, 3.0}, {.decay_time = -1.0}), InvalidInput);
  EXPECT_THROW(make(rods, 10.0, {1.0, 2.0, 3.0}, {.decay_time = nan}), InvalidInput);
  EXPECT_THROW(static_cast<void>(thermal_velocities(rods, -1.0, 0)), InvalidInput);
  RodChain chain = make(rods, 10.0, {1.0, 0.0, 0.0});
  EXPECT_THROW(chain.fly(-1.0), InvalidInput);
  EXPECT_THROW(chain.fly(1e3), InvalidInput);
  RodChainRecord record;
  EXPECT_THROW(run(chain, record, -1), InvalidInput);
  EXPECT_THROW(run(chain, record, 1, nan), InvalidInput);
}

}  // namespace
}  // namespace stoss
