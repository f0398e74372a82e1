// The contact of both directions: what each node must obey, and its limits.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "contact/coupled/coupled_contact.hpp"
#include "contact/edge/edge_contact.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace coupled_contact {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t points = 6;

struct Problem {
  std::vector<double> normal_even, along_even;
  EdgeLaw law;
  double friction;
};

std::vector<double> values(const MatrixXd& matrix) { return {matrix.data(), matrix.data() + matrix.size()}; }

/// Blocks with directions that mix as much as `coupling`, positive definite up to 1.
Problem random_problem(double coupling, double friction, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto block = [&] {
    const auto n = static_cast<Index>(2 * points), half = static_cast<Index>(points);
    MatrixXd a(n, n);
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j < n; ++j) a(i, j) = normal(random);
    }
    MatrixXd w = a * a.transpose() + 0.5 * MatrixXd::Identity(n, n);
    w.topRightCorner(half, half) *= coupling;
    w.bottomLeftCorner(half, half) *= coupling;
    return values(w);
  };
  Problem problem{block(), block(), {}, friction};
  for (std::size_t i = 0; i < points; ++i) {
    problem.law.force.push_back(std::exp(normal(random)));
    problem.law.gap.push_back(std::min(1.0, std::exp(normal(random))));
  }
  return problem;
}

VectorXd random_vector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  VectorXd result(static_cast<Index>(2 * points));
  for (double& value : result) value = normal(random);
  return result;
}

/// Both laws at every node, for a first step out of contact: D is −dg/df from there.
void expect_laws(const Problem& problem, const CoupledContact& contact, const VectorXd& x, const VectorXd& y,
                 const VectorXd& gap_before) {
  const CoupledCompliance w = compliance_of_sides(problem.normal_even, problem.along_even, points);
  const VectorXd f = contact.force(), q = contact.friction();
  const VectorXd gap = w.xx * f + w.xy * q - x, moved = w.yy * q + w.xy.transpose() * f;
  for (Index i = 0; i < f.size(); ++i) {
    const auto node = static_cast<std::size_t>(i) % points;
    const double share = 0.5 * problem.law.force[node], reach = problem.law.gap[node];
    EXPECT_GE(f(i), 0.0);
    EXPECT_GE(gap(i), -1e-8);
    if (f(i) == 0.0) {
      EXPECT_GE(gap(i), reach * (1.0 - 1e-7));
      EXPECT_EQ(q(i), 0.0);
      continue;
    }
    if (f(i) < share) {
      EXPECT_NEAR(std::sqrt(f(i) / share) + std::sqrt(std::max(0.0, gap(i)) / reach), 1.0, 1e-5);
    }
    const double open = f(i) < share ? gap(i) : 0.0, give = std::max(0.0, (gap_before(i) - open) / f(i));
    const double slip = y(i) - moved(i) - give * q(i), limit = problem.friction * f(i);
    EXPECT_LE(std::abs(q(i)), limit * (1.0 + 1e-8));
    if (std::abs(slip) > 1e-7) {
      EXPECT_NEAR(q(i), slip > 0.0 ? limit : -limit, 1e-7 * (1.0 + limit));
    }
  }
}

TEST(CoupledContact, ObeysBothLawsAtEveryNode) {
  std::mt19937 random(11);
  int stuck = 0, sliding = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Problem problem = random_problem(0.2, trial % 2 == 0 ? 0.2 : 0.8, random);
    CoupledContact contact(compliance_of_sides(problem.normal_even, problem.along_even, points), problem.law,
                           problem.friction, 1.0, {});
    const VectorXd far = VectorXd::Constant(static_cast<Index>(2 * points), -1.5), x = random_vector(random),
                   y = random_vector(random);
    contact.solve(far, y);
    EXPECT_EQ(contact.force().norm(), 0.0);
    contact.solve(x, y);
    expect_laws(problem, contact, x, y, -far);
    for (Index i = 0; i < x.size(); ++i) {
      const double limit = problem.friction * contact.force()(i);
      if (limit > 0.0) ++(std::abs(contact.friction()(i)) < 0.999 * limit ? stuck : sliding);
    }
  }
  EXPECT_GT(stuck, 300);
  EXPECT_GT(sliding, 300);
}

TEST(CoupledContact, IsThatOfTheNormalAloneWithoutCoupling) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 50; ++trial) {
    const Problem problem = random_problem(0.0, 0.5, random);
    CoupledContact sided(compliance_of_sides(problem.normal_even, problem.along_even, points), problem.law, 0.5, 1.0,
                         {});
    const auto half = static_cast<Index>(points);
    const MatrixXd even = MatrixXd::Map(problem.normal_even.data(), 2 * half, 2 * half).topLeftCorner(half, half);
    EdgeContact one(values(even), problem.law, points, {});
    VectorXd x = random_vector(random);
    x.tail(half) = x.head(half);
    std::vector<double> force(points), displacement(points);
    one.solve({x.data(), x.data() + half}, force, displacement);
    sided.solve(x, random_vector(random));
    for (std::size_t i = 0; i < points; ++i) {
      const auto k = static_cast<Index>(i);
      EXPECT_NEAR(sided.force()(k) + sided.force()(half + k), force[i], 1e-9 * (1.0 + force[i]));
      EXPECT_NEAR(sided.force()(k), sided.force()(half + k), 1e-9 * (1.0 + force[i]));
    }
  }
}

// Rings are both sides at once where these are alike.
TEST(CoupledContact, TakesRings) {
  std::mt19937 random(8);
  const auto half = static_cast<Index>(points);
  for (int trial = 0; trial < 50; ++trial) {
    const Problem problem = random_problem(0.2, 0.4, random);
    CoupledContact sided(compliance_of_sides(problem.normal_even, problem.along_even, points), problem.law, 0.4, 1.0,
                         {});
    const MatrixXd block = MatrixXd::Map(problem.normal_even.data(), 2 * half, 2 * half);
    CoupledContact rings(
        {block.topLeftCorner(half, half), block.topRightCorner(half, half), block.bottomRightCorner(half, half)},
        problem.law, 0.4, 1.0, {});
    VectorXd x = random_vector(random), y = random_vector(random);
    x.tail(half) = x.head(half);
    y.tail(half) = -y.head(half);
    sided.solve(x, y);
    rings.solve(x.head(half), y.head(half));
    const double scale = 1.0 + rings.force().norm();
    EXPECT_LT((2.0 * sided.force().head(half) - rings.force()).norm(), 1e-8 * scale);
    EXPECT_LT((2.0 * sided.friction().head(half) - rings.friction()).norm(), 1e-8 * scale);
    EXPECT_EQ(sided.extent(), rings.extent());
    EXPECT_NEAR(sided.half_width(), rings.half_width(), 1e-8);
  }
}

// What is reflected in the axis is the same problem.
TEST(CoupledContact, TurnsWithTheSignOfTheSlip) {
  std::mt19937 random(3);
  const Problem problem = random_problem(0.3, 0.5, random);
  const CoupledCompliance compliance = compliance_of_sides(problem.normal_even, problem.along_even, points);
  CoupledContact one(compliance, problem.law, 0.5, 1.0, {}), other(compliance, problem.law, 0.5, 1.0, {});
  const VectorXd x = random_vector(random), y = random_vector(random);
  const auto mirrored = [](const VectorXd& v, double sign) {
    const Index half = v.size() / 2;
    VectorXd result(v.size());
    result << sign * v.tail(half), sign * v.head(half);
    return result;
  };
  one.solve(x, y);
  other.solve(mirrored(x, 1.0), mirrored(y, -1.0));
  EXPECT_LT((other.force() - mirrored(one.force(), 1.0)).norm(), 1e-9 * one.force().norm());
  EXPECT_LT((other.friction() - mirrored(one.friction(), -1.0)).norm(), 1e-9 * one.force().norm());
}

TEST(CoupledContact, RefusesPositionsThatAreNoNumbers) {
  std::mt19937 random(1);
  const Problem problem = random_problem(0.2, 0.5, random);
  CoupledContact contact(compliance_of_sides(problem.normal_even, problem.along_even, points), problem.law, 0.5, 1.0,
                         {});
  VectorXd x = random_vector(random);
  const VectorXd y = x;
  x(3) = std::nan("");
  EXPECT_THROW(contact.solve(x, y), NotConverged);
}

}  // namespace
}  // namespace coupled_contact
}  // namespace stoss
