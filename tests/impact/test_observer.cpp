// What the observer sees, what ends an impact, and impacts of a body that already vibrates.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/impact/impact.hpp"
#include "support/body_tools.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

std::vector<Snapshot> watch(const Body& body, const Wall& wall, double speed, Tail tail, Impact* result,
                            int every = 1) {
  std::vector<Snapshot> seen;
  const ImpactObserver observer = [&](const Snapshot& now) {
    seen.push_back(now);
    seen.back().coordinate = seen.back().momentum = {};
  };
  *result = impact(body, wall, speed, {.resolution = {.tail = tail}}, {.observer = observer, .every = every});
  return seen;
}

class Observer : public ::testing::TestWithParam<test::WallCase> {
 protected:
  const Body body = disk(0.33, 12.5);
  const Wall wall = GetParam().wall;
  const Tail tail = GetParam().tail;
};

TEST_P(Observer, SeesAConsistentMotion) {
  Impact result;
  const auto seen = watch(body, wall, 0.1, tail, &result);
  ASSERT_EQ(seen.size(), static_cast<std::size_t>(result.steps) + 1);
  double largest_force = 0.0, deepest = -1.0, widest = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Snapshot& now = seen[i];
    EXPECT_NEAR(now.time, static_cast<double>(i) * result.resolution.step, 1e-12);
    EXPECT_GE(now.force, 0.0);
    EXPECT_NEAR(now.translation, now.velocity * now.velocity / 0.01, 1e-6);
    // In contact the tail has energy of its own, which the radiating one counts as unresolved.
    EXPECT_NEAR(now.translation + now.vibration + now.stored + now.unresolved, 1.0, 2e-3) << "time " << now.time;
    if (i > 0) largest_force = std::max(largest_force, 0.5 * (seen[i - 1].force + now.force));
    deepest = std::max(deepest, now.center + body.extent);
    widest = std::max(widest, now.contact_half_width);
  }
  EXPECT_NEAR(seen.front().velocity, 0.1, 1e-9);
  EXPECT_NEAR(seen.front().vibration, 0.0, 1e-12);
  EXPECT_EQ(seen.back().velocity, result.final_state.velocity);
  EXPECT_EQ(seen.back().center, result.final_state.center);
  EXPECT_EQ(seen.back().translation, result.energy.translation);
  EXPECT_EQ(seen.back().unresolved, result.energy.unresolved);
  EXPECT_NEAR(seen.back().vibration, result.energy.vibration, 1e-14);
  // The maximum values are tops of parabolas through the samples; compression counts from the touch of the continuous
  // surface, h²/24 before that of the centre's position.
  const double spacing = result.resolution.half_width / result.resolution.nodes;
  EXPECT_GE(result.max_force, largest_force);
  EXPECT_LT(result.max_force, 1.003 * largest_force);
  EXPECT_GE(result.max_compression, deepest);
  EXPECT_LT(result.max_compression, deepest + spacing * spacing / 20.0 + 1e-6);
  EXPECT_GE(result.max_half_width, widest);
  EXPECT_LT(result.max_half_width, 1.003 * widest);
}

TEST_P(Observer, ChangesNothing) {
  Impact seen;
  (void)watch(body, wall, 0.1, tail, &seen);
  const Impact unseen = impact(body, wall, 0.1, {.resolution = {.tail = tail}});
  EXPECT_EQ(seen.restitution, unseen.restitution);
  EXPECT_EQ(seen.steps, unseen.steps);
  EXPECT_EQ(seen.final_state.momentum, unseen.final_state.momentum);
}

TEST_P(Observer, IsCalledEverySoManySteps) {
  Impact result;
  const auto all = watch(body, wall, 0.1, tail, &result);
  const auto some = watch(body, wall, 0.1, tail, &result, 7);
  ASSERT_EQ(some.size(), (all.size() - 1) / 7 + 1 + ((all.size() - 1) % 7 == 0 ? 0 : 1));
  for (std::size_t i = 0; i + 1 < some.size(); ++i) {
    EXPECT_EQ(some[i].time, all[7 * i].time);
    EXPECT_EQ(some[i].velocity, all[7 * i].velocity);
    EXPECT_EQ(some[i].force, all[7 * i].force);
  }
  EXPECT_EQ(some.back().time, all.back().time);
}

TEST_P(Observer, SeesTheFirstInstantAndThoseThatAreWanted) {
  Impact result;
  const auto all = watch(body, wall, 0.1, tail, &result);
  std::vector<double> seen;
  const double half = 0.5 * all.back().time;
  (void)impact(body, wall, 0.1, {.resolution = {.tail = tail}},
               {.observer = [&](const Snapshot& now) { seen.push_back(now.time); },
                .wanted = [half](double time) { return time > half; }});
  std::vector<double> wanted;
  for (const Snapshot& each : all) {
    if (wanted.empty() || each.time > half) wanted.push_back(each.time);
  }
  EXPECT_EQ(seen, wanted);
}

TEST_P(Observer, GetsTheModesOnRequest) {
  bool without = true;
  (void)impact(body, wall, 0.1, {.resolution = {.tail = tail}},
               {[&](const Snapshot& now) { without = without && now.coordinate.empty(); }});
  EXPECT_TRUE(without);
  const double initial = 0.5 * body.mass * 0.01;
  std::vector<double> coordinate, momentum;
  const ImpactObserver observer = [&](const Snapshot& now) {
    ASSERT_EQ(now.coordinate.size(), mode_count(body));
    ASSERT_EQ(now.momentum.size(), mode_count(body));
    double energy = 0.0;
    std::size_t k = 0;
    for (const ModeGroup& group : body.groups) {
      for (const double omega : group.omega) {
        energy += 0.5 * now.momentum[k] * now.momentum[k] / body.mass +
                  0.5 * body.mass * omega * omega * now.coordinate[k] * now.coordinate[k];
        ++k;
      }
    }
    EXPECT_NEAR(energy / initial, now.vibration, 1e-12);
    double force = 0.0;
    for (const double share : now.node_force) {
      EXPECT_GE(share, 0.0);
      force += share;
    }
    EXPECT_NEAR(force, now.force, 1e-12);
    coordinate.assign(now.coordinate.begin(), now.coordinate.end());
    momentum.assign(now.momentum.begin(), now.momentum.end());
  };
  const Impact result =
      impact(body, wall, 0.1, {.resolution = {.tail = tail}}, {.observer = observer, .every = 5, .modes = true});
  EXPECT_EQ(coordinate, result.final_state.coordinate);
  EXPECT_EQ(momentum, result.final_state.momentum);
}

TEST_P(Observer, ThrowsThroughTheImpact) {
  int calls = 0;
  const std::string message = test::message_of<std::domain_error>([&] {
    const ImpactObserver observer = [&](const Snapshot&) {
      if (++calls == 10) throw std::domain_error("enough");
    };
    (void)impact(body, wall, 0.1, {.resolution = {.tail = tail}}, {observer});
  });
  EXPECT_EQ(message, "enough");
  EXPECT_EQ(calls, 10);
}

TEST_P(Observer, MeanEnergiesAreThoseOfTheContact) {
  if (std::holds_alternative<ExponentialWall>(wall)) GTEST_SKIP() << "a soft wall has no first instant of contact";
  const double initial = 0.5 * body.mass * 0.01;
  std::vector<double> mean(mode_count(body), 0.0);
  int samples = 0;
  const ImpactObserver observer = [&](const Snapshot& now) {
    if (now.force == 0.0) return;
    ++samples;
    std::size_t k = 0;
    for (const ModeGroup& group : body.groups) {
      for (const double omega : group.omega) {
        mean[k] += 0.5 * now.momentum[k] * now.momentum[k] / body.mass +
                   0.5 * body.mass * omega * omega * now.coordinate[k] * now.coordinate[k];
        ++k;
      }
    }
  };
  const Impact result = impact(body, wall, 0.1, {.resolution = {.tail = tail}}, {.observer = observer, .modes = true});
  double average = 0.0;
  for (std::size_t k = 0; k < mean.size(); ++k) {
    // The engine may look at some of the steps only.
    const double expected = mean[k] / (samples * initial);
    EXPECT_NEAR(result.energy.modes[k].average, expected, 0.01 * expected + 1e-6) << k;
    average += result.energy.modes[k].average;
  }
  // During contact the modes hold more than afterwards, but never more than all.
  EXPECT_GT(average, result.energy.vibration);
  EXPECT_LT(average, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Walls, Observer, ::testing::ValuesIn(test::every_wall));

TEST(ImpactResult, CarriesItsInputs) {
  const Body body = disk(0.33, 12.5);
  const Impact result = impact(body, ExponentialWall{321.0, 2.0}, 0.07,
                               {.resolution = {.step = 0.004, .nodes = 150, .tail = Tail::none}});
  EXPECT_EQ(result.contact, body.name);
  EXPECT_NE(result.contact.find("0.33"), std::string::npos);
  ASSERT_TRUE(std::holds_alternative<ExponentialWall>(result.wall));
  EXPECT_EQ(std::get<ExponentialWall>(result.wall).hardness, 321.0);
  EXPECT_EQ(result.speed, 0.07);
  EXPECT_EQ(result.cutoff, 12.5);
  EXPECT_EQ(result.resolution.step, 0.004);
  EXPECT_EQ(result.resolution.nodes, 150);
  const Impact usual = impact(body, HardWall{}, 0.07);
  EXPECT_EQ(usual.resolution.step, fixed_resolution(contact(body, HardWall{}), 0.07).step);
  EXPECT_EQ(usual.resolution.nodes, fixed_resolution(contact(body, HardWall{}), 0.07).nodes);
}

}  // namespace
}  // namespace stoss
