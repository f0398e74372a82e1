// W and V of a disk at points that are equally spaced on a smaller circle, against sums over the orders.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "support/disk_pairs.hpp"

namespace stoss {
using namespace bodies::disk;

namespace {

using std::numbers::pi;
constexpr double cutoff = 12.5, poisson = 0.33;

using Response = std::function<Flexibility(int)>;

double angle_of(const ContactPoints& points, double alpha) { return std::asin(points.radius * std::sin(alpha)); }

/// A smooth load per dα, both sides, of width `width`, which vanishes at the ends of the grid to rounding.
double load(double alpha, double width) { return std::exp(-alpha * alpha / (width * width)); }

/// What the load moves each point, order by order; the load is integrated, not put on the points.
std::vector<double> displaced(const ContactPoints& points, double width, int orders, const Response& response) {
  constexpr int fine = 6;
  const double step = points.spacing / fine;
  const auto samples = static_cast<int>(points.count) * fine;
  std::vector<double> moved(points.count, 0.0);
  for (int n = 0; n <= orders; ++n) {
    double c = 0.0, s = 0.0;
    for (int k = 0; k < samples; ++k) {
      const double alpha = (k + 0.5) * step, phi = angle_of(points, alpha), force = load(alpha, width) * step;
      c += force * std::cos(n * phi) * std::cos(phi);
      s -= force * std::sin(n * phi) * std::sin(phi);
    }
    const Flexibility r = response(n);
    for (std::size_t i = 0; i < points.count; ++i) {
      const double phi = angle_of(points, points.angle(i));
      moved[i] += (std::cos(n * phi) * std::cos(phi) * (r.radial * c + r.mixed * s) -
                   std::sin(n * phi) * std::sin(phi) * (r.mixed * c + r.tangential * s)) /
                  pi;
    }
  }
  return moved;
}

/// Maximum difference over the maximum displacement, with the load on the points.
double difference(const std::vector<double>& matrix, const ContactPoints& points, double width,
                  const std::vector<double>& expected) {
  double worst = 0.0, greatest = 0.0;
  for (std::size_t i = 0; i < points.count; ++i) {
    double moved = 0.0;
    for (std::size_t j = 0; j < points.count; ++j) {
      moved += matrix[i * points.count + j] * load(points.angle(j), width) * points.spacing;
    }
    worst = std::max(worst, std::abs(moved - expected[i]));
    greatest = std::max(greatest, std::abs(expected[i]));
  }
  return worst / greatest;
}

/// Static answer less that of the kept modes, with ω to the power 2 or 4.
Response residual(int power) {
  std::vector<Flexibility> kept;
  for (const Mode& mode : bodies::disk::modes(poisson, cutoff)) {
    kept.resize(static_cast<std::size_t>(mode.order) + 1);
    const double weight = std::pow(mode.omega, -power);
    kept.back().radial += weight * mode.radial * mode.radial;
    kept.back().mixed += weight * mode.radial * mode.tangential;
    kept.back().tangential += weight * mode.tangential * mode.tangential;
  }
  return [kept, power](int n) {
    Flexibility all = power == 2 ? static_flexibility(poisson, n) : static_second_moment(poisson, n);
    if (const auto at = static_cast<std::size_t>(n); at < kept.size()) {
      all.radial -= kept[at].radial;
      all.mixed -= kept[at].mixed;
      all.tangential -= kept[at].tangential;
    }
    return all;
  };
}

class MappedAngles : public ::testing::TestWithParam<double> {
 protected:
  const double radius = GetParam();
  const Body body = disk(poisson, cutoff);
  static constexpr double width = 0.22;
  const ContactPoints points{radius, pi / 84.0, 40};  // to α = 1.5
  // The spectrum of the load in φ ≈ radius · α falls as exp(−(n · radius · width)²/4).
  const int orders = static_cast<int>(12.5 / (radius * width));
};

TEST_P(MappedAngles, ComplianceIsTheSumOverTheOrders) {
  const auto matrix = body.residual_compliance(points, {});
  EXPECT_LT(difference(matrix, points, width, displaced(points, width, orders, residual(2))), 1e-8);
}

TEST_P(MappedAngles, SecondMomentIsTheSumOverTheOrdersUpToEightTimesTheCutoff) {
  const auto matrix = body.residual_second_moment(points, {});
  const int highest = static_cast<int>(8.0 * cutoff);
  const auto expected = displaced(points, width, std::min(orders, highest), residual(4));
  EXPECT_LT(difference(matrix, points, width, expected), 1e-8);
}

TEST_P(MappedAngles, BothAreSymmetricAndPositive) {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  for (const double half_angle : {0.05, 0.6, 0.5 * pi}) {
    constexpr Eigen::Index count = 48;
    const ContactPoints some{radius, half_angle / count, count};
    const auto w = body.residual_compliance(some, {}), v = body.residual_second_moment(some, {});
    Matrix compliance = Eigen::Map<const Matrix>(w.data(), count, count);
    Matrix moment = Eigen::Map<const Matrix>(v.data(), count, count);
    EXPECT_EQ((compliance - compliance.transpose()).norm(), 0.0) << half_angle;
    EXPECT_LT((moment - moment.transpose()).norm(), 1e-12 * moment.norm()) << half_angle;
    EXPECT_EQ(compliance.llt().info(), Eigen::Success) << half_angle;
    moment.diagonal().array() += 1e-12 * moment.norm();  // V has no rank beyond its orders
    EXPECT_EQ(moment.llt().info(), Eigen::Success) << half_angle;
  }
}

INSTANTIATE_TEST_SUITE_P(RadiusRatio, MappedAngles, ::testing::Values(0.02, 0.1, 0.35, 0.7, 0.97, 1.0));

// On a circle of almost the same size everything is almost as at equally spaced angles, unresolved orders included.
TEST(AlmostEqualAngles, GiveAlmostTheSumsAtEqualAngles) {
  const Body body = disk(poisson, cutoff);
  for (const double half_angle : {0.1, 0.7, 1.5}) {
    constexpr std::size_t count = 24;
    const ContactPoints equal{1.0, pi / std::ceil(count * pi / half_angle), count};
    ContactPoints almost = equal;
    almost.radius = 1.0 - 1e-12;
    const auto w = body.residual_compliance(equal, {}), near_w = body.residual_compliance(almost, {});
    const auto v = body.residual_second_moment(equal, {}), near_v = body.residual_second_moment(almost, {});
    for (std::size_t k = 0; k < w.size(); ++k) {
      EXPECT_NEAR(near_w[k], w[k], 1e-8 * w.front()) << half_angle;
      EXPECT_NEAR(near_v[k], v[k], 1e-8 * v.front()) << half_angle;
    }
  }
}

// The contact adds what each body is by itself, in the units of the first.
TEST(PairResidual, IsTheSumOfBoth) {
  const Disk one{0.33};
  for (const Disk& other : test::other_disks) {
    const Contact pair = test::pair_of(one, other, cutoff);
    const ContactGrid grid = contact_grid(pair, 0.2, 16);
    const ContactPoints seen{grid.points.radius / other.radius, grid.points.spacing, grid.points.count};
    const auto first = pair.first->residual_compliance(grid.points, {});
    const auto second = pair.second->residual_compliance(seen, {});
    const auto first_v = pair.first->residual_second_moment(grid.points, {});
    const auto second_v = pair.second->residual_second_moment(seen, {});
    const auto w = residual_compliance(pair, grid), v = residual_second_moment(pair, grid);
    const double time = test::DiskUnits(other).time;
    for (std::size_t k = 0; k < w.size(); ++k) {
      EXPECT_NEAR(w[k], first[k] + second[k] / other.young, 1e-13 * w.front());
      EXPECT_NEAR(v[k], first_v[k] + second_v[k] / other.young * time * time, 1e-13 * v.front());
    }
  }
}

}  // namespace
}  // namespace stoss
