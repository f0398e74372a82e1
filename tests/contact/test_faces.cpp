// Rough and coated faces: the forces obey their laws and are gradients of the energy; limits that are known exactly.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "contact/edge/edge_contact.hpp"
#include "contact/edge/edge_law.hpp"
#include "contact/faces/projected_areas.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

using std::numbers::pi;

EdgeContact contact_of(const Contact& contact, const ContactGrid& grid) {
  return {residual_compliance(contact, grid), edge_law(contact, grid, 0.1), grid.recess.size(), {}};
}

TEST(RoughFaces, ForcesObeyTheLawAndAreTheGradientOfTheEnergy) {
  for (const double length : {1e-6, 1e-3, 0.1}) {
    const Contact rough_one = contact(rough(sphere({.poisson = 0.3})(8.0, {}), length));
    const ContactGrid grid = contact_grid(rough_one, 1.2, 24);
    EdgeContact problem = contact_of(rough_one, grid);
    const EdgeLaw law = edge_law(rough_one, grid, 0.1);
    const std::size_t n = grid.recess.size();
    std::vector<double> force(n), moved(n), q(n);
    const auto energy_at = [&](double depth, std::size_t node, double further) {
      for (std::size_t i = 0; i < n; ++i) q[i] = depth - grid.recess[i];
      q[node] += further;
      problem.solve(q, force, moved);
      return problem.energy(force, moved);
    };
    for (const double depth : {-10.0 * length, 0.01, 0.1, 0.02}) {
      (void)energy_at(depth, 0, 0.0);
      const std::vector<double> found = force, displaced = moved;
      for (std::size_t i = 0; i < problem.extent(); ++i) {
        if (!(found[i] > 1e-9 * found[0])) continue;
        // g = W f − q = g* − u₀ ln(f/f*) but for what the smooth edge has closed.
        const double smooth = std::min(1.0, std::sqrt(found[i] / law.edge_force[i])), open = 1.0 - smooth;
        const double gap = law.gap[i] - length * std::log(found[i] / law.force[i]) -
                           law.edge_gap[i] * (law.edge_open[i] - open * open);
        EXPECT_NEAR(displaced[i] - q[i], gap, 1e-9 * (length + std::abs(q[i]))) << length << " " << depth << " " << i;
      }
      for (const std::size_t i : {0U, 5U}) {
        const double h = 1e-3 * length;
        const double slope = (energy_at(depth, i, h) - energy_at(depth, i, -h)) / (2.0 * h);
        EXPECT_NEAR(slope, found[i], 1e-5 * found[0] + 1e-12) << length << " " << depth << " " << i;
      }
    }
  }
}

TEST(RoughFaces, AreaIsThatOfTheFront) {
  for (const int nodes : {32, 64, 128}) {
    const Contact ball = contact(rough(sphere({.poisson = 0.3})(8.0, {}), 0.1));
    const ContactGrid grid = contact_grid(ball, 0.5 * pi, nodes);
    double area = 0.0, moment = 0.0;
    for (std::size_t i = 0; const double each : projected_areas(ball, grid.points)) {
      const double angle = grid.points.angle(i++);
      area += each, moment += each * std::exp(20.0 * (std::cos(angle) - 1.0));
    }
    // ∫ 2π sin cos e^{20(cos − 1)} dα
    const double exact = 2.0 * pi * (1.0 / 20.0 - (1.0 - std::exp(-20.0)) / 400.0);
    EXPECT_NEAR(moment / exact, 1.0, 300.0 / std::pow(nodes, 4)) << nodes;
    EXPECT_NEAR(area / pi, 1.0, 3.0 / (nodes * nodes)) << nodes;
  }
}

TEST(RoughFaces, TwoOfThemAddTheirSquares) {
  const BodyMaker ball = sphere({.poisson = 0.3});
  const Contact both = contact(rough(ball, 0.003)(10.0, {}), rough(ball, 0.004)(10.0, {}));
  EXPECT_DOUBLE_EQ(both.asperities, 0.005);
  const Impact one = impact(contact(rough(ball, 0.005)(10.0, {}), ball(10.0, {})), 0.1);
  EXPECT_DOUBLE_EQ(impact(both, 0.1).restitution, one.restitution);
}

// Asperities far shorter than the gap that the edge of a coat opens over a spacing: the gap of a node must not jump
// where its force begins, or a position between has no force.
TEST(RoughFaces, HaveForcesAtAnyPositionOnACoat) {
  const BodyMaker ball = coated(sphere({.poisson = 0.29}), {0.436, 1.5, Relaxation{{{0.2, 10.0}}}});
  for (const double length : {6.5e-6, 1e-6, 1e-7}) {
    const Contact wall = contact(rough(ball, length)(25.0, {}));
    const Impact found = impact(wall, 5.8e-4, {.resolution = {.step = 8e-3, .nodes = 64}});
    EXPECT_NEAR(found.energy_error, 0.0, 1e-4) << length;
  }
}

TEST(RoughFaces, AreSmoothWhereAsperitiesAreShort) {
  for (const BodyMaker& body : {sphere({.poisson = 0.3}), disk({.poisson = 0.3})}) {
    const double smooth = restitution(body, 0.1).lost_fraction.value;
    double before = 0.0;
    for (const double length : {1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-14}) {
      const double lost = restitution(rough(body, length), 0.1).lost_fraction.value;
      EXPECT_GT(lost, before) << length;
      before = lost * (1.0 - 1e-3);
      if (length < 1e-5) {
        EXPECT_NEAR(lost, smooth, 2e-3 * smooth) << length;
      }
    }
  }
}

TEST(RoughFaces, AreASoftSpringWhereAsperitiesAreLong) {
  // One spring of F = F₀ e^{x/u₀}, which gives all of it back; the time above a thousandth of its greatest force is
  // (4u₀/v) artanh √(1 − 10⁻³).
  const Restitution soft = restitution(rough(sphere({.poisson = 0.3}), 0.9), 0.02);
  EXPECT_LT(soft.lost_fraction.value, 1e-8);
  const double reduced = 1.0;
  EXPECT_NEAR(soft.contact_time.value, reduced * 4.0 * 0.9 / 0.02 * std::atanh(std::sqrt(1.0 - 1e-3)), 2.0);
}

TEST(RoughFaces, DoNotKnowTheStrengthOfTheWall) {
  const Body ball = sphere({.poisson = 0.3})(10.0, {});
  const double lost = impact(ball, ExponentialWall{200.0, 1.0}, 0.1).lost_fraction;
  for (const double strength : {1e-100, 1e-3, 1e100}) {
    EXPECT_NEAR(impact(ball, ExponentialWall{200.0, strength}, 0.1).lost_fraction, lost, 1e-7);
  }
}

TEST(CoatedFaces, OnARigidBodyAreWinklersFoundation) {
  // F = πR δ²/C: the time of contact is 2δ ∫₀¹ dx/√(1 − x³)/v with δ = (3mv²C/2πR)^{1/3}.
  constexpr double compliance = 3e3, speed = 3e-5, integral = 1.4021821053254544;
  const Body ball = coated(sphere({.poisson = 0.3})(6.0, {}), {compliance, 2.0 * compliance});
  const Impact soft = impact(contact(ball), speed);
  const double depth = std::cbrt(1.5 * ball.mass * speed * speed * compliance / pi);
  EXPECT_NEAR(soft.max_compression / depth, 1.0, 3e-3);
  EXPECT_NEAR(soft.contact_time / (2.0 * depth * integral / speed), 1.0, 5e-3);
  EXPECT_NEAR(soft.restitution, 1.0, 1e-6);
}

TEST(CoatedFaces, AreHarmlessWhereThin) {
  const BodyMaker ball = sphere({.poisson = 0.3}), block = half_space({.poisson = 0.2});
  const double bare = restitution({ball, block}, 0.05).lost_fraction.value;
  EXPECT_NEAR(restitution({coated(ball, {1e-6, 1e-6}), block}, 0.05).lost_fraction.value, bare, 1e-4 * bare);
  const double one = restitution({coated(ball, {0.05, 0.1}), block}, 0.05).lost_fraction.value;
  const double other = restitution({ball, coated(block, {0.05, 0.1})}, 0.05).lost_fraction.value;
  EXPECT_LT(one, bare * 0.999);
  EXPECT_NEAR(one, other, 1e-3 * one);  // the same layer, on either face
}

TEST(CoatedFaces, KeepTheirHeat) {
  const Relaxation rubber{{{0.6, 2.0}}};
  const Body ball = sphere({.poisson = 0.3})(16.0, {});
  for (const Tail tail : {Tail::radiating, Tail::quasistatic}) {
    const Contact pair = contact(coated(ball, {1.0, 3.0, rubber}), ball);
    const Impact lossy = impact(pair, 0.05, {.resolution = {.tail = tail}});
    EXPECT_GT(lossy.energy.dissipated, 0.2);
    EXPECT_NEAR(lossy.energy.lost_to_first - lossy.energy.lost_to_second, lossy.energy.dissipated + lossy.energy.stored,
                2e-3);
    EXPECT_NEAR(lossy.energy_error, 0.0, 1e-3);
  }
}

TEST(Faces, RefuseWhatTheyCannotBe) {
  const Body ball = sphere({.poisson = 0.3})(6.0, {});
  test::expect_refusal([&] { (void)rough(ball, -1e-3); }, {"asperities", "-0.001"});
  test::expect_refusal([&] { (void)rough(ball, std::nan("")); }, {"asperities", "nan"});
  test::expect_refusal([&] { (void)coated(ball, {-1.0}); }, {"coat", "-1"});
  test::expect_refusal([&] { (void)coated(ball, {std::nan("")}); }, {"coat", "nan"});
  test::expect_refusal([&] { (void)impact(contact(ball), 0.1, {.resolution = {.tail = Tail::none}}); },
                       {"tail", "none"});
}

}  // namespace
}  // namespace stoss
