// Coulomb's law at the nodes of a step: against enumeration of all states, and by its conditions.
#include "contact/friction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include "support/contact_problem.hpp"

namespace stoss {
namespace {

using test::gauss;
using test::random_compliance;
using test::Vector;

struct Problem {
  Vector compliance, give, free, limit, before;

  [[nodiscard]] std::size_t size() const { return limit.size(); }

  [[nodiscard]] Vector solved(Friction& friction) const {
    Vector force = before;
    friction.solve(compliance, give, free, limit.data(), force);
    return force;
  }
};

Problem random_problem(std::size_t size, double decades, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Problem problem;
  problem.compliance = random_compliance(size, decades, random);
  for (std::size_t i = 0; i < size; ++i) {
    problem.free.push_back(2.0 * normal(random));
    problem.give.push_back(i % 2 == 0 ? 0.0 : std::abs(normal(random)));
    problem.limit.push_back(i % 5 == 4 ? 0.0 : std::abs(normal(random)));
    problem.before.push_back(i % 5 == 4 ? 0.0 : normal(random));
  }
  return problem;
}

Vector slips(const Problem& problem, const Vector& force) {
  Vector slip(problem.size());
  for (std::size_t i = 0; i < problem.size(); ++i) {
    long double sum = problem.free[i] - static_cast<long double>(problem.give[i]) * (force[i] - problem.before[i]);
    for (std::size_t j = 0; j < problem.size(); ++j) {
      sum -= static_cast<long double>(problem.compliance[i * problem.size() + j]) * force[j];
    }
    slip[i] = static_cast<double>(sum);
  }
  return slip;
}

/// By trying all states −1, 0, 1 of the nodes.
Vector by_enumeration_of_states(const Problem& problem) {
  const std::size_t size = problem.size();
  std::size_t states = 1;
  for (std::size_t i = 0; i < size; ++i) states *= 3;
  Vector best;
  double least = std::numeric_limits<double>::max();
  for (std::size_t code = 0; code < states; ++code) {
    std::vector<std::size_t> stuck;
    Vector force(size);
    for (std::size_t i = 0, rest = code; i < size; ++i, rest /= 3) {
      force[i] = (static_cast<double>(rest % 3) - 1.0) * problem.limit[i];
      if (rest % 3 == 1) stuck.push_back(i);
    }
    std::vector<long double> block, right;
    for (const std::size_t i : stuck) {
      long double sum = problem.free[i] + static_cast<long double>(problem.give[i]) * problem.before[i];
      for (std::size_t j = 0; j < size; ++j) sum -= problem.compliance[i * size + j] * force[j];
      right.push_back(sum);
      for (const std::size_t j : stuck) {
        block.push_back(problem.compliance[i * size + j] + (i == j ? problem.give[i] : 0.0));
      }
    }
    const auto held = gauss(block, right);
    for (std::size_t k = 0; k < stuck.size(); ++k) force[stuck[k]] = static_cast<double>(held[k]);
    const Vector slip = slips(problem, force);
    double violation = 0.0;
    for (std::size_t i = 0, rest = code; i < size; ++i, rest /= 3) {
      if (problem.limit[i] == 0.0) {
        if (rest % 3 != 0) violation = std::numeric_limits<double>::infinity();  // one code is enough
      } else if (rest % 3 == 1) {
        violation = std::max(violation, std::abs(force[i]) - problem.limit[i]);
      } else {
        violation = std::max(violation, -slip[i] * (static_cast<double>(rest % 3) - 1.0));
      }
    }
    if (violation < least) {
      least = violation;
      best = force;
    }
  }
  return best;
}

TEST(Friction, IsThatOfTheOneConsistentSetOfStates) {
  std::mt19937 random(5);
  for (int round = 0; round < 60; ++round) {
    const Problem problem = random_problem(1 + static_cast<std::size_t>(round % 6), 1.0, random);
    const Vector expected = by_enumeration_of_states(problem);
    Friction friction(problem.size());
    const Vector force = problem.solved(friction);
    for (std::size_t i = 0; i < problem.size(); ++i) EXPECT_NEAR(force[i], expected[i], 1e-11) << round << ' ' << i;
  }
}

TEST(Friction, ObeysCoulombsLawAtManyNodesFromAnyStatesBefore) {
  std::mt19937 random(6);
  Friction friction(48);
  for (int round = 0; round < 40; ++round) {
    const Problem problem = random_problem(48, round % 3, random);
    const Vector force = problem.solved(friction);
    const Vector slip = slips(problem, force);
    double scale = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i) scale = std::max(scale, std::abs(problem.free[i]));
    for (std::size_t i = 0; i < force.size(); ++i) {
      EXPECT_LE(std::abs(force[i]), problem.limit[i] * (1.0 + 1e-11));
      const int state = friction.sliding()[i];
      if (problem.limit[i] == 0.0) {
        EXPECT_EQ(force[i], 0.0);
      } else if (state == 0) {
        EXPECT_NEAR(slip[i], 0.0, 1e-10 * scale);
      } else {
        EXPECT_EQ(force[i], state * problem.limit[i]);
        EXPECT_GE(state * slip[i], -1e-10 * scale);
      }
    }
  }
}

TEST(Friction, TurnsRoundWithTheSlips) {
  std::mt19937 random(7);
  Problem problem = random_problem(24, 1.0, random);
  Friction friction(24), turned(24);
  const Vector force = problem.solved(friction);
  for (double& each : problem.free) each = -each;
  for (double& each : problem.before) each = -each;
  const Vector other = problem.solved(turned);
  for (std::size_t i = 0; i < force.size(); ++i) EXPECT_EQ(force[i], -other[i]);
}

TEST(Friction, OfALandingNodeUnderALoadOfFixedDirectionIsProportionalToItsPressure) {
  // A step of compression, W (f − f₋) − g + g₋ = x, and a step along the surface of λ x: W_t = ratio · W answers with
  // λ f/ratio at every node, landed or landing.
  const Vector normal{2.0, 0.7, 0.3, 0.7, 1.5, 0.5, 0.3, 0.5, 1.0};
  const Vector before{1.0, 0.2, 0.0}, force{1.4, 0.5, 0.05}, gap_before{0.0, 0.05, 0.4}, gap{0.0, 0.02, 0.3};
  constexpr double ratio = 1.3, direction = 0.2;
  Problem problem;
  for (const double each : normal) problem.compliance.push_back(ratio * each);
  for (std::size_t i = 0; i < 3; ++i) {
    double moved = gap_before[i] - gap[i];
    for (std::size_t j = 0; j < 3; ++j) moved += normal[3 * i + j] * (force[j] - before[j]);
    double held = 0.0;
    for (std::size_t j = 0; j < 3; ++j) held += problem.compliance[3 * i + j] * direction / ratio * before[j];
    problem.free.push_back(direction * moved + held);
    problem.give.push_back(edge_compliance_along(ratio, gap[i], gap_before[i], force[i], before[i]));
    problem.limit.push_back(force[i]);
    problem.before.push_back(direction / ratio * before[i]);
  }
  Friction friction(3);
  const Vector along = problem.solved(friction);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(along[i], direction / ratio * force[i], 1e-15);
}

TEST(Friction, GivesNothingAtRigidAndAtOpenNodes) {
  EXPECT_EQ(edge_compliance_along(1.3, 0.0, 0.0, 2.0, 1.0), 0.0);
  EXPECT_EQ(edge_compliance_along(1.3, 0.2, 0.3, 0.0, 0.0), 0.0);
  EXPECT_EQ(edge_compliance_along(1.3, 0.2, 0.3, 1.0, 1.0), 0.0);
  EXPECT_EQ(edge_compliance_along(1.3, 0.2, 0.1, 2.0, 1.0), 0.0);
}

}  // namespace
}  // namespace stoss
