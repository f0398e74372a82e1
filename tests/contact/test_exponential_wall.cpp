// The paper's wall V = V₀ Σ μ_i e^{αx_i}: exact gradient, no overflow, V₀ without effect.
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "contact/response.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/impact.hpp"
#include "support/body_tools.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

using std::numbers::pi;

TEST(ExponentialWall, ForceIsTheGradientOfThePotential) {
  const Body body = disk(0.33, 12.5);
  const ContactGrid grid = test::grid_of(body, 0.4, 24);
  for (const double hardness : {50.0, 500.0}) {
    const ExponentialWall wall{hardness, 0.7};
    const auto response = make_response(contact(body, wall), Tail::none, grid, 0.1, 0.01);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-0.02, 0.01);
    std::vector<double> x(24);
    for (double& value : x) value = uniform(random);
    const std::vector<double> force = response->advance(x);
    double potential = 0.0;
    for (std::size_t i = 0; i < 24; ++i) potential += 0.7 * grid.measure[i] * std::exp(hardness * x[i]);
    EXPECT_NEAR(response->stored_energy(), potential, 1e-13 * potential);
    ASSERT_EQ(response->extent(), 24U);
    for (std::size_t i = 0; i < 24; ++i) {
      const double h = 1e-4 / hardness;
      auto moved = x;
      moved[i] = x[i] + h;
      response->advance(moved);
      const double up = response->stored_energy();
      moved[i] = x[i] - h;
      response->advance(moved);
      const double down = response->stored_energy();
      EXPECT_NEAR((up - down) / (2.0 * h), force[i], 1e-7 * hardness * potential) << "node " << i;
      EXPECT_GT(force[i], 0.0);
    }
  }
}

TEST(ExponentialWall, SaysSoWhenThePenetrationIsBeyondAnyForce) {
  const Body body = disk(0.33, 12.5);
  const ContactGrid grid = test::grid_of(body, 0.4, 4);
  const auto response = make_response(contact(body, ExponentialWall{500.0, 1.0}), Tail::none, grid, 0.1, 0.01);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double deep : {1.0, 1e6, 1e300, infinity, std::nan("")}) {
    const std::string message = test::message_of<NotConverged>([&] { response->advance({-1.0, deep, -1.0, -1.0}); });
    EXPECT_NE(message.find("exponential wall"), std::string::npos) << message;
    EXPECT_NE(message.find("step"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(ExponentialWall, IsWithoutForceFarAway) {
  const Body body = disk(0.33, 12.5);
  const auto response =
      make_response(contact(body, ExponentialWall{500.0, 1.0}), Tail::none, test::grid_of(body, 0.4, 4), 0.1, 0.01);
  const std::vector<double> force = response->advance({-1.0, -2.0, -10.0, -1e6});
  for (const double f : force) EXPECT_LT(f, 1e-200);
  EXPECT_FALSE(response->overflows());
}

TEST(ExponentialWall, ActsOnTheFrontHalfOfTheDisk) {
  // Paper eq. (40): V = V₀ ∫_{−π/2}^{π/2} e^{αx(φ)} dφ, with x = x₀ + cos φ before the impact has deformed the disk.
  using Gauss = boost::math::quadrature::gauss<double, 30>;
  const Body body = disk(0.33, 5.0);
  const std::vector<double> rest(mode_count(body), 0.0);
  constexpr double speed = 0.1, center = -2.0;
  for (const double hardness : {1.0, 3.0, 10.0}) {
    const double potential =
        2.0 *
        Gauss::integrate([&](double phi) { return std::exp(hardness * (center + std::cos(phi))); }, 0.0, 0.5 * pi);
    double share = -1.0;  // of the potential in the kinetic energy
    const ImpactOptions options{.resolution = {.tail = Tail::none}, .start = State{center, speed, rest, rest}};
    const ImpactObserver observer = [&](const Snapshot& now) {
      if (share < 0.0) share = now.stored / now.translation;
    };
    const Impact result = impact(body, ExponentialWall{hardness, 1e-2}, speed, options, {observer});
    EXPECT_NEAR(share * 0.5 * body.mass * speed * speed, 1e-2 * potential, 1e-5 * 1e-2 * potential) << hardness;
    EXPECT_LE(result.resolution.half_width, 0.5 * pi);
    const auto wider = [&] {
      (void)impact(body, ExponentialWall{hardness}, speed, {.resolution = {.half_width = 1.6}});
    };
    test::expect_refusal(wider, {"half_width", "1.6"});
  }
}

TEST(ExponentialWall, StrengthOnlyShiftsTheWall) {
  for (const Body& body : {disk(0.33, 12.5), disk(0.9, 12.5), rod(30.0)}) {
    for (const double speed : {0.01, 0.2}) {
      const Impact one = impact(body, ExponentialWall{500.0, 1.0}, speed);
      for (const double strength : {1e-3, 1e3}) {
        const Impact other = impact(body, ExponentialWall{500.0, strength}, speed);
        EXPECT_NEAR(other.lost_fraction, one.lost_fraction, 1e-9) << body.name << ", " << strength;
        EXPECT_NEAR(other.max_force / one.max_force, 1.0, 1e-9);
        EXPECT_NEAR(other.contact_time, one.contact_time, 1e-9);
        EXPECT_NEAR(other.max_compression, one.max_compression, 1e-9);
      }
    }
  }
}

TEST(ExponentialWall, RefusesBadConstants) {
  const Body body = rod(10.0);
  for (const double bad : {0.0, -500.0, 1e9, std::nan("")}) {
    test::expect_refusal([&] { (void)impact(body, ExponentialWall{bad, 1.0}, 0.1); }, {"hardness", "1 to 1e8"});
    test::expect_refusal([&] { validate(ExponentialWall{bad, 1.0}); }, {"hardness", "1 to 1e8"});
  }
  for (const double bad : {0.0, -1.0, 1e200, std::nan("")}) {
    test::expect_refusal([&] { (void)impact(body, ExponentialWall{500.0, bad}, 0.1); }, {"strength", "got"});
  }
  EXPECT_NO_THROW(validate(HardWall{}));
  EXPECT_NO_THROW(validate(ExponentialWall{}));
}

}  // namespace
}  // namespace stoss
