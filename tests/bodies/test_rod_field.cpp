// The field inside a rod: its static answer in closed form, and the wave of an impact.
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/rod/field.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/replay.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

using bodies::rod::field;
using bodies::rod::Field;
using test::expect_refusal;

TEST(RodField, IsStaticWithoutAMotionOfItsModes) {
  const Body body = rod(100.0);
  constexpr double force = 0.3;
  std::vector<double> still;
  for (const double omega : body.groups.front().omega) {
    still.push_back(-std::numbers::sqrt2 * force / (omega * omega));
  }
  const Field now = field(body, still, force, {0.0, 0.25, 1.0});
  // Accelerated as a whole: σ grows linearly from the free end, and the centre of mass stays.
  EXPECT_NEAR(now.stress[0], -force, 1e-12);
  EXPECT_NEAR(now.stress[1], -0.75 * force, 1e-12);
  EXPECT_NEAR(now.stress[2], 0.0, 1e-12);
  EXPECT_NEAR(now.displacement[0], -force / 3.0, 1e-12);
  EXPECT_NEAR(now.displacement[2], force / 6.0, 1e-12);
}

TEST(RodField, CarriesAWaveOfConstantStressFromTheWall) {
  const Contact meeting = contact(rod(1000.0));
  constexpr double speed = 0.1, time = 0.5;
  const Impact hit = impact(meeting, speed);
  const std::vector<Frame> frames = frames_at(meeting, hit, {time});
  const ContactGrid grid = contact_grid(meeting, hit.resolution.half_width, hit.resolution.nodes);
  const BodyFrame seen = seen_by(meeting, grid, frames.front(), 0);
  const Field now = field(*seen.body, seen.coordinate, seen.node_force.front(), {0.0, 0.2, 0.4, 0.6, 0.8});
  for (const unsigned behind : {0U, 1U, 2U}) EXPECT_NEAR(now.stress[behind], -speed, 0.02 * speed) << behind;
  for (const unsigned ahead : {3U, 4U}) EXPECT_NEAR(now.stress[ahead], 0.0, 0.02 * speed) << ahead;
  EXPECT_NEAR(seen.center + 0.5 + now.displacement[0], 0.0, 1e-3 * speed);
}

TEST(RodField, RefusesWhatIsNotOfTheRod) {
  const Body body = rod(4.0);
  expect_refusal([&] { (void)field(body, std::vector<double>{0.0, 0.0}, 0.0, {0.0}); }, {"coordinate"});
  expect_refusal([&] { (void)field(body, std::vector<double>{0.0}, 0.0, {1.5}); }, {"place: got 1.5"});
}

}  // namespace
}  // namespace stoss
