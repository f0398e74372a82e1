// The modes above the cutoff behind a hard wall, on one node that is driven by a prescribed motion u(t):
//   static     f = K u
//   radiating  f = (K + [(s²M)⁻¹ + (G + sZ)⁻¹]⁻¹) u: a spring parallel to a mass that hangs on a spring and a dashpot.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <vector>

#include "contact/edge/edge_law.hpp"
#include "contact/response.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/contact/wall.hpp"
#include "support/body_tools.hpp"
#include "support/toy_bodies.hpp"

namespace stoss {
namespace {

constexpr double impedance = 2.0;
constexpr double cutoff = 5.0;
constexpr double stiffness = 0.5 * std::numbers::pi * cutoff * impedance;  // that of a family of high overtones
constexpr double compliance = 1.0 / stiffness;
constexpr double mass = impedance * std::numbers::pi / (6.0 * cutoff);
constexpr double link = (8.0 / std::numbers::pi - 0.5 * std::numbers::pi) * cutoff * impedance;  // G

/// Dynamic stiffness at s.
template <typename Number>
Number dynamic_stiffness(Number s) {
  return stiffness + 1.0 / (1.0 / (s * s * mass) + 1.0 / (link + s * impedance));
}

/// A tail on one node, of a body without kept modes.
class Tail1 {
 public:
  Tail1(Tail tail, double step)
      : body_(test::point_body(1.0, cutoff, compliance, impedance, {})),
        grid_(test::grid_of(body_, 0.0, 1)),
        response_(make_response(contact(body_), tail, grid_, 0.1, step)) {}
  double force_at(double position) { return response_->advance({position}).front(); }
  [[nodiscard]] const ContactResponse& response() const { return *response_; }

 private:
  Body body_;
  ContactGrid grid_;
  std::unique_ptr<ContactResponse> response_;
};

/// log₂ of the ratio of the errors at two steps, the second half of the first.
double order(double coarse, double fine) { return std::log2(std::abs(coarse) / std::abs(fine)); }

TEST(StaticTail, ForceIsStiffnessTimesDisplacement) {
  Tail1 tail(Tail::quasistatic, 0.01);
  for (const double u : {0.1, 0.7, 0.2, -0.4, 0.0, 1e-9, 3.0}) {
    const double f = tail.force_at(u);
    EXPECT_NEAR(f, std::max(0.0, stiffness * u), 1e-14 * stiffness * std::abs(u)) << u;
    EXPECT_NEAR(tail.response().stored_energy(), 0.5 * f * std::max(0.0, u), 1e-15 * f);
    EXPECT_EQ(tail.response().unresolved_energy(), 0.0);
    EXPECT_EQ(tail.response().protrusion(), 0.0);
  }
}

TEST(StaticTail, OfTwoNodesInvertsTheCompliance) {
  const Body body = test::two_point_body();
  const ContactGrid grid = test::grid_of(body, 1.0, 2);
  const EdgeLaw law = edge_law(contact(body), grid, 0.1);
  const auto response = make_response(contact(body), Tail::quasistatic, grid, 0.1, 0.01);
  const auto both = response->advance({4.0, 5.0});  // ((2, 1), (1, 2)) f = (4, 5)
  EXPECT_NEAR(both[0], 1.0, 1e-14);
  EXPECT_NEAR(both[1], 2.0, 1e-14);
  EXPECT_NEAR(response->stored_energy(), 7.0 + law.energy_at(0, 1.0) + law.energy_at(1, 1.0), 1e-13);
  EXPECT_TRUE(response->overflows());
  const auto one = response->advance({4.0, 1.0});  // the first node alone moves the second by 2
  EXPECT_NEAR(one[0], 2.0, 1e-14);
  EXPECT_EQ(one[1], 0.0);
  EXPECT_NEAR(response->stored_energy(), 4.0 + law.energy_at(0, 1.0), 1e-13);
  EXPECT_NEAR(response->half_width(), 0.82, 1e-15);
  EXPECT_FALSE(response->overflows());
}

TEST(RadiatingTail, FollowsExponentialGrowthAtFirstOrder) {
  constexpr double growth = 3.0;
  const double exact_force = dynamic_stiffness(growth);
  // Work = stored in the springs and the mass + dissipated in the dashpot.
  const double branch = exact_force - stiffness;
  const double mass_velocity = branch / (mass * growth);
  const double stretch = branch / (link + growth * impedance);
  const double stored = 0.5 * stiffness + 0.5 * mass * mass_velocity * mass_velocity + 0.5 * link * stretch * stretch;
  const double dissipated = 0.5 * impedance * growth * stretch * stretch;
  EXPECT_NEAR(stored + dissipated, 0.5 * exact_force, 1e-14);

  std::array<double, 3> force_error{}, work_error{};
  double step = 0.01;
  for (std::size_t k = 0; k < 3; ++k, step *= 0.5) {
    Tail1 tail(Tail::radiating, step);
    const int steps = static_cast<int>(std::lround(12.0 / step));
    double force = 0.0;
    for (int i = -steps; i <= 0; ++i) force = tail.force_at(std::exp(growth * i * step));
    force_error[k] = force - exact_force;
    work_error[k] = tail.response().unresolved_energy() - (stored + dissipated);
  }
  EXPECT_GE(order(force_error[0], force_error[1]), 0.9);
  EXPECT_GE(order(force_error[1], force_error[2]), 0.9);
  EXPECT_GE(order(work_error[0], work_error[1]), 0.9);
  EXPECT_GE(order(work_error[1], work_error[2]), 0.9);
  EXPECT_LT(std::abs(force_error[2]), 0.01 * exact_force);
  EXPECT_LT(std::abs(work_error[2]), 0.01 * exact_force);
}

TEST(RadiatingTail, FollowsASinusoidAndTakesItsPower) {
  constexpr double omega = 20.0, mean = 5.0, amplitude = 0.2;
  const std::complex<double> s(0.0, omega);
  const std::complex<double> response = dynamic_stiffness(s);
  const double power = 0.5 * amplitude * amplitude * omega * response.imag();
  ASSERT_GT(power, 0.0);
  const double period = 2.0 * std::numbers::pi / omega;
  std::array<double, 3> force_error{}, power_error{};
  int per_period = 400;
  for (std::size_t k = 0; k < 3; ++k, per_period *= 2) {
    const double step = period / per_period;
    Tail1 tail(Tail::radiating, step);
    double before = 0.0;
    for (int i = 0; i <= 40 * per_period; ++i) {
      const double t = i * step;
      const double force = tail.force_at(mean + amplitude * std::sin(omega * t));
      if (i < 30 * per_period) continue;
      const double exact = stiffness * mean + amplitude * (response * std::exp(s * t)).imag();
      ASSERT_GT(exact, 0.0);
      force_error[k] = std::max(force_error[k], std::abs(force - exact));
      if (i == 30 * per_period) before = tail.response().unresolved_energy();
    }
    power_error[k] = (tail.response().unresolved_energy() - before) / (10.0 * period) - power;
  }
  EXPECT_GE(order(force_error[0], force_error[1]), 0.9);
  EXPECT_GE(order(force_error[1], force_error[2]), 0.9);
  EXPECT_GE(order(power_error[0], power_error[1]), 0.9);
  EXPECT_GE(order(power_error[1], power_error[2]), 0.9);
  EXPECT_LT(force_error[2], 0.02 * amplitude * std::abs(response));
  EXPECT_LT(std::abs(power_error[2]), 0.02 * power);
}

TEST(RadiatingTail, NeverGivesBackMoreThanItGot) {
  constexpr double step = 0.005;
  for (int k = 1; k <= 8; ++k) {
    Tail1 tail(Tail::radiating, step);
    bool lifted = false, touched = false;
    for (int i = 0; i <= 16000; ++i) {
      const double t = i * step;
      const double x = 0.3 * std::sin(1.1 * k * t) + 0.1 * std::sin(7.3 * t + k) - (t > 35.0 ? t - 35.0 : 0.0);
      const double force = tail.force_at(x);
      ASSERT_GE(force, 0.0);
      (force > 0.0 ? touched : lifted) = true;
      ASSERT_GE(tail.response().unresolved_energy(), -1e-12) << "at time " << t;
    }
    EXPECT_TRUE(lifted && touched);
    EXPECT_GT(tail.response().unresolved_energy(), 1e-3);
    EXPECT_LT(tail.response().protrusion(), 1e-8);
  }
}

}  // namespace
}  // namespace stoss
