// What is chosen only for the computation: grid, units, order of the modes, thread.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <thread>
#include <utility>

#include "identities/identity.hpp"
#include "support/body_tools.hpp"

namespace stoss::test {
namespace {

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
  EXPECT_EQ(a.energy.dissipated, b.energy.dissipated);
  EXPECT_EQ(a.energy.lost_to_first, b.energy.lost_to_first);
  EXPECT_EQ(a.energy.lost_to_second, b.energy.lost_to_second);
}

}  // namespace

TEST_P(Identity, GridDoesNotMatter) {
  if (is_rod(its)) GTEST_SKIP() << "a rod has a single point of contact";
  // On a soft wall the nodes integrate a smooth pressure, which needs a grid that resolves 1/√α.
  const int coarse = its.soft ? 192 : 64, fine = its.soft ? 288 : 96;
  const Impact a = impact(contact, its.speed, {.resolution = {.step = step, .nodes = coarse, .tail = its.tail}});
  const Impact b = impact(contact, its.speed, {.resolution = {.step = step, .nodes = fine, .tail = its.tail}});
  // Without damping the nodes at the edge of a fast contact rattle, which costs the static tail a digit.
  const double rattle = has_static_tail() ? its.speed : 0.0;
  // What a node that leaves dissipates, 9/n² at most (docs/theory/loss.md).
  const double relaxed = (its.soft ? 1e-5 : 2e-3) * a.energy.dissipated;
  EXPECT_NEAR(a.lost_fraction, b.lost_fraction, (its.soft ? 1e-9 : 5e-5 + 1e-3 * rattle) + relaxed);
  // Extrema are those of the steps, which on another grid fall on other instants.
  EXPECT_NEAR(a.max_force / b.max_force, 1.0, 1e-3 + 1e-2 * rattle);
  EXPECT_NEAR(a.max_compression, b.max_compression, 1e-4 * std::abs(b.max_compression));
}

TEST_P(Identity, DescriptionAndThreadDoNotMatter) {
  const Impact straight = run();
  Impact first, second;
  std::thread one([&] { first = run(); });
  std::thread two([&] { second = run(); });
  one.join();
  two.join();
  expect_same_bits(first, straight);
  expect_same_bits(second, straight);

  const Impact there = run(in_units(its, 3e-3, 7.3e10, 2400.0));
  EXPECT_NEAR(there.restitution, straight.restitution, 1e-10);
  EXPECT_NEAR(there.contact_time, straight.contact_time, 1e-9);
  EXPECT_NEAR(there.max_force, straight.max_force, 1e-9 * straight.max_force);
  EXPECT_NEAR(there.max_compression, straight.max_compression, 1e-9 * std::abs(straight.max_compression));
  EXPECT_NEAR(there.energy.lost_to_first, straight.energy.lost_to_first, 1e-10);

  // The order of the modes.
  const auto turned = [&](const Contact& before) {
    Body first = reversed(*before.first);
    return before.second ? stoss::contact(std::move(first), reversed(*before.second))
                         : stoss::contact(std::move(first), before.wall);
  };
  const Impact backward = impact(turned(contact), its.speed, {.resolution = {.step = step, .tail = its.tail}});
  EXPECT_NEAR(backward.restitution, straight.restitution, 1e-9);
  EXPECT_NEAR(backward.max_force / straight.max_force, 1.0, 1e-9);
  ASSERT_EQ(backward.energy.modes.size(), straight.energy.modes.size());
  const std::size_t of_first = mode_count(*contact.first), all = straight.energy.modes.size();
  for (std::size_t k = 0; k < all; ++k) {
    const ModeEnergy& a = straight.energy.modes[k];
    const ModeEnergy& b = backward.energy.modes[(k < of_first ? of_first : all + of_first) - 1 - k];
    EXPECT_EQ(a.body, b.body);
    EXPECT_EQ(a.order, b.order);
    EXPECT_EQ(a.omega, b.omega);
    EXPECT_NEAR(a.after, b.after, 1e-9);
    EXPECT_NEAR(a.average, b.average, 1e-9);
  }
}

namespace {

std::string case_name(const ::testing::TestParamInfo<Case>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Every, Identity, ::testing::ValuesIn(all_cases()), case_name);
INSTANTIATE_TEST_SUITE_P(Every, IdentityOfPairs, ::testing::ValuesIn(pairs()), case_name);
INSTANTIATE_TEST_SUITE_P(Every, IdentityOfEqualBodies, ::testing::ValuesIn(equal_pairs()), case_name);
INSTANTIATE_TEST_SUITE_P(Every, IdentityOfSoftWalls, ::testing::ValuesIn(soft_walls()), case_name);

}  // namespace
}  // namespace stoss::test
