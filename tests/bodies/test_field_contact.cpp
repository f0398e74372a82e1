// The field in an impact: the edge is free outside the contact, and the nodes in contact are at the wall.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/field.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"
#include "support/body_tools.hpp"
#include "support/field_tools.hpp"

namespace stoss {
using namespace bodies::disk;

namespace {

using std::numbers::pi;

/// An impact at the instant of its maximum force.
class FieldInAnImpact : public ::testing::TestWithParam<Tail> {
 protected:
  const Body body = disk(0.33, 25.0);
  ContactGrid contact;
  std::vector<double> coordinate, force;
  double center = 0.0, total = 0.0, half_width = 0.0;

  void SetUp() override { collide(0.1); }

  void collide(double speed) {
    total = 0.0;
    const ImpactObserver observer = [&](const Snapshot& now) {
      if (now.force <= total) return;
      total = now.force;
      center = now.center;
      half_width = now.contact_half_width;
      coordinate.assign(now.coordinate.begin(), now.coordinate.end());
      force.assign(now.node_force.begin(), now.node_force.end());
    };
    const Impact result =
        impact(body, HardWall{}, speed, {.resolution = {.tail = GetParam()}}, {.observer = observer, .modes = true});
    contact = test::grid_of(body, result.resolution.half_width, result.resolution.nodes);
  }

  [[nodiscard]] Field on_edge(const std::vector<double>& angle) const {
    return DiskField(0.33, body, contact.points, {{1.0}, angle}).at(coordinate, force);
  }
};

TEST_P(FieldInAnImpact, PressesOnTheNodesInContactAndNowhereElse) {
  const std::vector<double>& phi = contact.coordinate;
  const double spacing = 2.0 * phi.front();
  const Field nodes = on_edge(phi);
  double peak = 0.0;
  for (std::size_t i = 0; i < phi.size(); ++i) {
    const double pressure = 0.5 * pi * force[i] / spacing;  // a node and its mirror image share the force
    EXPECT_NEAR(nodes.stress_rr[i], -pressure * std::cos(phi[i]), 1e-14) << i;
    EXPECT_NEAR(nodes.stress_rp[i], pressure * std::sin(phi[i]), 1e-14) << i;
    peak = std::max(peak, pressure);
  }
  EXPECT_GT(peak, 0.2);
  // Between the nodes the band-limited pressure rings from where it ends, like a square root: 2 % of the peak one node
  // beyond, 0.05 % at twice the half-width of the contact.
  const int count = 8 * static_cast<int>(std::lround(pi / spacing));
  const std::vector<double> turn = test::whole_turn(count);
  const Field edge = on_edge(turn);
  double pull = 0.0, near = 0.0, far = 0.0;
  for (std::size_t i = 0; i < turn.size(); ++i) {
    const double angle = std::abs(std::remainder(turn[i], 2.0 * pi));
    const double traction = std::hypot(edge.stress_rr[i], edge.stress_rp[i]) / peak;
    if (angle > half_width + spacing) near = std::max(near, traction);
    if (angle > 2.0 * half_width) far = std::max(far, traction);
    pull += (edge.stress_rr[i] * std::cos(turn[i]) - edge.stress_rp[i] * std::sin(turn[i])) * 2.0 * pi / count;
  }
  EXPECT_LT(near, 0.025);
  EXPECT_LT(far, 5e-4);
  EXPECT_NEAR(pull, -pi * total, 1e-13);  // Newton
}

TEST_P(FieldInAnImpact, HasTheNodesInContactAtTheWallButForTheLastTwo) {
  // To rounding with the quasistatic tail, which is what the field has for the modes that are not kept. The radiating
  // tail also has inertia and damping: 4e-4 of the compression here, and less with a higher cutoff.
  const double level = GetParam() == Tail::quasistatic ? 1e-14 : 1e-4;
  const Field field = on_edge(contact.coordinate);
  const auto touching =
      static_cast<std::size_t>(std::count_if(force.begin(), force.end(), [](double f) { return f > 0.0; }));
  for (std::size_t i = 0; i < force.size(); ++i) {
    const double phi = contact.coordinate[i];
    const double x =
        center + 1.0 - contact.recess[i] + field.radial[i] * std::cos(phi) - field.tangential[i] * std::sin(phi);
    if (i + 2 < touching) {
      EXPECT_NEAR(x, 0.0, level) << i;
    }
    EXPECT_LT(x, level) << i;
  }
  EXPECT_GT(touching, 20U);
}

TEST_P(FieldInAnImpact, HasItsGreatestShearBelowTheSurface) {
  // As in a Hertzian contact, which a slow one is: at a depth of 0.786 half-widths, 0.300 of the peak pressure
  // (Johnson, Contact Mechanics, section 4.2).
  collide(1e-4);
  PolarGrid axis{{}, {0.0}};
  for (int i = 0; i <= 1000; ++i) axis.radius.push_back(1.0 - 0.002 * i * half_width);
  const Field field = DiskField(0.33, body, contact.points, axis).at(coordinate, force);
  const std::vector<double> difference = principal_difference(field);
  const auto deepest = std::max_element(difference.begin(), difference.end()) - difference.begin();
  const double depth = 0.002 * static_cast<double>(deepest);
  EXPECT_NEAR(depth, 0.786, 0.02);
  EXPECT_NEAR(0.5 * difference[static_cast<std::size_t>(deepest)] / -field.stress_rr.front(), 0.300, 0.006);
}

INSTANTIATE_TEST_SUITE_P(Tails, FieldInAnImpact, ::testing::Values(Tail::quasistatic, Tail::radiating));

}  // namespace
}  // namespace stoss
