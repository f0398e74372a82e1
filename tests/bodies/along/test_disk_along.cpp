// A disk against forces along its edge: its modes, and W and V of both blocks against sums order by order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/modes.hpp"

namespace stoss {
using namespace bodies::disk;

namespace disk_along {
namespace {

using std::numbers::pi;
constexpr double cutoff = 12.5;
constexpr std::size_t count = 9;
constexpr double poissons[] = {-0.6, 0.0, 0.33, 0.9};

ContactPoints equal_points(std::size_t spacings) { return {1.0, pi / static_cast<double>(spacings), count}; }

double angle_of(const ContactPoints& points, std::size_t i) {
  return std::asin(points.radius * std::sin(points.angle(i)));
}

/// What a mode moves along x and y at φ, of the symmetric kind (0) or its brother (1).
struct Moved {
  double x, y;
};

Moved moved(const Mode& mode, int kind, double phi) {
  const double n = mode.order;
  const double radial = mode.radial * (kind == 0 ? std::cos(n * phi) : std::sin(n * phi));
  const double around = mode.tangential * (kind == 0 ? std::sin(n * phi) : -std::cos(n * phi));
  return {radial * std::cos(phi) - around * std::sin(phi), radial * std::sin(phi) + around * std::cos(phi)};
}

Mode torsion(double omega) { return {0, 0, omega, 0.0, 1.0}; }

/// The values at all points, first component then second: x, y of kind 0 and y, x of kind 1.
std::vector<double> values(const Mode& mode, int kind, const ContactPoints& points) {
  std::vector<double> result(2 * points.count);
  for (std::size_t i = 0; i < points.count; ++i) {
    const Moved at = moved(mode, kind, angle_of(points, i));
    result[i] = kind == 0 ? at.x : at.y;
    result[points.count + i] = kind == 0 ? at.y : at.x;
  }
  return result;
}

/// Zeros of J₂ up to a number.
std::vector<double> torsional(double poisson, double highest) {
  constexpr double zeros[] = {5.135622301840683, 8.417244140399865, 11.61984117214906, 14.79595178235126,
                              17.95981949498783, 21.11699705302185, 24.27011231357310};
  std::vector<double> omega;
  for (const double zero : zeros) {
    if (zero / std::sqrt(2.0 * (1.0 + poisson)) <= highest) omega.push_back(zero / std::sqrt(2.0 * (1.0 + poisson)));
  }
  return omega;
}

class DiskAlong : public ::testing::TestWithParam<double> {
 protected:
  const double poisson = GetParam();
  const Body body = disk(poisson, cutoff);
  const std::vector<Body> along = body.along({});
};

TEST_P(DiskAlong, MovesByTheModesAndTheirBrothers) {
  const ContactPoints points{0.7, 0.05, count};
  for (int kind = 0; kind < 2; ++kind) {
    const Body& each = along[static_cast<std::size_t>(kind)];
    validate(each);
    ASSERT_EQ(each.components, 2U);
    const Surface surface = each.surface(points);
    std::vector<Mode> modes = bodies::disk::modes(poisson, cutoff);
    if (kind == 1) {
      std::erase_if(modes, [](const Mode& mode) { return mode.order == 0; });
      const std::vector<double> omega = torsional(poisson, cutoff);
      for (std::size_t k = omega.size(); k-- > 0;) modes.insert(modes.begin(), torsion(omega[k]));
    }
    std::size_t k = 0;
    for (const ModeGroup& group : each.groups) {
      for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
        ASSERT_LT(k, modes.size());
        EXPECT_NEAR(group.omega[l], modes[k].omega, 1e-13 * modes[k].omega);
        const std::vector<double> expected = values(modes[k], kind, points);
        for (std::size_t i = 0; i < 2 * count; ++i) {
          const double value = group.upper[l] * surface.shape[group.upper_row * 2 * count + i] +
                               group.lower[l] * surface.shape[group.lower_row * 2 * count + i];
          EXPECT_NEAR(value, expected[i], 3e-14) << "order " << group.order << " mode " << l << " value " << i;
        }
      }
    }
    EXPECT_EQ(k, modes.size());
  }
}

/// The sum over the orders up to `highest`, the last with weight ½, of what is left of a response without the kept
/// modes.
std::vector<double> sum_by_order(double poisson, int kind, int power, const ContactPoints& points, int last,
                                 int highest) {
  std::vector<double> sum(4 * points.count * points.count);
  const auto add = [&](const std::vector<double>& a, const std::vector<double>& b, double weight) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < a.size(); ++j) sum[i * a.size() + j] += weight / pi * a[i] * b[j];
    }
  };
  std::vector<Mode> kept = bodies::disk::modes(poisson, cutoff);
  double twist = power == 2 ? (1.0 + poisson) / 6.0 : (1.0 + poisson) * (1.0 + poisson) / 144.0;
  for (const double omega : torsional(poisson, cutoff)) twist -= std::pow(omega, -power);
  for (int n = 0; n <= highest; ++n) {
    const double weight = n == last ? 0.5 : 1.0;
    Flexibility left = power == 2 ? static_flexibility(poisson, n) : static_second_moment(poisson, n);
    for (const Mode& mode : kept) {
      if (mode.order != n) continue;
      const double share = std::pow(mode.omega, -power);
      left.radial -= share * mode.radial * mode.radial;
      left.mixed -= share * mode.radial * mode.tangential;
      left.tangential -= share * mode.tangential * mode.tangential;
    }
    if (n == 0) left.tangential = twist;
    const std::vector<double> c = values({n, 0, 1.0, 1.0, 0.0}, kind, points),
                              s = values({n, 0, 1.0, 0.0, 1.0}, kind, points);
    add(c, c, weight * left.radial);
    add(c, s, weight * left.mixed);
    add(s, c, weight * left.mixed);
    add(s, s, weight * left.tangential);
  }
  return sum;
}

double difference(const std::vector<double>& matrix, const std::vector<double>& expected) {
  EXPECT_EQ(matrix.size(), expected.size());
  double worst = 0.0, greatest = 0.0;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    worst = std::max(worst, std::abs(matrix[k] - expected[k]));
    greatest = std::max(greatest, std::abs(expected[k]));
  }
  return worst / greatest;
}

TEST_P(DiskAlong, AnswersAsTheSumOverTheOrders) {
  constexpr int spacings = 200;
  const ContactPoints points = equal_points(spacings);
  for (int kind = 0; kind < 2; ++kind) {
    const Body& each = along[static_cast<std::size_t>(kind)];
    // What is left is the error of harmonic_sums, O(N⁻⁴).
    EXPECT_LT(
        difference(each.residual_compliance(points, {}), sum_by_order(poisson, kind, 2, points, spacings, spacings)),
        1e-10);
    EXPECT_LT(
        difference(each.residual_second_moment(points, {}), sum_by_order(poisson, kind, 4, points, spacings, 100)),
        1e-13);
  }
}

TEST_P(DiskAlong, AnswersSlowForcesOnASmallerCircleAsTheSumOverTheOrders) {
  const ContactPoints points{0.4, 0.02, count};
  const int resolved = static_cast<int>(std::lround(pi / (points.spacing * points.radius)));
  for (int kind = 0; kind < 2; ++kind) {
    const std::vector<double> expected = sum_by_order(poisson, kind, 4, points, resolved, 100);
    EXPECT_LT(difference(along[static_cast<std::size_t>(kind)].residual_second_moment(points, {}), expected), 1e-13);
  }
}

// W of points on a circle of nearly the size of the disk is that at equal angles: both ways of summing agree.
TEST_P(DiskAlong, AnswersTheSameOnACircleOfItsSize) {
  const ContactPoints points = equal_points(200), nearly{1.0 - 1e-9, points.spacing, points.count};
  for (const Body& each : along) {
    EXPECT_LT(difference(each.residual_compliance(nearly, {}), each.residual_compliance(points, {})), 1e-7);
    EXPECT_LT(difference(each.residual_second_moment(nearly, {}), each.residual_second_moment(points, {})), 1e-7);
  }
}

TEST_P(DiskAlong, AnswersNormalForcesAsTheDiskDoes) {
  for (const ContactPoints& points : {equal_points(200), ContactPoints{0.4, 0.02, count}}) {
    const std::vector<double> alone = body.residual_compliance(points, {}),
                              both = along[0].residual_compliance(points, {});
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) {
        EXPECT_NEAR(both[i * 2 * count + j], alone[i * count + j], 1e-13 * alone.front());
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Every, DiskAlong, ::testing::ValuesIn(poissons),
                         [](const auto& info) { return "number" + std::to_string(info.index); });

// As the whole with size 1; half the size, half the time and a quarter of the mass.
TEST(DiskAlongNearSide, IsThatOfASmallerDisk) {
  const Body whole = disk(0.33, 10.0);
  const Body part = whole.near_side(0.5, 20.0, {});
  const std::vector<Body> along = part.along({}), expected = disk(0.33, 10.0).along({});
  EXPECT_DOUBLE_EQ(part.inertia, whole.inertia / 16.0);
  for (std::size_t k = 0; k < 2; ++k) {
    validate(along[k]);
    const ContactPoints points{0.5, 0.02, count}, seen{1.0, 0.02, count};
    EXPECT_EQ(along[k].residual_compliance(points, {}), expected[k].residual_compliance(seen, {}));
    const std::vector<double> moment = along[k].residual_second_moment(points, {});
    const std::vector<double> like = expected[k].residual_second_moment(seen, {});
    for (std::size_t i = 0; i < moment.size(); ++i) EXPECT_DOUBLE_EQ(moment[i], 0.25 * like[i]);
    EXPECT_EQ(along[k].mass, part.mass);
    EXPECT_EQ(along[k].surface(points).recess[count + 2], part.surface(points).recess[2]);
    EXPECT_EQ(along[k].groups[1].omega[0], 2.0 * expected[k].groups[1].omega[0]);
  }
}

}  // namespace
}  // namespace disk_along
}  // namespace stoss
