// What long chains do: equipartition without damping, E ∝ t⁻² with it, and the same by both methods.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "numeric/random.hpp"
#include "stoss/vibration/rod_chain_run.hpp"

namespace stoss {
namespace {

std::vector<Rod> rods_of(std::size_t count, double spread) {
  std::vector<Rod> rods;
  for (std::size_t k = 0; k < count; ++k) {
    rods.push_back({.length = 1.0 + spread * (2.0 * numeric::uniform(2, {static_cast<std::uint32_t>(k)})[0] - 1.0)});
  }
  return rods;
}

RodChain cooling_chain(const std::vector<Rod>& rods, const RodChainOptions& options, std::uint64_t seed) {
  double length = 0.0;
  for (const Rod& rod : rods) length += rod.length;
  return {rods, 11.0 * length, thermal_velocities(rods, 1.0, seed), options};
}

struct Mean {
  double value, error;  // of the mean
};

Mean mean(const std::vector<double>& values) {
  double sum = 0.0, squares = 0.0;
  for (const double each : values) sum += each;
  const auto count = static_cast<double>(values.size());
  for (const double each : values) squares += (each - sum / count) * (each - sum / count);
  return {sum / count, std::sqrt(squares / (count * (count - 1.0)))};
}

// Microcanonical: translation has as many degrees of freedom as rods but one, every mode two.
TEST(RodChainCooling, EnergyIsSharedByAllDegreesOfFreedomWithoutDamping_long) {
  const std::vector<Rod> rods = rods_of(6, 0.1);
  RodChain chain = cooling_chain(rods, {.modes = 2, .resolution = {.tail = Tail::quasistatic}}, 4);
  const double total = chain.sample().translation;
  constexpr int batches = 20, each = 4000;
  for (int k = 0; k < each; ++k) chain.collide();
  std::vector<double> shares;
  for (int batch = 0; batch < batches; ++batch) {
    double integral = 0.0;
    const double begin = chain.sample().time;
    for (int k = 0; k < each; ++k) {
      const RodChainSample now = chain.sample();
      integral += now.translation * (chain.next() - now.time);
      chain.collide();
    }
    shares.push_back(integral / (total * (chain.sample().time - begin)));
  }
  double shortest = rods.front().length, modes = 0.0;
  for (const Rod& rod : rods) shortest = std::min(shortest, rod.length);
  for (const Rod& rod : rods) modes += std::floor(2.5 * rod.length / shortest);
  const double expected = 5.0 / (5.0 + 2.0 * modes);
  const auto [value, error] = mean(shares);
  EXPECT_LT(error, 0.1 * expected);
  EXPECT_NEAR(value, expected, 3.0 * error);  // 99.7 %
}

// Haff: the rate of collisions goes with √E, what each takes with E, so E = E₀ (1 + t/τ)⁻²; from t = 1000 τ on, the 1
// no longer shows.
TEST(RodChainCooling, CompletelyDampedRodsCoolAsTheInverseSquareOfTime) {
  const std::vector<Rod> rods = rods_of(10, 0.1);
  std::vector<double> exponents;
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    RodChain chain = cooling_chain(rods, {.method = RodMethod::characteristics, .decay_time = 0.0}, seed);
    const double start = chain.sample().translation;
    RodChainSample from, to;
    while (chain.sample().translation > 1e-6 * start) chain.collide();
    from = chain.sample();
    while (chain.sample().translation > 1e-16 * start) chain.collide();
    to = chain.sample();
    exponents.push_back(std::log(to.translation / from.translation) / std::log(to.time / from.time));
  }
  const auto [value, error] = mean(exponents);
  EXPECT_LT(error, 0.03);
  EXPECT_NEAR(value, -2.0, 3.0 * error);
}

TEST(RodChainCooling, BothMethodsCoolAlike) {
  const std::vector<Rod> rods = rods_of(8, 0.2);
  std::vector<double> differences;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    double cooled[2];
    for (const RodMethod method : {RodMethod::modes, RodMethod::characteristics}) {
      RodChain chain = cooling_chain(rods, {.method = method, .modes = 20, .decay_time = 5.0}, seed);
      RodChainRecord record;
      run(chain, record, 1'000'000, 1000.0);
      cooled[method == RodMethod::modes ? 0 : 1] = std::log(record.samples.back().translation);
    }
    differences.push_back(cooled[0] - cooled[1]);
  }
  const auto [value, error] = mean(differences);
  EXPECT_LT(error, 0.15);
  EXPECT_NEAR(value, 0.0, 3.0 * error);
}

}  // namespace
}  // namespace stoss
