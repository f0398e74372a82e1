// The disk as a body: nodes, shapes, impedance, and the residual compliance against plain sums over modes and orders.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/contact/grid.hpp"
#include "support/body_tools.hpp"
#include "support/complementarity.hpp"

namespace stoss {
using namespace bodies::disk;

namespace {

using std::numbers::pi;

int nyquist(const ContactGrid& grid) { return static_cast<int>(std::lround(0.5 * pi / grid.coordinate.front())); }

/// (1/m) Σ_n [R^CC c_i c_j + R^CS (c_i s_j + s_i c_j) + R^SS s_i s_j], term by term.
template <typename Response>
std::vector<double> double_sum(const ContactGrid& grid, int orders, Response response) {
  const std::size_t count = grid.coordinate.size();
  std::vector<double> w(count * count, 0.0);
  for (int n = 0; n <= orders; ++n) {
    Flexibility r = response(n);
    if (n == orders) r = {0.5 * r.radial, 0.5 * r.mixed, 0.5 * r.tangential};  // the Nyquist order counts half
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) {
        const double a = grid.coordinate[i], b = grid.coordinate[j];
        const double ci = std::cos(n * a) * std::cos(a), si = -std::sin(n * a) * std::sin(a);
        const double cj = std::cos(n * b) * std::cos(b), sj = -std::sin(n * b) * std::sin(b);
        w[i * count + j] += (r.radial * ci * cj + r.mixed * (ci * sj + si * cj) + r.tangential * si * sj) / pi;
      }
    }
  }
  return w;
}

void add(Flexibility& sum, const Mode& mode, double sign) {
  const double compliance = sign / (mode.omega * mode.omega);
  sum.radial += mode.radial * mode.radial * compliance;
  sum.mixed += mode.radial * mode.tangential * compliance;
  sum.tangential += mode.tangential * mode.tangential * compliance;
}

class DiskBody : public ::testing::TestWithParam<double> {
 protected:
  const double poisson = GetParam();
};

TEST_P(DiskBody, HoldsTheModes) {
  const Body body = disk(poisson, 25.0);
  const auto modes = bodies::disk::modes(poisson, 25.0);
  EXPECT_EQ(mode_count(body), modes.size());
  EXPECT_DOUBLE_EQ(body.mass, pi);
  EXPECT_EQ(body.extent, 1.0);
  EXPECT_EQ(body.cutoff, 25.0);
  std::size_t k = 0;
  for (const ModeGroup& group : body.groups) {
    for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
      EXPECT_EQ(group.order, modes[k].order);
      EXPECT_EQ(group.omega[l], modes[k].omega);
      EXPECT_NEAR(group.upper[l] + group.lower[l], modes[k].radial, 1e-15);
      EXPECT_NEAR(group.upper[l] - group.lower[l], modes[k].tangential, 1e-15);
    }
  }
}

TEST_P(DiskBody, GridHasTheShapesCosAndSinNPhi) {
  const Body body = disk(poisson, 25.0);
  for (const double half_width : {0.02, 0.4, 0.5 * pi}) {
    const ContactGrid grid = test::grid_of(body, half_width, 40);
    ASSERT_EQ(grid.coordinate.size(), 40U);
    const double h = 2.0 * grid.coordinate.front();
    EXPECT_GE(40.0 * h, half_width * (1.0 - 1e-12));
    const double pressure_speed = 1.0 / std::sqrt(1.0 - poisson * poisson);
    const double shear_speed = 1.0 / std::sqrt(2.0 * (1.0 + poisson));
    for (std::size_t i = 0; i < 40; ++i) {
      const double phi = (static_cast<double>(i) + 0.5) * h;
      EXPECT_NEAR(grid.coordinate[i], phi, 1e-14);
      EXPECT_NEAR(grid.recess[i], 1.0 - std::cos(phi), 1e-15);
      EXPECT_NEAR(grid.measure[i], 2.0 * h, 1e-15);
      const double c = std::cos(phi), s = std::sin(phi);
      EXPECT_NEAR(grid.impedance[i] * (c * c / pressure_speed + s * s / shear_speed), 2.0 * h, 1e-14);
      for (std::size_t g = 0; g < body.groups.size(); ++g) {
        const int n = body.groups[g].order;
        const double sum = grid.shape[body.groups[g].upper_row * 40 + i];
        const double difference = grid.shape[body.groups[g].lower_row * 40 + i];
        EXPECT_NEAR(0.5 * (sum + difference), std::cos(n * phi) * c, 1e-13);
        EXPECT_NEAR(0.5 * (sum - difference), -std::sin(n * phi) * s, 1e-13);
      }
    }
  }
}

TEST_P(DiskBody, GridsOfTheWholeAndOfHalfTheEdgeEndThere) {
  const Body body = disk(poisson, 5.0);
  for (int nodes = 16; nodes < 400; ++nodes) {
    EXPECT_NEAR(nodes * test::grid_of(body, pi, nodes).measure.front(), 2.0 * pi, 1e-12) << nodes;
    EXPECT_NEAR(nodes * test::grid_of(body, 0.5 * pi, nodes).measure.front(), pi, 1e-12) << nodes;
  }
}

TEST_P(DiskBody, RecessKeepsItsDigitsOnATinyGrid) {
  const ContactGrid grid = test::grid_of(disk(poisson, 12.5), 1e-4, 16);
  for (std::size_t i = 0; i < 16; ++i) {
    const double phi = grid.coordinate[i];
    EXPECT_NEAR(grid.recess[i] / (0.5 * phi * phi * (1.0 - phi * phi / 12.0)), 1.0, 1e-14);
  }
}

TEST_P(DiskBody, ResidualComplianceIsTheSumOverOrders) {
  constexpr double cutoff = 25.0;
  const Body body = disk(poisson, cutoff);
  std::map<int, Flexibility> kept;
  for (const Mode& mode : bodies::disk::modes(poisson, cutoff)) add(kept[mode.order], mode, -1.0);
  for (const double half_width : {0.05, 0.5, 0.5 * pi}) {
    const ContactGrid grid = test::grid_of(body, half_width, 20);
    const auto found = body.residual_compliance(grid.points, {});
    const auto expected = double_sum(grid, nyquist(grid), [&](int n) {
      Flexibility r = static_flexibility(poisson, n);
      r.radial += kept[n].radial;
      r.mixed += kept[n].mixed;
      r.tangential += kept[n].tangential;
      return r;
    });
    for (std::size_t k = 0; k < found.size(); ++k)
      EXPECT_NEAR(found[k], expected[k], 1e-12 + 1e-3 / std::pow(nyquist(grid), 3)) << half_width;
  }
}

TEST_P(DiskBody, ResidualSecondMomentIsThatOfTheModesThemselves) {
  // What V loses between two cutoffs is what the modes between them hold; and V is positive.
  const Body low = disk(poisson, 20.0), high = disk(poisson, 80.0);
  const ContactGrid grid = test::grid_of(low, 0.5, 24);
  std::map<int, Flexibility> between;
  for (const Mode& mode : bodies::disk::modes(poisson, 80.0)) {
    if (mode.omega > 20.0) add(between[mode.order], mode, 1.0 / (mode.omega * mode.omega));
  }
  const auto expected = double_sum(grid, nyquist(grid), [&](int n) { return between[n]; });
  const auto v_low = low.residual_second_moment(grid.points, {}), v_high = high.residual_second_moment(grid.points, {});
  // The lower cutoff leaves out orders above 160, the higher one keeps none of them.
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(v_low[k] - v_high[k], expected[k], 1e-7);
  EXPECT_GT(std::abs(expected[0]), 1e-5);
  EXPECT_GT(v_high[0], 0.0);
}

TEST_P(DiskBody, StaticSecondMomentIsTheSumOverTheModes) {
  std::map<int, Flexibility> sum;
  for (const Mode& mode : bodies::disk::modes(poisson, 300.0))
    add(sum[mode.order], mode, 1.0 / (mode.omega * mode.omega));
  for (const int n : {0, 1, 2, 3, 7, 20}) {
    const Flexibility closed = static_second_moment(poisson, n);
    const double scale = closed.radial + closed.tangential;
    EXPECT_NEAR(closed.radial / scale, sum[n].radial / scale, 1e-4) << n;
    EXPECT_NEAR(closed.mixed / scale, sum[n].mixed / scale, 1e-4) << n;
    EXPECT_NEAR(closed.tangential / scale, sum[n].tangential / scale, 1e-4) << n;
    EXPECT_GE(closed.radial + 1e-15, sum[n].radial) << n;  // all modes, not only those below 300
  }
}

TEST_P(DiskBody, GridMayCoverTheWholeEdge) {
  const Body body = disk(poisson, 12.5);
  const auto w = body.residual_compliance(test::grid_of(body, pi, 40).points, {});
  EXPECT_NO_THROW(Complementarity(w, 40));
}

TEST_P(DiskBody, ResidualComplianceIsThatOfTheModesThemselves) {
  // No closed form here: what W loses between two cutoffs is what the modes between them hold.
  const Body low = disk(poisson, 20.0), high = disk(poisson, 80.0);
  const ContactGrid grid = test::grid_of(low, 0.5, 24), same = test::grid_of(high, 0.5, 24);
  ASSERT_EQ(grid.coordinate, same.coordinate);
  std::map<int, Flexibility> between;
  for (const Mode& mode : bodies::disk::modes(poisson, 80.0)) {
    if (mode.omega > 20.0) add(between[mode.order], mode, 1.0);
  }
  const auto expected = double_sum(grid, nyquist(grid), [&](int n) { return between[n]; });
  const auto w_low = low.residual_compliance(grid.points, {}), w_high = high.residual_compliance(same.points, {});
  double largest = 0.0;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_NEAR(w_low[k] - w_high[k], expected[k], 1e-13);
    largest = std::max(largest, std::abs(expected[k]));
  }
  EXPECT_GT(largest, 1e-2);
}

TEST_P(DiskBody, ResidualComplianceIsSymmetricPositiveDefinite) {
  for (const double cutoff : {12.5, 50.0}) {
    const Body body = disk(poisson, cutoff);
    for (const double half_width : {0.01, 0.3, 0.5 * pi}) {
      const auto w = body.residual_compliance(test::grid_of(body, half_width, 64).points, {});
      for (std::size_t i = 0; i < 64; ++i) {
        EXPECT_GT(w[i * 64 + i], 0.0);
        for (std::size_t j = 0; j < i; ++j) EXPECT_EQ(w[i * 64 + j], w[j * 64 + i]);
      }
      EXPECT_NO_THROW(Complementarity(w, 64)) << "half-width " << half_width << ", cutoff " << cutoff;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Poisson, DiskBody, ::testing::Values(-0.9, -0.5, 0.0, 0.33, 0.9, 0.99));

}  // namespace
}  // namespace stoss
