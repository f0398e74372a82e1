// The forces of rough nodes, found step by step with factors that are kept, against Newton's method from scratch.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "contact/edge/edge_law.hpp"
#include "contact/edge/edge_newton.hpp"
#include "contact/edge/kept_factor.hpp"
#include "contact/edge/rough_nodes.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {
namespace {

struct RoughProblem {
  Contact contact;
  ContactGrid grid;
  std::shared_ptr<const FactoredCompliance> compliance;
  EdgeLaw law;
};

RoughProblem rough_problem(const BodyMaker& body, double length, double speed, int nodes) {
  Contact rough_one = contact(rough(body, length)(9.0, {}));
  ContactGrid grid = contact_grid(rough_one, 0.6, nodes);
  auto compliance =
      std::make_shared<const FactoredCompliance>(residual_compliance(rough_one, grid), grid.recess.size(), Poll{});
  EdgeLaw law = edge_law(rough_one, grid, speed);
  return {std::move(rough_one), std::move(grid), std::move(compliance), std::move(law)};
}

/// Largest difference of its forces from those of Newton's method from a start that knows nothing, over their sum.
double from_scratch(const RoughProblem& of, const std::vector<double>& q, const std::vector<double>& force) {
  std::vector<double> closure(q.size());
  for (std::size_t i = 0; i < q.size(); ++i) closure[i] = of.law.first_closure(i, -q[i], of.compliance->matrix()(0, 0));
  EXPECT_TRUE(solve_all(*of.compliance, of.law, q, q.front(), {}, closure));
  double largest = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const double its = of.law.force_at(i, closure[i]);
    largest = std::max(largest, std::abs(its - force[i])), sum += its;
  }
  return largest / sum;
}

// In and out again with a wave on the surface, from asperities far below a step's way to far above it.
TEST(RoughNodes, HaveTheForcesOfNewtonsMethodInEachStep) {
  for (const BodyMaker& body : {sphere({.poisson = 0.3}), disk({.poisson = 0.3})}) {
    for (const double length : {1e-7, 1e-5, 1e-3, 1e-1}) {
      const RoughProblem of = rough_problem(body, length, 0.05, 37);
      RoughNodes nodes(of.compliance);
      const std::size_t n = of.grid.recess.size();
      std::vector<double> q(n), closure(n), force(n), displacement(n), moved(n);
      for (int step = 0; step < 60; ++step) {
        const double depth = 0.08 * std::sin(0.05 * step) + 1e-4 + 0.01 * length;
        for (std::size_t i = 0; i < n; ++i) {
          q[i] = depth - of.grid.recess[i] + 2e-3 * std::sin(0.4 * step + 9.0 * of.grid.coordinate[i]);
        }
        ASSERT_TRUE(nodes.solve(of.law, q, closure, force, displacement)) << length << " " << step;
        EXPECT_LT(from_scratch(of, q, force), 1e-10) << length << " " << step;
        of.compliance->multiply(0, n, force, moved);
        for (std::size_t i = 0; i < n; ++i) {
          EXPECT_NEAR(moved[i], displacement[i], 1e-9 * (std::abs(q[i]) + length)) << length << " " << step << " " << i;
        }
      }
    }
  }
}

// What a step begins with must not matter: leaps to and fro, and nodes that push apart from the others.
TEST(RoughNodes, DoNotDependOnTheStepBefore) {
  for (const double length : {1e-8, 1e-6, 1e-4, 1e-2}) {
    const RoughProblem of = rough_problem(sphere({.poisson = 0.3}), length, 0.05, 40);
    RoughNodes nodes(of.compliance);
    const std::size_t n = of.grid.recess.size();
    std::vector<double> q(n), closure(n), force(n), displacement(n);
    unsigned state = 1;
    for (int step = 0; step < 60; ++step) {
      const auto next = [&] {
        return static_cast<double>((state = state * 1664525U + 1013904223U) >> 8U) / (1U << 24U);
      };
      const double depth = 0.1 * next();
      for (std::size_t i = 0; i < n; ++i) q[i] = depth - of.grid.recess[i] * next() - 0.02 * (next() < 0.2 ? 1.0 : 0.0);
      q[0] = depth;
      ASSERT_TRUE(nodes.solve(of.law, q, closure, force, displacement)) << length << " " << step;
      EXPECT_LT(from_scratch(of, q, force), 1e-10) << length << " " << step;
    }
  }
}

TEST(KeptFactor, SolvesWithTheDiagonalThatWasGiven) {
  const RoughProblem of = rough_problem(sphere({.poisson = 0.3}), 1e-3, 0.05, 24);
  KeptFactor factor(of.compliance);
  const auto w = of.compliance->matrix();
  constexpr std::size_t kept = 11, end = 15;
  for (std::size_t i = 0; i < kept + 3; ++i) ASSERT_TRUE(factor.add(0.1 * static_cast<double>(i + 1)));
  factor.give_up(kept - 4);
  for (std::size_t i = kept - 4; i < kept; ++i) ASSERT_TRUE(factor.add(0.1 * static_cast<double>(i + 1)));
  std::vector<double> left, x(24, 0.0), y(24), right(24);
  factor.remainder(end, left);
  // (W + D) x = b on the kept nodes and, by what is left of W, rigid on those behind.
  std::vector<double> wanted(24, 0.0);
  for (std::size_t i = 0; i < end; ++i) wanted[i] = std::cos(static_cast<double>(i));
  for (std::size_t i = 0; i < end; ++i) {
    for (std::size_t j = 0; j < end; ++j) {
      right[i] += w(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) * wanted[j];
    }
    if (i < kept) right[i] += 0.1 * static_cast<double>(i + 1) * wanted[i];
  }
  factor.forward(end, right, y);
  for (std::size_t a = 0; a < end - kept; ++a) {
    double sum = 0.0;
    for (std::size_t b = 0; b < end - kept; ++b) {
      sum += left[std::max(a, b) * (end - kept) + std::min(a, b)] * wanted[kept + b];
    }
    EXPECT_NEAR(y[kept + a], sum, 1e-11 * std::abs(sum));
    x[kept + a] = wanted[kept + a];
  }
  factor.backward(end, y, x);
  for (std::size_t i = 0; i < end; ++i) EXPECT_NEAR(x[i], wanted[i], 1e-11) << i;
}

}  // namespace
}  // namespace stoss
