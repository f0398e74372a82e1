// Impacts of a body that already vibrates or starts elsewhere, several contacts in one impact, and refused input.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "impact/collision.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/vibration.hpp"
#include "support/body_tools.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

State at_rest(const Body& body, double gap, double speed) {
  return {-body.extent - gap, speed, std::vector<double>(mode_count(body), 0.0),
          std::vector<double>(mode_count(body), 0.0)};
}

TEST(StartState, FurtherAwayChangesTheImpactOnlyByTheStep) {
  const Body body = disk(0.33, 25.0);
  const double step = 0.01;
  const Impact near = impact(body, HardWall{}, 0.1, {.resolution = {.step = step}});
  // So many whole steps further away, the touch falls on the same phase within a step.
  const Contact at_wall = contact(body);
  const ContactGrid grid = contact_grid(at_wall, near.resolution.half_width, near.resolution.nodes);
  const Collision beside(at_wall, near.resolution, grid, 0.1, {}, {});
  const double distance = -(beside.snapshot().center + body.extent) + 0.1 * 250 * step;
  const Impact far =
      impact(body, HardWall{}, 0.1, {.resolution = {.step = step}, .start = at_rest(body, distance, 0.1)});
  EXPECT_NEAR(far.restitution, near.restitution, 1e-9);
  EXPECT_EQ(far.steps, near.steps + 250);
}

TEST(StartState, InTheMiddleOfASoftImpactContinuesIt) {
  const Body body = disk(0.33, 12.5);
  constexpr double half_width = 1.0;  // the same for both
  const ExponentialWall wall{100.0, 1.0};
  State middle;
  const ImpactObserver observer = [&](const Snapshot& now) {
    if (middle.velocity > 0.0 || now.velocity > 0.07) return;
    middle = {now.center,
              now.velocity,
              {now.coordinate.begin(), now.coordinate.end()},
              {now.momentum.begin(), now.momentum.end()}};
  };
  const Impact whole = impact(
      body, wall, 0.1, {.resolution = {.step = 0.01, .nodes = 128, .half_width = half_width, .tail = Tail::none}},
      {.observer = observer, .modes = true});
  ASSERT_GT(middle.velocity, 0.01);
  ASSERT_LT(middle.velocity, 0.09);
  const Impact rest = impact(
      body, wall, middle.velocity,
      {.resolution = {.step = 0.01, .nodes = 128, .half_width = half_width, .tail = Tail::none}, .start = middle});
  EXPECT_LT(rest.steps, whole.steps);
  EXPECT_NEAR(rest.final_state.velocity, whole.final_state.velocity, 1e-10);
  for (std::size_t k = 0; k < middle.momentum.size(); ++k) {
    // Both ledgers in the same unit, the energy of the flight after the impact.
    EXPECT_NEAR(rest.energy.modes[k].after / rest.energy.translation,
                whole.energy.modes[k].after / whole.energy.translation, 1e-9);
  }
}

TEST(StartState, MayPartSoSlowlyThatClearingTheWallTakesLongerThanAnyContact) {
  // A slow body that vibrates with all its modes is thrown back 22 times as fast. Run backwards, it parts as slowly.
  const Contact at_wall = contact(disk(0.33, 4.5));
  Vibration vibrating;
  for (const ModeGroup& group : at_wall.groups) {
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      const int index = group.index.empty() ? static_cast<int>(l) : group.index[l];
      const double phase = 1.7 * static_cast<double>(vibrating.size());
      vibrating.push_back({.order = group.order, .index = index, .energy = 1e5, .phase = phase});
    }
  }
  const Resolution all_energy_kept{.tail = Tail::quasistatic};
  const Impact forth =
      impact(at_wall, 2e-4, {.resolution = all_energy_kept, .start = approach(at_wall, 2e-4, vibrating)});
  EXPECT_GT(forth.restitution, 20.0);
  State start = forth.final_state;
  start.velocity = -start.velocity;
  for (double& momentum : start.momentum) momentum = -momentum;
  const Resolution same(forth.resolution);
  const Impact back = impact(at_wall, start.velocity, {.resolution = same, .start = start});
  EXPECT_NEAR(back.restitution * forth.restitution, 1.0, 1e-4);
  EXPECT_GT(static_cast<double>(back.steps) * back.resolution.step, 1000.0);  // R/c
}

TEST(StartState, IsRefusedIfItDoesNotFitOrTouches) {
  const Body body = disk(0.33, 12.5);
  State wrong = at_rest(body, 0.1, 0.1);
  wrong.coordinate.pop_back();
  test::expect_refusal([&] { (void)impact(body, HardWall{}, 0.1, {.start = wrong}); },
                       {"start", std::to_string(mode_count(body))});
  for (const Tail tail : {Tail::radiating, Tail::quasistatic}) {
    const std::string message = test::message_of<InvalidInput>([&] {
      (void)impact(body, HardWall{}, 0.1, {.resolution = {.tail = tail}, .start = at_rest(body, -0.1, 0.1)});
    });
    EXPECT_NE(message.find("start"), std::string::npos) << message;
  }
}

TEST(StartState, IsRefusedIfItIsNotANumber) {
  const Body body = disk(0.33, 12.5);
  const double nan = std::nan("");
  for (const auto& [wall, tail] : test::every_wall) {
    State center = at_rest(body, 0.1, 0.1), coordinate = center, momentum = center;
    center.center = nan;
    coordinate.coordinate[3] = nan;
    momentum.momentum[3] = nan;
    for (const State& start : {center, coordinate, momentum}) {
      EXPECT_THROW((void)impact(body, wall, 0.1, {.resolution = {.tail = tail}, .start = start}), InvalidInput)
          << "wall " << wall.index();
    }
  }
}

TEST(SecondContact, IsPartOfTheImpact) {
  // At ν = 0.33 and v = 0.45 the edge comes back once more while the disk leaves.
  const Body body = disk(0.33, 50.0);
  int begun = 0;
  bool touching = false;
  double after_first = 0.0;
  const ImpactObserver observer = [&](const Snapshot& now) {
    if (now.force > 0.0 && !touching) ++begun;
    if (now.force == 0.0 && touching && begun == 1) after_first = now.velocity;
    touching = now.force > 0.0;
  };
  const Impact result = impact(body, HardWall{}, 0.45, {}, {observer});
  EXPECT_EQ(begun, result.contacts);
  EXPECT_GE(result.contacts, 2);
  EXPECT_LT(after_first, 0.0);
  EXPECT_LT(result.final_state.velocity, after_first);  // it is pushed once more
}

TEST(ImpactInput, RefusesSpeedsOutOfRange) {
  const Body body = rod(10.0);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -0.1, 1.0001, 1e9, 1e-9, std::nan(""), infinity}) {
    test::expect_refusal([&] { (void)impact(body, HardWall{}, bad); }, {"speed", "got", "1e-8 to 1"});
  }
}

TEST(ImpactInput, RefusesOptionsOutOfRange) {
  const Body body = disk(0.33, 12.5);
  for (const double bad : {-0.01, 0.0, 1.0, std::nan(""), 1e-12}) {
    test::expect_refusal([&] { (void)impact(body, HardWall{}, 0.1, {.resolution = {.step = bad}}); }, {"step", "got"});
  }
  for (const int bad : {-1, 0, 5000}) {
    test::expect_refusal([&] { (void)impact(body, HardWall{}, 0.1, {.resolution = {.nodes = bad}}); },
                         {"nodes", "got", "to 4096"});
  }
  for (const int bad : {0, -3}) {
    test::expect_refusal([&] { (void)impact(body, HardWall{}, 0.1, {}, {.every = bad}); }, {"every", "got"});
  }
}

}  // namespace
}  // namespace stoss
