// Displacement fields of the modes: orthonormal (the paper's appendix: the operator is hermitian for a free edge),
// equal to (C, S) at the edge, finite at the centre.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

#include "stoss/bodies/disk/modes.hpp"
#include "stoss/errors.hpp"
#include "support/refusal.hpp"

namespace stoss {
using namespace bodies::disk;

namespace {

std::vector<Mode> modes_of_order(double poisson, double cutoff, int order) {
  std::vector<Mode> modes;
  for (const Mode& mode : bodies::disk::modes(poisson, cutoff)) {
    if (mode.order == order) modes.push_back(mode);
  }
  return modes;
}

/// Gauss points and weights of [0, 1] in equal panels.
struct Quadrature {
  std::vector<double> radii, weights;
};

Quadrature composite_gauss(int panels) {
  using Rule = boost::math::quadrature::gauss<double, 20>;
  Quadrature result;
  for (int panel = 0; panel < panels; ++panel) {
    const double half = 0.5 / panels;
    const double middle = (2 * panel + 1) * half;
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      for (const double sign : {-1.0, 1.0}) {
        result.radii.push_back(middle + sign * half * Rule::abscissa()[i]);
        result.weights.push_back(half * Rule::weights()[i]);
      }
    }
  }
  return result;
}

double inner_product(const Quadrature& rule, const std::vector<Displacement>& u, const std::vector<Displacement>& v) {
  double sum = 0.0;
  for (std::size_t i = 0; i < rule.radii.size(); ++i) {
    sum += rule.weights[i] * rule.radii[i] * (u[i].radial * v[i].radial + u[i].tangential * v[i].tangential);
  }
  return sum;
}

class ModeFields : public ::testing::TestWithParam<std::tuple<double, int>> {
 protected:
  const double poisson = std::get<0>(GetParam());
  const int order = std::get<1>(GetParam());
  const std::vector<Mode> modes = modes_of_order(poisson, 60.0, order);
};

TEST_P(ModeFields, AreOrthonormal) {
  ASSERT_FALSE(modes.empty());
  const Quadrature rule = composite_gauss(16);
  std::vector<std::vector<Displacement>> fields;
  for (const Mode& mode : modes) fields.push_back(displacement(poisson, mode, rule.radii));
  const double norm = order == 0 ? 0.5 : 1.0;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      EXPECT_NEAR(inner_product(rule, fields[i], fields[j]), i == j ? norm : 0.0, 1e-9) << i << ", " << j;
    }
  }
}

TEST_P(ModeFields, EndInTheEdgeAmplitudes) {
  for (const Mode& mode : modes) {
    const Displacement edge = displacement(poisson, mode, {1.0}).front();
    const double tolerance = 1e-10 * std::max(mode.radial, std::abs(mode.tangential));
    EXPECT_NEAR(edge.radial, mode.radial, tolerance) << "omega = " << mode.omega;
    EXPECT_NEAR(edge.tangential, mode.tangential, tolerance) << "omega = " << mode.omega;
  }
}

TEST_P(ModeFields, VanishAtTheCentreUnlessTheCentreMoves) {
  for (const Mode& mode : modes) {
    const Displacement centre = displacement(poisson, mode, {0.0}).front();
    if (order == 1) {
      EXPECT_GT(std::abs(centre.radial), 1e-6);
      EXPECT_NEAR(centre.radial, -centre.tangential, 1e-12 * std::abs(centre.radial));  // a translation
    } else {
      EXPECT_NEAR(std::hypot(centre.radial, centre.tangential), 0.0, 1e-12);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(PoissonAndOrder, ModeFields,
                         ::testing::Combine(::testing::Values(-0.9, -0.5, 0.0, 0.33, 0.9, 0.99),
                                            ::testing::Values(0, 1, 2, 5, 20, 60)));

TEST(ModeField, RefusesBadInput) {
  const Mode mode = bodies::disk::modes(0.33, 5.0).front();
  test::expect_refusal([&] { (void)displacement(0.33, mode, {0.5, 1.5}); }, {"radius", "1.5", "0 to 1"});
  test::expect_refusal([&] { (void)displacement(0.33, mode, {-0.1}); }, {"radius", "-0.1", "0 to 1"});
  test::expect_refusal([&] { (void)displacement(0.33, mode, {std::nan("")}); }, {"radius", "nan", "0 to 1"});
  test::expect_refusal([&] { (void)displacement(2.0, mode, {0.5}); }, {"poisson", "2", "-0.95 to 0.995"});
}

}  // namespace
}  // namespace stoss
