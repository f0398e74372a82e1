// The field of many modes and forces at once, the measures of stress, and what is refused.
#include "stoss/bodies/disk/field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/contact/grid.hpp"
#include "support/body_tools.hpp"
#include "support/field_tools.hpp"
#include "support/refusal.hpp"

namespace stoss {
using namespace bodies::disk;

namespace {

using test::derivative;
using test::stencil;

/// Many modes and forces at once, at random.
class RandomField : public ::testing::Test {
 protected:
  const double poisson = 0.33;
  const Body body = disk(poisson, 12.5);
  const ContactGrid contact = test::grid_of(body, 0.6, 64);
  std::vector<double> coordinate, force;

  void SetUp() override {
    std::mt19937 random(1);
    std::normal_distribution<double> normal(0.0, 0.01);
    for (std::size_t i = 0; i < mode_count(body); ++i) coordinate.push_back(normal(random));
    for (std::size_t i = 0; i < contact.coordinate.size(); ++i) force.push_back(normal(random));
  }

  [[nodiscard]] Field at(std::vector<double> radius, std::vector<double> angle) const {
    return DiskField(poisson, body, contact.points, {std::move(radius), std::move(angle)}).at(coordinate, force);
  }
};

TEST_F(RandomField, ObeysHookesLaw) {
  const double h = 2e-3;
  for (const double r : {0.1, 0.5, 0.8}) {
    for (const double phi : {-0.4, 1.3, 3.0}) {
      const Field field = at(stencil(r, h), stencil(phi, h));  // 9 × 9, (r, φ) in the middle
      const double radial = field.radial[40], tangential = field.tangential[40];
      const double along = derivative(field.radial, 4, 9, h);
      const double across = (radial + derivative(field.tangential, 36, 1, h)) / r;
      const double shear =
          derivative(field.tangential, 4, 9, h) + (derivative(field.radial, 36, 1, h) - tangential) / r;
      const double stiffness = 1.0 / (1.0 - poisson * poisson);
      EXPECT_NEAR(field.stress_rr[40], stiffness * (along + poisson * across), 1e-10);
      EXPECT_NEAR(field.stress_pp[40], stiffness * (across + poisson * along), 1e-10);
      EXPECT_NEAR(field.stress_rp[40], shear / (2.0 * (1.0 + poisson)), 1e-10);
    }
  }
}

TEST_F(RandomField, OfAPointIsTheSameInAnyGrid) {
  const std::vector<double> radius{1.0, 0.2, 0.97, 0.0, 0.6, 1.0, 0.01}, angle{3.0, 0.1, -1.0};
  const Field all = at(radius, angle);
  for (std::size_t r = 0; r < radius.size(); ++r) {
    for (std::size_t a = 0; a < angle.size(); ++a) {
      const Field one = at({radius[r]}, {angle[a] + 20.0 * std::numbers::pi});
      EXPECT_NEAR(all.radial[3 * r + a], one.radial[0], 1e-13);
      EXPECT_NEAR(all.tangential[3 * r + a], one.tangential[0], 1e-13);
      EXPECT_NEAR(all.stress_rr[3 * r + a], one.stress_rr[0], 2e-11);
      EXPECT_NEAR(all.stress_pp[3 * r + a], one.stress_pp[0], 2e-11);
      EXPECT_NEAR(all.stress_rp[3 * r + a], one.stress_rp[0], 2e-11);
    }
  }
}

TEST(FieldMeasure, IsThatOfKnownStates) {
  // Uniaxial along r, along φ; pure shear in two orientations; hydrostatic; general, against the principal stresses.
  const Field field{
      {}, {}, {2.0, 0.0, 0.0, 3.0, -4.0, 5.0}, {0.0, -2.0, 0.0, -3.0, -4.0, 1.0}, {0.0, 0.0, 3.0, 0.0, 0.0, -1.5}};
  const double first = 5.5, second = 0.5;  // of the last: 3 ± √(2² + 1.5²)
  const std::vector<double> expected{2.0,
                                     2.0,
                                     3.0 * std::sqrt(3.0),
                                     3.0 * std::sqrt(3.0),
                                     4.0,
                                     std::sqrt(first * first - first * second + second * second)};
  const std::vector<double> difference{2.0, 2.0, 6.0, 6.0, 0.0, first - second};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_DOUBLE_EQ(von_mises(field)[i], expected[i]) << i;
    EXPECT_DOUBLE_EQ(principal_difference(field)[i], difference[i]) << i;
  }
  test::expect_refusal([] { (void)von_mises({{}, {}, {1.0}, {}, {1.0}}); }, {"stress_pp", "got 0", "1"});
  test::expect_refusal([] { (void)principal_difference({{}, {}, {1.0}, {1.0}, {}}); }, {"stress_rp", "got 0", "1"});
}

TEST(FieldInput, IsRefusedOutOfRange) {
  const Body body = disk(0.33, 5.0);
  const ContactGrid contact = test::grid_of(body, 0.5, 20);
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const auto make = [&](std::vector<double> radius, std::vector<double> angle) {
    return [&, points = PolarGrid{radius, angle}] { (void)DiskField(0.33, body, contact.points, points); };
  };
  test::expect_refusal(make({0.5, 1.01}, {0.0}), {"radius", "1.01", "0 to 1"});
  test::expect_refusal(make({-0.1}, {0.0}), {"radius", "-0.1", "0 to 1"});
  test::expect_refusal(make({nan}, {0.0}), {"radius", "nan", "0 to 1"});
  test::expect_refusal(make({0.5}, {nan}), {"angle", "nan", "finite"});
  test::expect_refusal(make({0.5}, {infinity}), {"angle", "inf", "finite"});
  test::expect_refusal(make({}, {0.0}), {"radius count", "got 0"});
  test::expect_refusal(make({0.5}, {}), {"angle count", "got 0"});
  const PolarGrid points{{0.5}, {0.0}};
  test::expect_refusal([&] { (void)DiskField(1.5, body, contact.points, points); },
                       {"poisson", "1.5", "-0.95 to 0.995"});
  test::expect_refusal([&] { (void)DiskField(0.3301, body, contact.points, points); },
                       {"poisson", "0.3301", body.name});
  test::expect_refusal(
      [&] {
        (void)DiskField(0.33, body, ContactPoints{1.0, 0.1, 0}, points);
      },
      {"contact nodes", "got 0"});
  test::expect_refusal([&] { (void)DiskField(0.33, body, ContactPoints{}, points); }, {"contact spacing", "got 0"});
  test::expect_refusal([&] { (void)DiskField(0.33, rod(10.0), contact.points, points); }, {"poisson", "rod"});

  const DiskField field(0.33, body, contact.points, points);
  const std::vector<double> coordinate(mode_count(body), 0.0), force(20, 0.0);
  test::expect_refusal([&] { (void)field.at(force, force); },
                       {"coordinate", "got 20", std::to_string(coordinate.size())});
  test::expect_refusal([&] { (void)field.at(coordinate, coordinate); }, {"node_force", "20"});
  test::expect_refusal([&] { (void)field.at(coordinate, std::vector<double>(20, nan)); }, {"node_force", "nan"});
  test::expect_refusal([&] { (void)field.at(std::vector<double>(coordinate.size(), infinity), force); },
                       {"coordinate", "inf"});
}

}  // namespace
}  // namespace stoss
