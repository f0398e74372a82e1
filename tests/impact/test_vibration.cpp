// Impacts of bodies that vibrate: what `approach` makes of energies and phases, and symmetries.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/vibration.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/disk_pairs.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;

Impact impact_of(const Contact& contact, double speed, const Vibration& vibration, const Resolution& resolution = {}) {
  return impact(contact, speed, {.resolution = resolution, .start = approach(contact, speed, vibration)});
}

std::vector<Contact> various_contacts() {
  return {contact(disk(0.33, 12.0)),
          contact(disk(-0.5, 8.0)),
          contact(sphere(0.3, 9.0)),
          contact(rod(40.0)),
          test::pair_of(Disk{0.33}, Disk{0.2, 0.5, 2.0, 3.0}, 12.0),
          contact(rod(), rod(Rod{.length = 2.5, .young = 2.0}), 20.0),
          contact(disk(Disk{.poisson = 0.33, .loss_time = 0.01}, 9.0))};
}

/// Some modes of each body.
Vibration some_modes(const Contact& contact) {
  Vibration vibration;
  for (std::size_t g = 0; g < contact.groups.size(); ++g) {
    const ModeGroup& group = contact.groups[g];
    if (group.omega.empty()) continue;
    const int index = group.index.empty() ? 0 : group.index.front();
    const double k = static_cast<double>(g);
    vibration.push_back({g < contact.first_groups ? 0 : 1, group.order, index, 0.01 + 0.02 * k, 3.0 * std::sin(k)});
  }
  return vibration;
}

TEST(Approach, IsTheInverseOfVibration) {
  for (const Contact& contact : various_contacts()) {
    const Vibration given = some_modes(contact);
    ASSERT_FALSE(given.empty());
    const State state = approach(contact, 0.1, given);
    EXPECT_EQ(state.velocity, 0.1);
    EXPECT_GE(state.center, -contact.extent - (1.0 + 1e-14) * clearance(contact, state));
    const Vibration found = vibration(contact, state);
    ASSERT_EQ(found.size(), given.size()) << name(contact);
    for (std::size_t k = 0; k < given.size(); ++k) {
      EXPECT_EQ(found[k].body, given[k].body);
      EXPECT_EQ(found[k].order, given[k].order);
      EXPECT_EQ(found[k].index, given[k].index);
      EXPECT_NEAR(found[k].energy, given[k].energy, 1e-13);
      EXPECT_NEAR(std::remainder(found[k].phase - given[k].phase, full_turn), 0.0, 1e-11) << name(contact);
    }
    // Free flight changes neither energies nor phases.
    if (longest_loss_time(contact) > 0.0) continue;
    const Vibration earlier = vibration(contact, free_motion(contact, state, -7.0));
    for (std::size_t k = 0; k < given.size(); ++k) {
      EXPECT_NEAR(earlier[k].energy, given[k].energy, 1e-13);
      EXPECT_NEAR(std::remainder(earlier[k].phase - given[k].phase, full_turn), 0.0, 1e-11);
    }
  }
}

TEST(Approach, GivesEachModeItsEnergyAndPhase) {
  const Contact pair = test::pair_of(Disk{0.33}, Disk{0.2, 0.5, 2.0, 3.0}, 12.0);
  const Vibration one{{1, 2, 0, 0.3, 0.0}};
  State state = approach(pair, 0.1, one);
  state = free_motion(pair, state, -(state.center + pair.extent) / 0.1);  // to t = 0: all of Q, nothing of P
  const std::vector<double> energies = mode_energies(pair, state);
  double sum = 0.0;
  for (std::size_t k = 0; k < energies.size(); ++k) {
    sum += energies[k];
    EXPECT_GE(state.coordinate[k], 0.0);
    EXPECT_NEAR(state.momentum[k], 0.0, 1e-12);
  }
  EXPECT_NEAR(sum, 0.3 * 0.5 * pair.mass * 0.01, 1e-15);
}

TEST(Approach, RefusesModesThatAreNotThere) {
  const Contact wall = contact(disk(0.33, 12.0));
  const auto refused = [&](const Vibration& vibration, const std::vector<std::string>& parts) {
    test::expect_refusal([&] { (void)approach(wall, 0.1, vibration); }, parts);
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  refused({{1, 2, 0, 0.1, 0.0}}, {"body 1", "a wall has no modes"});
  refused({{-1, 2, 0, 0.1, 0.0}}, {"body -1"});
  refused({{0, 2, 99, 0.1, 0.0}}, {"mode (2, 99) of the first body", "12"});
  // What no cutoff would keep.
  for (const Oscillation& none : {Oscillation{0, -1, 0, 0.1, 0.0}, Oscillation{0, 2, -1, 0.1, 0.0}}) {
    refused({none}, {"of the first body", "an order and an index of 0 or more"});
    test::expect_refusal([&] { (void)keeps(wall, {none}); }, {"an order and an index of 0 or more"});
  }
  test::expect_refusal([] { (void)approach(contact(rod(12.0)), 0.1, {{0, 5, 0, 0.1, 0.0}}); }, {"(5, 0)", "order 0"});
  refused({{0, 2, 0, 0.1, 0.0}, {0, 2, 0, 0.1, 1.0}}, {"mode (2, 0)", "twice"});
  for (const double bad : {-0.1, nan, infinite}) refused({{0, 2, 0, bad, 0.0}}, {"energy"});
  for (const double bad : {nan, infinite}) refused({{0, 2, 0, 0.1, bad}}, {"phase"});
  test::expect_refusal([&] { (void)approach(wall, 0.0, {}); }, {"speed"});
  const Contact block = contact(sphere(0.3), half_space(HalfSpace{.poisson = 0.3}), 6.0);
  test::expect_refusal([&] { (void)approach(block, 0.1, {{1, 0, 0, 0.1, 0.0}}); }, {"as a whole"});
  EXPECT_NO_THROW((void)approach(block, 0.1, {{0, 2, 0, 0.1, 0.0}}));
  State resting = approach(wall, 0.1, {});
  resting.velocity = 0.0;
  test::expect_refusal([&] { (void)vibration(wall, resting); }, {"velocity"});
  EXPECT_TRUE(keeps(wall, {{0, 2, 0, 0.1, 0.0}}));
  EXPECT_TRUE(keeps(wall, {}));
  EXPECT_FALSE(keeps(wall, {{0, 2, 0, 0.1, 0.0}, {0, 2, 99, 0.1, 0.0}}));
  test::expect_refusal([&] { (void)keeps(wall, {{1, 2, 0, 0.1, 0.0}}); }, {"a wall has no modes"});
}

TEST(VibratingBodies, AccountForAllEnergy) {
  for (const Contact& contact : various_contacts()) {
    if (longest_loss_time(contact) > 0.0) continue;
    const Vibration vibration = some_modes(contact);
    const Impact result = impact_of(contact, 0.1, vibration, {.step = 0.05 / contact.cutoff});
    double given = 1.0, before = 0.0, after = 0.0;
    for (const Oscillation& mode : vibration) given += mode.energy;
    for (const ModeEnergy& mode : result.energy.modes) {
      before += mode.before;
      after += mode.after;
    }
    EXPECT_NEAR(before, (given - 1.0) / given, 1e-12) << name(contact);
    EXPECT_NEAR(after, result.energy.vibration, 1e-12);
    EXPECT_NEAR(result.energy.translation * given, result.restitution * result.restitution, 1e-12);
    const EnergyLedger& ledger = result.energy;
    EXPECT_NEAR(ledger.translation + ledger.vibration + ledger.unresolved + ledger.stored, 1.0, 1e-3);
    EXPECT_NEAR(result.energy_error, 0.0, 1e-3) << name(contact);
  }
}

TEST(VibratingBodies, KnowNoFullTurnsOfThePhase) {
  const Contact ball = contact(sphere(0.3, 9.0));
  const Impact once = impact_of(ball, 0.1, {{0, 2, 0, 0.2, 0.7}});
  for (const double turns : {1.0, -3.0}) {
    const Impact again = impact_of(ball, 0.1, {{0, 2, 0, 0.2, 0.7 + turns * full_turn}});
    EXPECT_NEAR(again.restitution, once.restitution, 1e-9);
  }
  EXPECT_GT(std::abs(impact_of(ball, 0.1, {{0, 2, 0, 0.2, 0.7 + 0.5 * full_turn}}).restitution - once.restitution),
            0.03);
}

TEST(VibratingBodies, ThatAreMirrorImagesAreOneAtAWall) {
  const auto body = std::make_shared<const Body>(disk(0.33, 12.0));
  const Contact wall = contact(body), pair = contact(body, body);
  // Each has half of the energies of both, as shares of ½μv² as at the wall: μ = m/2 at twice the speed is twice ½mv².
  const Impact one = impact_of(wall, 0.05, {{0, 2, 0, 0.1, 1.0}, {0, 3, 0, 0.2, 2.0}});
  const Impact both =
      impact_of(pair, 0.1, {{0, 2, 0, 0.05, 1.0}, {1, 2, 0, 0.05, 1.0}, {0, 3, 0, 0.1, 2.0}, {1, 3, 0, 0.1, 2.0}},
                Resolution(one.resolution));
  // Only their clearances differ, so the touch falls on another phase within a step.
  EXPECT_NEAR(both.restitution, one.restitution, 2e-4);
  EXPECT_NEAR(both.energy.lost_to_first, both.energy.lost_to_second, 1e-12);
  EXPECT_GT(std::abs(one.restitution - impact(wall, 0.05).restitution), 0.02);
}

TEST(VibratingBodies, ConvergeToTheLimitOfFixedImpacts) {
  const Vibration vibration{{0, 2, 0, 0.1, 1.0}, {0, 3, 0, 0.05, 4.0}};
  const RefinableContact ball(sphere(0.3));
  const Restitution limit = restitution(ball, 0.05, {.tolerance = 1e-15, .absolute = 1e-5, .vibration = vibration});
  EXPECT_LE(limit.lost_fraction.error, 1e-5);
  double before = 1.0;
  for (const double cutoff : {12.0, 36.0, 108.0}) {
    const Contact contact = ball.at(cutoff, 1.0, {});
    const double off =
        std::abs(impact_of(contact, 0.05, vibration, {.step = 0.2 / cutoff}).lost_fraction - limit.lost_fraction.value);
    EXPECT_LT(off, before);
    before = off;
  }
  EXPECT_LT(before, 2e-4);
  // The result itself is the last of its runs, repeated.
  EXPECT_TRUE(limit.finest.start.has_value());
  EXPECT_NEAR(limit.runs.back().lost_fraction, limit.finest.lost_fraction, 1e-15);
}

TEST(VibratingBodies, AreFlaggedBeyondSmallStrain) {
  // √(2E/m) = v √share at a wall: 0.1 c at a share of 25.
  const Contact wall = contact(disk(0.33, 8.0));
  EXPECT_FALSE(impact_of(wall, 0.02, {{0, 2, 0, 20.0, 0.0}}).beyond_small_strain);
  EXPECT_TRUE(impact_of(wall, 0.02, {{0, 2, 0, 26.0, 0.0}}).beyond_small_strain);
  // The mode of a second body whose own waves are slower by 2: at a quarter of that speed.
  const Contact pair = test::pair_of(Disk{0.33}, Disk{.poisson = 0.33, .young = 0.25}, 8.0);
  EXPECT_FALSE(impact_of(pair, 0.02, {{1, 2, 0, 10.0, 0.0}}).beyond_small_strain);
  EXPECT_TRUE(impact_of(pair, 0.02, {{1, 2, 0, 13.0, 0.0}}).beyond_small_strain);
}

}  // namespace
}  // namespace stoss
