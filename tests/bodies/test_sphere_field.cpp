// The field inside a sphere: it obeys Hooke and Newton, leaves the surface free outside the contact, and under point
// forces is a known solution.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

#include "stoss/bodies/sphere.hpp"
#include "stoss/bodies/sphere/field.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"
#include "support/field_tools.hpp"
#include "support/refusal.hpp"

namespace stoss {
using namespace bodies::sphere;

namespace {

using std::numbers::pi;
constexpr double mass = 4.0 * pi / 3.0;

ContactPoints rings(std::size_t count, double half_width) {
  return {1.0, pi / std::floor(pi * static_cast<double>(count) / half_width), count};
}

/// Residuals of Hooke's law and of equilibrium at one point, by ninth-point differences.
struct Residual {
  double rr, tt, pp, rt;      // Hooke
  double radial, tangential;  // div σ
  double u_r, u_t;
};

Residual residual_at(const SphereField& stencil_field, double poisson, double r, double theta, double h,
                     const std::vector<double>& q, const std::vector<double>& f) {
  const Field field = stencil_field.at(q, f);
  const auto dr = [&](const std::vector<double>& x) { return test::derivative(x, 4, 9, h); };
  const auto dt = [&](const std::vector<double>& x) { return test::derivative(x, 36, 1, h) / r; };
  const double u = field.radial[40], v = field.tangential[40], cot = 1.0 / std::tan(theta);
  const double err = dr(field.radial), ett = dt(field.tangential) + u / r, epp = (u + v * cot) / r;
  const double ert = 0.5 * (dt(field.radial) + dr(field.tangential) - v / r);
  const double mu = 0.5 / (1.0 + poisson), lambda = 2.0 * mu * poisson / (1.0 - 2.0 * poisson);
  const double volume = lambda * (err + ett + epp);
  const double rr = field.stress_rr[40], tt = field.stress_tt[40], pp = field.stress_pp[40], rt = field.stress_rt[40];
  return {rr - volume - 2.0 * mu * err,
          tt - volume - 2.0 * mu * ett,
          pp - volume - 2.0 * mu * epp,
          rt - 2.0 * mu * ert,
          dr(field.stress_rr) + dt(field.stress_rt) + (2.0 * rr - tt - pp + rt * cot) / r,
          dr(field.stress_rt) + dt(field.stress_tt) + ((tt - pp) * cot + 3.0 * rt) / r,
          u,
          v};
}

class SphereFieldOf : public ::testing::TestWithParam<double> {
 protected:
  const double poisson = GetParam();
  const Body body = sphere(poisson, 12.5);
  const ContactPoints contact = rings(24, 0.8);
};

TEST_P(SphereFieldOf, EachModeObeysHookeAndNewton) {
  constexpr double h = 0.004;
  const std::vector<double> none(contact.count, 0.0);
  for (const double r : {0.3, 0.8}) {
    for (const double theta : {0.4, 1.9, -2.6}) {
      const SphereField field(poisson, body, contact, {test::stencil(r, h), test::stencil(theta, h)});
      std::size_t k = 0;
      for (const ModeGroup& group : body.groups) {
        for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
          if (k % 5 != 0) continue;
          std::vector<double> q(mode_count(body), 0.0);
          q[k] = 1.0;
          const Residual at = residual_at(field, poisson, r, theta, h, q, none);
          const double omega = group.omega[l], size = 2e-8 * (1.0 + omega) / (1.0 - 2.0 * poisson);
          EXPECT_NEAR(at.rr, 0.0, size) << k;
          EXPECT_NEAR(at.tt, 0.0, size) << k;
          EXPECT_NEAR(at.pp, 0.0, size) << k;
          EXPECT_NEAR(at.rt, 0.0, size) << k;
          EXPECT_NEAR(at.radial, -omega * omega * at.u_r, size * omega) << k;
          EXPECT_NEAR(at.tangential, -omega * omega * at.u_t, size * omega) << k;
        }
      }
    }
  }
}

/// Coordinates at rest: −Σ F_i (U cos θ P_n − V sin θ dP_n/dθ)/ω², from the shapes of the surface.
std::vector<double> at_rest(const Body& body, const ContactPoints& contact, const std::vector<double>& force) {
  const Surface surface = body.surface(contact);
  std::vector<double> q;
  for (const ModeGroup& group : body.groups) {
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      double load = 0.0;
      for (std::size_t i = 0; i < force.size(); ++i) {
        load -= force[i] * (group.upper[l] * surface.shape[group.upper_row * force.size() + i] +
                            group.lower[l] * surface.shape[group.lower_row * force.size() + i]);
      }
      q.push_back(load / (group.omega[l] * group.omega[l]));
    }
  }
  return q;
}

TEST_P(SphereFieldOf, AtRestIsThatOfAnAcceleratedSphere) {
  constexpr double h = 0.004;
  std::vector<double> force;
  for (std::size_t i = 0; i < contact.count; ++i)
    force.push_back(0.01 * (1.0 + std::cos(3.7 * static_cast<double>(i))));
  const double total = std::accumulate(force.begin(), force.end(), 0.0);  // acceleration away from the wall
  const std::vector<double> q = at_rest(body, contact, force);
  for (const double r : {0.3, 0.75}) {
    for (const double theta : {0.4, 1.9, 2.9}) {
      const SphereField field(poisson, body, contact, {test::stencil(r, h), test::stencil(theta, h)});
      const Residual at = residual_at(field, poisson, r, theta, h, q, force);
      const double size = 1e-8 / (1.0 - 2.0 * poisson);
      for (const double hooke : {at.rr, at.tt, at.pp, at.rt}) EXPECT_NEAR(hooke, 0.0, size);
      EXPECT_NEAR(at.radial, -total * std::cos(theta), 1e2 * size);
      EXPECT_NEAR(at.tangential, total * std::sin(theta), 1e2 * size);
    }
  }
  // The centre of mass stays: the mean displacement along the axis is 0.
  const test::RadialRule rule;
  const std::vector<double> turn = test::whole_turn(240);
  const SphereField field(poisson, body, contact, {rule.radius, turn});
  const Field whole = field.at(q, force);
  double moved = 0.0, size = 0.0;
  for (std::size_t i = 0; i < rule.radius.size(); ++i) {
    for (std::size_t k = 0; k < turn.size(); ++k) {
      const double weight = rule.weight[i] * rule.radius[i] * rule.radius[i] * std::abs(std::sin(turn[k]));
      const std::size_t at = i * turn.size() + k;
      moved += weight * (whole.radial[at] * std::cos(turn[k]) - whole.tangential[at] * std::sin(turn[k]));
      size += weight * std::abs(whole.radial[at]);
    }
  }
  EXPECT_NEAR(moved / size, 0.0, 1e-3);  // |sin θ| has a kink
}

TEST_P(SphereFieldOf, HasTheTractionsOfTheRingsAndTheirMotion) {
  std::vector<double> force(contact.count, 0.0);
  for (std::size_t i = 0; i < 16; ++i) force[i] = 1e-3 * static_cast<double>(i + 1);
  const std::vector<double> q = at_rest(body, contact, force);
  std::vector<double> angle;
  for (std::size_t i = 0; i < contact.count; ++i) angle.push_back(contact.angle(i));
  const Field field = SphereField(poisson, body, contact, {{1.0}, angle}).at(q, force);
  // At rest the rings move by −W_all F, W_all of all modes.
  const std::vector<double> w = body.residual_compliance(contact, {});
  const Surface surface = body.surface(contact);
  std::size_t k = 0;
  std::vector<double> moved(contact.count, 0.0);
  for (const ModeGroup& group : body.groups) {
    for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
      for (std::size_t i = 0; i < contact.count; ++i) {
        moved[i] += q[k] * (group.upper[l] * surface.shape[group.upper_row * contact.count + i] +
                            group.lower[l] * surface.shape[group.lower_row * contact.count + i]);
      }
    }
  }
  double resultant = 0.0, total = 0.0;
  for (std::size_t i = 0; i < contact.count; ++i) {
    for (std::size_t j = 0; j < contact.count; ++j) moved[i] -= mass * w[i * contact.count + j] * force[j];
    const double cosine = std::cos(angle[i]), sine = std::sin(angle[i]);
    EXPECT_NEAR(field.radial[i] * cosine - field.tangential[i] * sine, moved[i], 1e-12) << i;
    total += force[i] * mass;
    resultant -= surface.measure[i] * (field.stress_rr[i] * cosine - field.stress_rt[i] * sine);
  }
  EXPECT_NEAR(resultant / total, 1.0, 0.03);  // the pressure is band-limited between the rings
}

INSTANTIATE_TEST_SUITE_P(Poisson, SphereFieldOf, ::testing::Values(-0.5, 0.0, 0.3, 0.45));

TEST(SphereField, ShowsAnImpactWithTheGreatestShearBelowTheContact) {
  const Contact meeting = contact(sphere(0.3, 25.0));
  struct Peak {
    double force = 0.0, half_width = 0.0;
    std::vector<double> coordinate, share;
  } peak;
  const Impact result = impact(meeting, 1e-5, {.resolution = {.nodes = 96, .tail = Tail::quasistatic}},
                               {[&](const Snapshot& now) {
                                  if (now.force <= peak.force) return;
                                  peak.force = now.force;
                                  peak.half_width = now.contact_half_width;
                                  peak.coordinate.assign(now.coordinate.begin(), now.coordinate.end());
                                  peak.share.assign(now.node_force.begin(), now.node_force.end());
                                },
                                1, true});
  const ContactGrid grid = contact_grid(meeting, result.resolution.half_width, result.resolution.nodes);
  PolarGrid axis{{}, {1e-4}};
  const double a = peak.half_width;
  for (int k = 0; k <= 300; ++k) axis.radius.push_back(1.0 - 0.005 * k * a);
  const Field field = SphereField(0.3, *meeting.first, grid.points, axis).at(peak.coordinate, peak.share);
  const std::vector<double> difference = principal_difference(field);
  const auto deepest = std::max_element(difference.begin(), difference.end()) - difference.begin();
  EXPECT_NEAR(0.005 * static_cast<double>(deepest), 0.481, 0.01);  // Hertz at ν = 0.3
  const double pressure = 1.5 * peak.force * mass / (pi * a * a);
  EXPECT_NEAR(0.5 * difference[static_cast<std::size_t>(deepest)] / pressure, 0.310, 0.01);
  EXPECT_NEAR(-field.stress_rr[0] / pressure, 1.0, 0.03);
  EXPECT_EQ(von_mises(field).size(), difference.size());
}

TEST(SphereField, RefusesWhatDoesNotFit) {
  const Body body = sphere(0.3, 12.5);
  const ContactPoints contact = rings(24, 0.8);
  test::expect_refusal([&] { (void)SphereField(0.2, body, contact, {{0.5}, {0.0}}); }, {"poisson", "sphere"});
  test::expect_refusal([&] { (void)SphereField(0.3, body, contact, {{1.5}, {0.0}}); }, {"radius"});
  const SphereField field(0.3, body, contact, {{0.5}, {0.0}});
  test::expect_refusal([&] { (void)field.at(std::vector<double>(3), std::vector<double>(24)); }, {"coordinate"});
  test::expect_refusal([&] { (void)field.at(std::vector<double>(69), std::vector<double>(2)); }, {"node_force"});
}

}  // namespace
}  // namespace stoss
