// A body with some of its modes: the paper's choice of the most energetic ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/replay.hpp"
#include "support/body_tools.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

constexpr double speed = 0.1;
const ExponentialWall soft{100.0, 1.0};
const ImpactOptions kept_alone{.resolution = {.tail = Tail::none}};

std::vector<ModeEnergy> energies(const Body& body) { return impact(body, soft, speed, kept_alone).energy.modes; }

TEST(ModeSelection, OfAllModesIsTheBodyItself) {
  const Body body = disk(0.33, 12.5);
  const Body same = with_modes(body, std::vector<bool>(mode_count(body), true));
  EXPECT_EQ(same.name, body.name);
  const Impact expected = impact(body, soft, speed, kept_alone), found = impact(same, soft, speed, kept_alone);
  EXPECT_EQ(found.restitution, expected.restitution);
  EXPECT_EQ(found.final_state.coordinate, expected.final_state.coordinate);
  EXPECT_NO_THROW((void)impact(same, HardWall{}, speed));
}

TEST(ModeSelection, HoldsTheChosenModesWithTheirNames) {
  const Body body = disk(0.33, 12.5);
  const std::vector<ModeEnergy> all = energies(body);
  std::vector<bool> keep;
  for (const ModeEnergy& mode : all) keep.push_back(mode.order != 1 && mode.index % 2 == 1);
  const Body some = with_modes(body, keep);
  EXPECT_EQ(some.cutoff, body.cutoff);
  EXPECT_NE(some.name, body.name);
  EXPECT_NO_THROW(validate(some));
  const std::vector<ModeEnergy> found = energies(some);
  std::size_t k = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!keep[i]) continue;
    ASSERT_LT(k, found.size());
    EXPECT_EQ(found[k].order, all[i].order);
    EXPECT_EQ(found[k].index, all[i].index);
    EXPECT_EQ(found[k].omega, all[i].omega);
    ++k;
  }
  EXPECT_EQ(k, found.size());
  EXPECT_EQ(mode_count(some), k);
}

TEST(ModeSelection, MayBeMadeTwice) {
  const Body body = disk(0.33, 12.5);
  std::vector<bool> odd(mode_count(body)), third;
  for (std::size_t i = 1; i < odd.size(); i += 2) odd[i] = true;
  const Body once = with_modes(body, odd);
  for (std::size_t i = 0; i < mode_count(once); ++i) third.push_back(i % 3 == 0);
  std::vector<bool> both(odd.size());
  for (std::size_t i = 1; i < odd.size(); i += 6) both[i] = true;
  const std::vector<ModeEnergy> expected = energies(with_modes(body, both)), found = energies(with_modes(once, third));
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k].order, expected[k].order);
    EXPECT_EQ(found[k].index, expected[k].index);
    EXPECT_EQ(found[k].after, expected[k].after);
  }
}

TEST(ModeSelection, OfAllBelowALowerCutoffIsTheBodyOfThatCutoff) {
  const Body high = disk(0.33, 25.0), low = disk(0.33, 12.5);
  std::vector<bool> keep;
  for (const ModeGroup& group : high.groups) {
    for (const double omega : group.omega) keep.push_back(omega <= low.cutoff);
  }
  // Only where a step belongs to both are they the same motion.
  const ImpactOptions options{.resolution = {.step = 0.002, .nodes = 128, .half_width = 0.8, .tail = Tail::none}};
  const Impact expected = impact(low, soft, speed, options);
  const Impact found = impact(with_modes(high, keep), soft, speed, options);
  EXPECT_NEAR(found.restitution, expected.restitution, 1e-12);
}

TEST(ModeSelection, IsRefusedByAHardWall) {
  const Body body = disk(0.33, 12.5);
  std::vector<bool> keep(mode_count(body), true);
  keep.back() = false;
  const Body most = with_modes(body, keep);
  for (const Tail tail : {Tail::radiating, Tail::quasistatic}) {
    test::expect_refusal([&] { (void)impact(most, HardWall{}, speed, {.resolution = {.tail = tail}}); },
                         {"body", "hard wall", most.name});
  }
  const ContactGrid grid = test::grid_of(most, 0.3, 32);
  test::expect_refusal([&] { (void)most.residual_compliance(grid.points, {}); }, {"exponential"});
  test::expect_refusal([&] { (void)most.residual_second_moment(grid.points, {}); }, {"exponential"});
}

TEST(ModeSelection, RefusesFlagsThatDoNotFit) {
  const Body body = disk(0.33, 12.5);
  const std::size_t all = mode_count(body);
  for (const std::size_t count : {std::size_t{0}, all - 1, all + 1}) {
    test::expect_refusal([&] { (void)with_modes(body, std::vector<bool>(count, true)); },
                         {"keep", std::to_string(count), std::to_string(all)});
  }
  test::expect_refusal([&] { (void)with_modes(body, std::vector<bool>(all)); }, {"keep", "got 0 of"});
  Body flawed = body;
  flawed.groups[0].index = {0};
  test::expect_refusal([&] { validate(flawed); }, {"indices"});
}

TEST(ModeSelection, IsAnotherBodyToLookAt) {
  const Body body = disk(0.33, 12.5);
  std::vector<bool> first(mode_count(body), true), last = first;
  first.front() = false;
  last.back() = false;
  const Body some = with_modes(body, first);
  const Impact result = impact(some, soft, speed, kept_alone);
  EXPECT_NO_THROW((void)frames_at(contact(some, soft), result, {1.0}));
  test::expect_refusal([&] { (void)frames_at(contact(body, soft), result, {1.0}); }, {"body"});
  // As many modes, and the same name, but others.
  test::expect_refusal([&] { (void)frames_at(contact(with_modes(body, last), soft), result, {1.0}); }, {"body"});
}

}  // namespace
}  // namespace stoss
