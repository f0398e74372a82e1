// The contact with the edge law: what each node must obey, its energy, and that the force follows the exact contact.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "contact/edge/edge_contact.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/errors.hpp"
#include "support/pressing.hpp"

namespace stoss {
namespace {

std::vector<double> random_compliance(std::size_t n, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto size = static_cast<Eigen::Index>(n);
  Eigen::MatrixXd a(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) a(i, j) = normal(random);
  }
  const Eigen::MatrixXd w = a * a.transpose() + 0.05 * Eigen::MatrixXd::Identity(size, size);
  return {w.data(), w.data() + w.size()};
}

void expect_solution(const std::vector<double>& w, const EdgeLaw& law, const std::vector<double>& q,
                     const std::vector<double>& f, const std::vector<double>& u) {
  const std::size_t n = q.size();
  for (std::size_t i = 0; i < n; ++i) {
    double moved = 0.0;
    for (std::size_t j = 0; j < n; ++j) moved += w[i * n + j] * f[j];
    EXPECT_NEAR(moved, u[i], 1e-9) << i;
    const double gap = u[i] - q[i];
    EXPECT_GE(f[i], 0.0);
    EXPECT_GE(gap, -1e-11) << i;
    if (f[i] == 0.0) {
      EXPECT_GE(gap, law.gap[i] * (1.0 - 1e-7)) << i;
    } else if (f[i] >= law.force[i]) {
      EXPECT_NEAR(gap, 0.0, 1e-10) << i;
    } else {
      EXPECT_NEAR(std::sqrt(f[i] / law.force[i]) + std::sqrt(std::max(0.0, gap) / law.gap[i]), 1.0, 1e-5) << i;
    }
  }
}

TEST(EdgeContact, SolvesProblemsOfAnyKind) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 300; ++trial) {
    const std::size_t n = 1 + static_cast<std::size_t>(trial % 17) + 1;
    const std::vector<double> w = random_compliance(n, random);
    EdgeLaw law;
    for (std::size_t i = 0; i < n; ++i) {
      law.force.push_back(std::exp(2.0 * normal(random)));
      law.gap.push_back(std::exp(2.0 * normal(random)));
    }
    EdgeContact contact(w, law, n, {});
    std::vector<double> q(n), f(n), u(n);
    for (int again = 0; again < 5; ++again) {  // from the solution before
      for (double& each : q) each = 3.0 * normal(random);
      contact.solve(q, f, u);
      expect_solution(w, law, q, f, u);
      for (std::size_t i = contact.extent(); i < n; ++i) EXPECT_EQ(f[i], 0.0);
    }
  }
}

TEST(EdgeContact, HasTheForceForTheGradientOfItsEnergy) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  constexpr std::size_t n = 6;
  const std::vector<double> w = random_compliance(n, random);
  const EdgeLaw law{std::vector<double>(n, 0.7), std::vector<double>(n, 0.9)};
  EdgeContact contact(w, law, n, {});
  std::vector<double> q(n), f(n), u(n), g(n);
  const auto energy = [&](const std::vector<double>& at) {
    contact.solve(at, g, u);
    return contact.energy(g, u);
  };
  for (int trial = 0; trial < 20; ++trial) {
    for (double& each : q) each = 2.0 * normal(random);
    contact.solve(q, f, u);
    for (std::size_t i = 0; i < n; ++i) {
      constexpr double small = 1e-5;
      std::vector<double> up = q, down = q;
      up[i] += small;
      down[i] -= small;
      EXPECT_NEAR((energy(up) - energy(down)) / (2.0 * small), f[i], 1e-6 * (1.0 + f[i]));
    }
  }
}

TEST(EdgeContact, OfASinglePointIsUnilateral) {
  EdgeContact contact({2.0}, {}, 1, {});
  std::vector<double> f(1), u(1);
  contact.solve({3.0}, f, u);
  EXPECT_EQ(f[0], 1.5);
  EXPECT_EQ(u[0], 3.0);
  contact.solve({-1e-9}, f, u);
  EXPECT_EQ(f[0], 0.0);
  EXPECT_EQ(contact.extent(), 0U);
}

TEST(EdgeContact, RefusesWhatIsNoContact) {
  EXPECT_THROW(EdgeContact({1.0, 2.0, 2.0, 1.0}, {{1.0, 1.0}, {1.0, 1.0}}, 2, {}), NotConverged);
  EdgeContact contact({1.0}, {}, 1, {});
  std::vector<double> f(1), u(1);
  EXPECT_THROW(contact.solve({std::nan("")}, f, u), NotConverged);
}

// A disk at a wall: total force and half-width against the compression of its centre, by all its modes but the lowest
// pair.
TEST(Pressed, FollowsTheExactContactAtAShiftedCompression) {
  constexpr int coarse = 24, fine = 600;
  constexpr double width = 0.2;
  const Contact disk_at_wall = contact(disk(0.33, 1.45));
  test::Pressing few(disk_at_wall, width, coarse), many(disk_at_wall, width, fine);
  const double h = std::numbers::pi / std::floor(std::numbers::pi * coarse / width);
  double worst = 0.0, without = 0.0, wide = 0.0;
  for (int i = 0; i < 40; ++i) {
    const double compression = 0.02 * (1.0 + 0.007 * i);
    const double exact = many.with_law(compression + h * h / 24.0).force;
    const test::Press press = few.with_law(compression);
    worst = std::max(worst, std::abs(press.force / exact - 1.0));
    without = std::max(without, std::abs(few.without_law(compression) / exact - 1.0));
    wide = std::max(wide, std::abs(press.half_width - many.with_law(compression).half_width) / h);
  }
  EXPECT_LT(worst, 3e-5);
  EXPECT_GT(without, 10.0 * worst);
  EXPECT_LT(wide, 0.1);  // of a spacing
}

}  // namespace
}  // namespace stoss
