// The same physical identities for every body, wall and speed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/impact/impact.hpp"
#include "support/body_tools.hpp"

namespace stoss {
namespace {

const double rod_case = std::numeric_limits<double>::infinity();  // in the place of a Poisson number

enum class WallCase { static_tail, radiating_tail, exponential };

class Identity : public ::testing::TestWithParam<std::tuple<double, WallCase, double>> {
 protected:
  const double poisson = std::get<0>(GetParam());
  const WallCase wall_case = std::get<1>(GetParam());
  const double speed = std::get<2>(GetParam());
  const bool is_rod = poisson == rod_case;
  const Wall wall = make_wall();
  const Tail tail = wall_case == WallCase::static_tail ? Tail::quasistatic : Tail::radiating;
  const Body body = is_rod ? rod(50.0) : disk(poisson, is_soft() ? 12.5 : 25.0);
  // All of a rod's end touches and leaves at once, which a static tail without mass answers with a rattle: fewer, but
  // finer steps. With the radiating tail nothing is gained from them.
  const double step = recommended_step(contact(body, wall), speed, tail) * (is_rod ? 0.125 : 1.0);

  [[nodiscard]] Wall make_wall() const {
    switch (wall_case) {
      case WallCase::static_tail:
        return HardWall{};
      case WallCase::radiating_tail:
        return HardWall{};
      case WallCase::exponential:
        break;
    }
    return ExponentialWall{500.0, 1.0};
  }

  [[nodiscard]] bool is_soft() const { return wall_case == WallCase::exponential; }
  [[nodiscard]] bool loses_energy() const { return wall_case == WallCase::radiating_tail; }
  [[nodiscard]] Impact run(const Body& which) const { return impact(which, wall, speed, {.step = step, .tail = tail}); }
};

void expect_same_bits(const Impact& a, const Impact& b) {
  EXPECT_EQ(a.restitution, b.restitution);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.contact_time, b.contact_time);
  EXPECT_EQ(a.max_force, b.max_force);
  EXPECT_EQ(a.max_compression, b.max_compression);
  EXPECT_EQ(a.energy_error, b.energy_error);
  EXPECT_EQ(a.final_state.center, b.final_state.center);
  EXPECT_EQ(a.final_state.velocity, b.final_state.velocity);
  EXPECT_EQ(a.final_state.coordinate, b.final_state.coordinate);
  EXPECT_EQ(a.final_state.momentum, b.final_state.momentum);
  EXPECT_EQ(a.energy.unresolved, b.energy.unresolved);
}

TEST_P(Identity, EnergyIsConserved) {
  const Impact result = run(body);
  // The soft wall is smooth and its potential exact; a hard one makes and breaks contact between two steps.
  EXPECT_NEAR(result.energy_error, 0.0, is_soft() ? 1e-7 : 1e-4);
}

TEST_P(Identity, ImpulseIsTheChangeOfMomentum) {
  double impulse = 0.0, before = 0.0, last = 0.0;
  const Impact result = impact(body, wall, speed, {.step = step, .tail = tail}, [&](const Snapshot& now) {
    impulse += 0.5 * (before + now.force) * (now.time - last);
    before = now.force;
    last = now.time;
  });
  EXPECT_LE(result.momentum_error, 1e-12);
  // From what the observer saw, in units of the momentum before.
  EXPECT_NEAR(impulse / speed, 1.0 + result.restitution, 1e-9);
}

TEST_P(Identity, RestitutionFromRestIsAtMostOne) {
  const Impact result = run(body);
  EXPECT_GT(result.restitution, 0.0);
  EXPECT_LE(result.restitution, 1.0 + 1e-12 + (is_soft() ? 1e-7 : 5e-5));
  EXPECT_NEAR(result.lost_fraction, 1.0 - result.restitution * result.restitution, 1e-14);
  EXPECT_GE(result.contacts, 1);
  EXPECT_GT(result.contact_time, 0.0);
  EXPECT_GT(result.max_force, 0.0);
}

TEST_P(Identity, LedgerSumsToOne) {
  const Impact result = run(body);
  const EnergyLedger& ledger = result.energy;
  EXPECT_NEAR(ledger.translation, result.restitution * result.restitution, 1e-11);  // 1e-12 of it was in the wall
  double modes = 0.0;
  for (const ModeEnergy& mode : ledger.modes) {
    EXPECT_GE(mode.after, 0.0);
    EXPECT_GE(mode.average, 0.0);
    modes += mode.after;
  }
  EXPECT_EQ(ledger.modes.size(), mode_count(body));
  EXPECT_NEAR(modes, ledger.vibration, 1e-12);
  EXPECT_NEAR(ledger.translation + ledger.vibration + ledger.unresolved + ledger.stored + result.energy_error, 1.0,
              1e-12);
  EXPECT_LT(std::abs(ledger.stored), 1e-10);
  if (loses_energy()) {
    EXPECT_GE(ledger.unresolved, -1e-6);
  } else {
    EXPECT_EQ(ledger.unresolved, 0.0);
  }
}

TEST_P(Identity, TimeReversalGivesBackTheStart) {
  if (loses_energy()) GTEST_SKIP() << "the radiating tail takes energy";
  const Contact fixed = contact(body, wall);
  ImpactOptions options{.step = step, .tail = tail};
  test::use_one_grid(fixed, speed, options);
  const Impact forth = impact(fixed, speed, options);
  options.start = test::backwards(forth.final_state);
  if (!is_rod) options.nodes = forth.nodes;
  const Impact back = impact(fixed, -forth.final_state.velocity, options);
  EXPECT_NEAR(back.restitution * forth.restitution, 1.0, 1e-8);
  EXPECT_NEAR(-back.final_state.velocity / speed, 1.0, 1e-8);
  EXPECT_LE(back.energy.vibration, 1e-8);
  EXPECT_NEAR(back.max_force / forth.max_force, 1.0, 1e-8);
  EXPECT_NEAR(back.max_compression, forth.max_compression, 1e-8 * std::abs(forth.max_compression));
  if (!is_soft()) {  // what counts as contact with a soft wall depends on the speed of the impact
    EXPECT_NEAR(back.contact_time, forth.contact_time, 1.001 * step);
  }
}

TEST_P(Identity, GridDoesNotMatter) {
  if (is_rod) GTEST_SKIP() << "a rod has a single point of contact";
  // On a soft wall the nodes integrate a smooth pressure, which needs a grid that resolves 1/√α.
  const int coarse = is_soft() ? 192 : 64, fine = is_soft() ? 288 : 96;
  const Impact a = impact(body, wall, speed, {.step = step, .nodes = coarse, .tail = tail});
  const Impact b = impact(body, wall, speed, {.step = step, .nodes = fine, .tail = tail});
  // Without damping the nodes at the edge of a fast contact rattle, which costs the static tail a digit.
  const double rattle = wall_case == WallCase::static_tail ? speed : 0.0;
  EXPECT_NEAR(a.lost_fraction, b.lost_fraction, is_soft() ? 1e-9 : 5e-5 + 1e-3 * rattle);
  // Extrema are those of the steps, which on another grid fall on other instants.
  EXPECT_NEAR(a.max_force / b.max_force, 1.0, 1e-3 + 1e-2 * rattle);
  EXPECT_NEAR(a.max_compression, b.max_compression, 1e-4 * std::abs(b.max_compression));
}

TEST_P(Identity, StrengthOfTheSoftWallDoesNotMatter) {
  if (!is_soft()) GTEST_SKIP() << "a hard wall has no strength";
  const Impact weak = impact(body, ExponentialWall{500.0, 1e-3}, speed, {.step = step, .tail = tail});
  const Impact strong = impact(body, ExponentialWall{500.0, 1e3}, speed, {.step = step, .tail = tail});
  EXPECT_NEAR(weak.lost_fraction, run(body).lost_fraction, 1e-9);
  EXPECT_NEAR(strong.lost_fraction, run(body).lost_fraction, 1e-9);
}

TEST_P(Identity, OrderOfTheModesDoesNotMatter) {
  const Impact straight = run(body);
  const Impact backward = run(test::reversed(body));
  EXPECT_NEAR(backward.restitution, straight.restitution, 1e-9);
  EXPECT_NEAR(backward.max_force / straight.max_force, 1.0, 1e-9);
  ASSERT_EQ(backward.energy.modes.size(), straight.energy.modes.size());
  for (std::size_t i = 0; i < straight.energy.modes.size(); ++i) {
    const ModeEnergy& a = straight.energy.modes[i];
    const ModeEnergy& b = backward.energy.modes[backward.energy.modes.size() - 1 - i];
    EXPECT_EQ(a.order, b.order);
    EXPECT_EQ(a.omega, b.omega);
    EXPECT_NEAR(a.after, b.after, 1e-9);
    EXPECT_NEAR(a.average, b.average, 1e-9);
  }
}

TEST_P(Identity, RunsAgainAndOnTwoThreadsAtOnceAreTheSameToTheLastBit) {
  const Impact alone = run(body);
  Impact first, second;
  std::thread one([&] { first = run(body); });
  std::thread two([&] { second = run(body); });
  one.join();
  two.join();
  expect_same_bits(first, alone);
  expect_same_bits(second, alone);
}

std::string case_name(const ::testing::TestParamInfo<Identity::ParamType>& info) {
  const auto [poisson, wall, speed] = info.param;
  std::ostringstream text;
  if (poisson == rod_case) {
    text << "rod";
  } else {
    text << "disk" << std::lround(100.0 * poisson);
  }
  text << (wall == WallCase::static_tail      ? "_static"
           : wall == WallCase::radiating_tail ? "_radiating"
                                              : "_exponential");
  text << "_" << std::lround(1000.0 * speed);
  std::string name = text.str();
  std::replace(name.begin(), name.end(), '-', 'm');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Every, Identity,
                         ::testing::Combine(::testing::Values(-0.5, 0.0, 0.33, 0.9, rod_case),
                                            ::testing::Values(WallCase::static_tail, WallCase::radiating_tail,
                                                              WallCase::exponential),
                                            ::testing::Values(1e-3, 0.02, 0.1, 0.3)),
                         case_name);

}  // namespace
}  // namespace stoss
