// The field of single modes: displacement and stress obey Hooke's law and the equations of motion, the edge is free,
// the centre regular. Then sums of many modes and forces, stress measures, and what is refused.
#include "stoss/bodies/disk/field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <tuple>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/contact/grid.hpp"
#include "support/body_tools.hpp"
#include "support/field_tools.hpp"

namespace stoss {
using namespace bodies::disk;

namespace {

using test::derivative;
using test::stencil;

/// With κ′ ≤ 60, made once.
const Body& body_of(double poisson) {
  static std::map<double, Body> made;
  const auto found = made.find(poisson);
  if (found != made.end()) return found->second;
  return made.emplace(poisson, disk(poisson, 60.0 / std::sqrt(2.0 * (1.0 + poisson)))).first->second;
}

/// The fields of all modes of one order, each with unit coordinate and without force.
class ModeStress : public ::testing::TestWithParam<std::tuple<double, int>> {
 protected:
  const double poisson = std::get<0>(GetParam());
  const int order = std::get<1>(GetParam());
  const Body& body = body_of(poisson);
  const ContactGrid contact = test::grid_of(body, 0.5, 20);
  std::vector<Mode> modes;
  std::size_t first = 0;  // of them in the coordinates

  void SetUp() override {
    for (const ModeGroup& group : body.groups) {
      if (group.order != order) {
        if (modes.empty()) first += group.omega.size();
        continue;
      }
      for (std::size_t l = 0; l < group.omega.size(); ++l) {
        modes.push_back({order, static_cast<int>(l), group.omega[l], group.upper[l] + group.lower[l],
                         group.upper[l] - group.lower[l]});
      }
    }
    ASSERT_GE(modes.size(), 4U);
  }

  [[nodiscard]] DiskField field(const PolarGrid& points) const { return {poisson, body, contact.points, points}; }

  [[nodiscard]] Field alone(const DiskField& field, std::size_t mode) const {
    std::vector<double> coordinate(mode_count(body), 0.0);
    coordinate[first + mode] = 1.0;
    return field.at(coordinate, std::vector<double>(contact.coordinate.size(), 0.0));
  }

  /// Points at which the cosine and the sine of nφ are 1 in turn.
  [[nodiscard]] PolarGrid crests(const std::vector<double>& radius) const {
    return {radius, {0.0, 0.5 * std::numbers::pi / std::max(order, 1)}};
  }

  /// The field of one mode at the crests: by radius, without the factors cos nφ and sin nφ.
  [[nodiscard]] Field profile(const DiskField& at_crests, std::size_t mode) const {
    Field both = alone(at_crests, mode), result;
    for (std::size_t k = 0; k < both.radial.size(); k += 2) {
      result.radial.push_back(both.radial[k]);
      result.tangential.push_back(both.tangential[k + 1]);
      result.stress_rr.push_back(both.stress_rr[k]);
      result.stress_pp.push_back(both.stress_pp[k]);
      result.stress_rp.push_back(both.stress_rp[k + 1]);
    }
    return result;
  }

  /// Inverse of a length over which a mode is smooth.
  [[nodiscard]] double wave_number(std::size_t mode, double radius) const {
    return modes[mode].omega * std::sqrt(2.0 * (1.0 + poisson)) + (order + 1.0) / radius;
  }

  const std::vector<double> radii{0.01, 0.1, 0.3, 0.6, 0.9};
  const std::vector<std::size_t> some() const { return {0, 1, modes.size() / 2, modes.size() - 1}; }
};

TEST_P(ModeStress, HasTheDisplacementOfTheMode) {
  const std::vector<double> radius{0.0, 0.3, 1.0}, angle{0.0, 0.7, -2.5};
  const DiskField disk_field = field({radius, angle});
  for (std::size_t l = 0; l < modes.size(); ++l) {
    const Field at = alone(disk_field, l);
    const std::vector<Displacement> expected = displacement(poisson, modes[l], radius);
    for (std::size_t r = 0; r < radius.size(); ++r) {
      for (std::size_t a = 0; a < angle.size(); ++a) {
        EXPECT_NEAR(at.radial[3 * r + a], expected[r].radial * std::cos(order * angle[a]), 1e-13);
        EXPECT_NEAR(at.tangential[3 * r + a], expected[r].tangential * std::sin(order * angle[a]), 1e-13);
      }
    }
  }
}

TEST_P(ModeStress, ObeysHookesLaw) {
  for (const std::size_t l : some()) {
    for (const double r : radii) {
      const double h = 0.03 / wave_number(l, r);
      const Field at = profile(field(crests(stencil(r, h))), l);
      const double radial = at.radial[4], tangential = at.tangential[4];
      const double along = derivative(at.radial, 0, 1, h), across = (radial + order * tangential) / r;
      const double shear = derivative(at.tangential, 0, 1, h) - (tangential + order * radial) / r;
      const double stiffness = 1.0 / (1.0 - poisson * poisson);
      // Relative to the field at this radius, however small it is.
      const double tolerance = 1e-10 * std::hypot(radial, tangential) * wave_number(l, r) * stiffness;
      EXPECT_NEAR(at.stress_rr[4], stiffness * (along + poisson * across), tolerance) << "mode " << l << ", r " << r;
      EXPECT_NEAR(at.stress_pp[4], stiffness * (across + poisson * along), tolerance) << "mode " << l << ", r " << r;
      EXPECT_NEAR(at.stress_rp[4], shear / (2.0 * (1.0 + poisson)), tolerance) << "mode " << l << ", r " << r;
    }
  }
}

TEST_P(ModeStress, ObeysTheEquationsOfMotion) {
  for (const std::size_t l : some()) {
    const double omega_squared = modes[l].omega * modes[l].omega;
    for (const double r : radii) {
      const double h = 0.03 / wave_number(l, r);
      const Field at = profile(field(crests(stencil(r, h))), l);
      const double rr = at.stress_rr[4], pp = at.stress_pp[4], rp = at.stress_rp[4];
      const double tolerance = 1e-10 * std::hypot(rr, pp, rp) * wave_number(l, r);
      EXPECT_NEAR(derivative(at.stress_rr, 0, 1, h) + (order * rp + rr - pp) / r, -omega_squared * at.radial[4],
                  tolerance)
          << "mode " << l << ", r " << r;
      EXPECT_NEAR(derivative(at.stress_rp, 0, 1, h) + (2.0 * rp - order * pp) / r, -omega_squared * at.tangential[4],
                  tolerance)
          << "mode " << l << ", r " << r;
    }
  }
}

TEST_P(ModeStress, LeavesTheEdgeFree) {
  std::vector<double> radius;
  for (int i = 0; i <= 100; ++i) radius.push_back(0.01 * i);
  const DiskField disk_field = field(crests(radius));
  for (std::size_t l = 0; l < modes.size(); ++l) {
    const Field at = profile(disk_field, l);
    double largest = 0.0;
    for (const auto* stress : {&at.stress_rr, &at.stress_pp, &at.stress_rp}) {
      for (const double value : *stress) largest = std::max(largest, std::abs(value));
    }
    EXPECT_NEAR(at.stress_rr.back(), 0.0, 1e-11 * largest) << l;
    EXPECT_NEAR(at.stress_rp.back(), 0.0, 1e-11 * largest) << l;
  }
}

TEST_P(ModeStress, IsRegularAtTheCentre) {
  const DiskField disk_field = field(crests({0.0, 1e-200, 1e-9}));
  for (std::size_t l = 0; l < modes.size(); ++l) {
    const Field at = profile(disk_field, l);
    const double scale = modes[l].omega * modes[l].omega;
    for (const auto* values : {&at.radial, &at.tangential, &at.stress_rr, &at.stress_pp, &at.stress_rp}) {
      ASSERT_TRUE(std::isfinite((*values)[0]));
      EXPECT_EQ((*values)[0], (*values)[1]);
      EXPECT_NEAR((*values)[0], (*values)[2], 1e-7 * scale);
    }
    // A uniform stress in Cartesian components is isotropic, or of order 2.
    const double rr = at.stress_rr[0], pp = at.stress_pp[0], rp = at.stress_rp[0];
    if (order == 0 || order == 2) {
      EXPECT_GT(std::abs(rr), 0.01) << l;
      EXPECT_NEAR(pp, order == 0 ? rr : -rr, 1e-12 * std::abs(rr)) << l;
      EXPECT_NEAR(rp, order == 0 ? 0.0 : -rr, 1e-12 * std::abs(rr)) << l;
    } else {
      EXPECT_NEAR(std::hypot(rr, pp, rp), 0.0, 1e-20) << l;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Field, ModeStress,
                         ::testing::Combine(::testing::Values(-0.9, 0.0, 0.33, 0.9),
                                            ::testing::Values(0, 1, 2, 3, 20)));

TEST(FieldOfHighOrders, EndsInTheEdgeAmplitudes) {
  // Rayleigh waves far below n, where Bessel functions are smallest.
  const double poisson = -0.9;
  for (const Mode& mode : bodies::disk::modes(poisson, 200.0)) {
    if (mode.order < 100) continue;
    const Displacement edge = displacement(poisson, mode, {1.0}).front();
    const double mismatch = std::hypot(edge.radial - mode.radial, edge.tangential - mode.tangential);
    EXPECT_LT(mismatch, 1e-10 * std::hypot(mode.radial, mode.tangential)) << mode.order << ", " << mode.omega;
  }
}

}  // namespace
}  // namespace stoss
