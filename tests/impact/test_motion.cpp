// An impact looked at again: the frames are the impact's own instants, and in free flight energy and momentum stay.
#include "stoss/impact/replay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

TEST(Motion, IsTheImpactItself) {
  const Body body = disk(0.33, 12.5);
  const Impact result = impact(body, HardWall{}, 0.1);
  std::vector<double> centers, forces;
  const ImpactObserver observer = [&](const Snapshot& now) {
    centers.push_back(now.center);
    forces.push_back(now.force);
  };
  (void)impact(body, HardWall{}, 0.1, {}, {observer});
  std::vector<double> times;
  for (std::size_t i = 0; i < centers.size(); i += 7) times.push_back(static_cast<double>(i) * result.resolution.step);
  const std::vector<Frame> frames = motion(contact(body), result, times);
  ASSERT_EQ(frames.size(), times.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].time, times[i]);
    EXPECT_EQ(frames[i].state.center, centers[7 * i]);
    EXPECT_EQ(frames[i].force, forces[7 * i]);
    double force = 0.0;
    for (const double share : frames[i].node_force) force += share;
    EXPECT_NEAR(force, frames[i].force, 1e-12);
  }
}

TEST(Motion, GoesToTheNearestStep) {
  const Body body = disk(0.33, 12.5);
  const Impact result = impact(body, HardWall{}, 0.1);
  const std::vector<Frame> frames =
      motion(contact(body), result,
             {10.4 * result.resolution.step, 10.6 * result.resolution.step, 10.6 * result.resolution.step});
  EXPECT_DOUBLE_EQ(frames[0].time, 10.0 * result.resolution.step);
  EXPECT_DOUBLE_EQ(frames[1].time, 11.0 * result.resolution.step);
  EXPECT_DOUBLE_EQ(frames[2].time, 11.0 * result.resolution.step);
}

TEST(Motion, IsFreeBeforeAndAfter) {
  const Body body = disk(0.33, 12.5);
  const Impact result = impact(body, HardWall{}, 0.1);
  const double end = static_cast<double>(result.steps) * result.resolution.step;
  const std::vector<Frame> frames = motion(contact(body), result, {-2.0, 0.0, end, end + 3.0});
  EXPECT_NEAR(frames[0].state.center, frames[1].state.center - 0.2, 1e-12);
  for (const double coordinate : frames[0].state.coordinate) EXPECT_EQ(coordinate, 0.0);
  EXPECT_EQ(frames[2].state.coordinate, result.final_state.coordinate);
  EXPECT_NEAR(frames[3].state.center, frames[2].state.center + 3.0 * result.final_state.velocity, 1e-12);
  EXPECT_EQ(frames[3].force, 0.0);
  // Energies of the modes stay, mode by mode.
  std::size_t k = 0;
  for (const ModeGroup& group : body.groups) {
    for (const double omega : group.omega) {
      const auto energy = [&](const State& state) {
        return std::pow(state.momentum[k] / body.mass, 2) + std::pow(omega * state.coordinate[k], 2);
      };
      EXPECT_NEAR(energy(frames[3].state), energy(frames[2].state), 1e-14);
      ++k;
    }
  }
}

TEST(Motion, FreeMotionGoesBothWays) {
  const Body body = disk(0.33, 12.5);
  const State state = impact(body, HardWall{}, 0.1).final_state;
  const State back = free_motion(contact(body), free_motion(contact(body), state, 5.0), -5.0);
  EXPECT_NEAR(back.center, state.center, 1e-14);
  for (std::size_t k = 0; k < state.coordinate.size(); ++k) {
    EXPECT_NEAR(back.coordinate[k], state.coordinate[k], 1e-14);
    EXPECT_NEAR(back.momentum[k], state.momentum[k], 1e-12);
  }
}

TEST(Motion, FreeMotionTurnsEachModeAtItsFrequency) {
  const Body body = disk(0.33, 12.5);
  const State state = impact(body, HardWall{}, 0.1).final_state;
  const double time = 0.7;
  const State later = free_motion(contact(body), state, time);
  EXPECT_EQ(later.velocity, state.velocity);
  std::size_t k = 0;
  for (const ModeGroup& group : body.groups) {
    for (const double omega : group.omega) {
      const double c = std::cos(omega * time), s = std::sin(omega * time), inertia = body.mass * omega;
      EXPECT_NEAR(later.coordinate[k], c * state.coordinate[k] + s * state.momentum[k] / inertia, 1e-14);
      EXPECT_NEAR(later.momentum[k], c * state.momentum[k] - s * state.coordinate[k] * inertia, 1e-12);
      ++k;
    }
  }
}

TEST(Motion, OfARodHasOneNode) {
  const Body body = rod(40.0);
  const Impact result = impact(body, HardWall{}, 0.1);
  const std::vector<Frame> frames = motion(contact(body), result, {0.5, 1.0, 100.0});
  ASSERT_EQ(frames[1].node_force.size(), 1U);
  EXPECT_NEAR(frames[1].node_force[0], frames[1].force, 1e-15);
  EXPECT_EQ(frames[2].node_force, std::vector<double>{0.0});
}

TEST(Motion, RefusesWhatDoesNotFit) {
  const Body body = disk(0.33, 12.5);
  const Impact result = impact(body, HardWall{}, 0.1);
  test::expect_refusal([&] { (void)motion(contact(disk(0.33, 15.0)), result, {0.0}); }, {"body"});
  test::expect_refusal([&] { (void)motion(contact(disk(0.3, 12.5)), result, {0.0}); }, {"body"});
  test::expect_refusal([&] { (void)motion(contact(body), result, {1.0, 0.5}); }, {"time", "ascend"});
  test::expect_refusal([&] { (void)motion(contact(body), result, {std::nan("")}); }, {"time", "nan"});
  test::expect_refusal([&] { (void)motion(contact(body), result, {1e300}); }, {"time"});
  EXPECT_TRUE(motion(contact(body), result, {}).empty());
}

}  // namespace
}  // namespace stoss
