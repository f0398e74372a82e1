// The contact problem f ≥ 0, g = W f − q ≥ 0, fᵀg = 0: against enumeration of all contact sets, and by its conditions.
#include "support/complementarity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include "stoss/errors.hpp"
#include "support/contact_problem.hpp"

namespace stoss {
namespace {

using test::by_enumeration;
using test::random_compliance;
using test::Vector;

double largest(const Vector& v) {
  double result = 0.0;
  for (const double x : v) result = std::max(result, std::abs(x));
  return result;
}

void expect_conditions(const Vector& w, const Vector& q, const Vector& force, const Vector& displacement,
                       std::size_t extent) {
  const std::size_t size = q.size();
  const double deepest = std::max(0.0, *std::max_element(q.begin(), q.end()));
  for (std::size_t i = 0; i < size; ++i) {
    long double sum = 0.0L;
    long double magnitude = 0.0L;
    for (std::size_t j = 0; j < size; ++j) {
      sum += static_cast<long double>(w[i * size + j]) * force[j];
      magnitude += std::abs(static_cast<long double>(w[i * size + j]) * force[j]);
    }
    const double rounding = 1e-13 * deepest + 1e-14 * static_cast<double>(magnitude);
    ASSERT_GE(force[i], 0.0);
    ASSERT_NEAR(displacement[i], static_cast<double>(sum), rounding);
    ASSERT_GE(static_cast<double>(sum) - q[i], -rounding);
    if (force[i] > 0.0) {
      ASSERT_NEAR(static_cast<double>(sum), q[i], rounding);
    }
    if (i >= extent) {
      ASSERT_EQ(force[i], 0.0);
    }
  }
}

/// Contact on the nodes that `inside` picks: q = W f − (gap elsewhere).
template <typename Inside>
Vector position_with_contact(const Vector& w, std::size_t size, std::mt19937& random, Inside inside) {
  std::uniform_real_distribution<double> uniform(0.1, 1.0);
  Vector force(size, 0.0), q(size, 0.0);
  for (std::size_t i = 0; i < size; ++i) force[i] = inside(i) ? uniform(random) : 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) q[i] += w[i * size + j] * force[j];
    if (!inside(i)) q[i] -= 0.1 * uniform(random);
  }
  return q;
}

class ComplementarityOf : public ::testing::TestWithParam<unsigned> {
 protected:
  std::mt19937 random{GetParam()};
};

TEST_P(ComplementarityOf, SmallProblemsIsThatOfEnumeration) {
  std::normal_distribution<double> normal;
  for (std::size_t size = 1; size <= 9; ++size) {
    const Vector w = random_compliance(size, 1.0, random);
    Complementarity problem(w, size);
    Vector force(size), displacement(size), q(size);
    for (int repeat = 0; repeat < 4; ++repeat) {
      for (double& value : q) value = normal(random);
      problem.solve(q, force, displacement);
      const Vector expected = by_enumeration(w, q);
      for (std::size_t i = 0; i < size; ++i) {
        ASSERT_NEAR(force[i], expected[i], 1e-9 * (1.0 + largest(expected))) << "size " << size << ", node " << i;
      }
    }
  }
}

TEST_P(ComplementarityOf, RandomProblemsMeetsItsConditions) {
  std::normal_distribution<double> normal;
  for (std::size_t size = 1; size <= 40; ++size) {
    for (const double decades : {0.0, 1.5, 3.0}) {
      const Vector w = random_compliance(size, decades, random);
      Complementarity problem(w, size);
      Vector force(size), displacement(size), q(size);
      for (int repeat = 0; repeat < 3; ++repeat) {
        for (double& value : q) value = normal(random);
        problem.solve(q, force, displacement);
        ASSERT_NO_FATAL_FAILURE(expect_conditions(w, q, force, displacement, problem.extent()))
            << "size " << size << ", decades " << decades;
      }
    }
  }
}

TEST_P(ComplementarityOf, IntervalsAndOtherSetsFindsTheSet) {
  for (const std::size_t size : {5U, 16U, 40U}) {
    const Vector w = random_compliance(size, 0.5, random);
    Complementarity problem(w, size);
    Vector force(size), displacement(size);
    const auto check = [&](auto inside) {
      const Vector q = position_with_contact(w, size, random, inside);
      problem.solve(q, force, displacement);
      for (std::size_t i = 0; i < size; ++i) EXPECT_EQ(force[i] > 0.0, inside(i)) << "size " << size << ", node " << i;
      expect_conditions(w, q, force, displacement, problem.extent());
    };
    // The last set is where the next search starts, so the order of these matters: growing, shrinking, leaping.
    for (const std::size_t count : {1U, 2U, 3U, 5U, 4U, 1U, 5U}) check([=](std::size_t i) { return i < count; });
    check([=](std::size_t i) { return i >= size / 2; });
    check([](std::size_t i) { return i % 2 == 0; });
    check([](std::size_t i) { return i % 3 == 1; });
    check([=](std::size_t i) { return i + 1 == size; });
    check([](std::size_t) { return true; });
  }
}

TEST_P(ComplementarityOf, AnyPositionDoesNotDependOnWhatCameBefore) {
  std::normal_distribution<double> normal;
  const std::size_t size = 24;
  const Vector w = random_compliance(size, 1.0, random);
  Vector q(size), other(size), fresh(size), used(size), displacement(size);
  for (double& value : q) value = normal(random);
  for (double& value : other) value = normal(random);
  Complementarity first(w, size), second(w, size);
  first.solve(q, fresh, displacement);
  second.solve(other, used, displacement);
  second.solve(q, used, displacement);
  for (std::size_t i = 0; i < size; ++i) EXPECT_NEAR(used[i], fresh[i], 1e-10 * largest(fresh));
}

INSTANTIATE_TEST_SUITE_P(Seeds, ComplementarityOf, ::testing::Values(1U, 2U, 3U, 2026U));

TEST(Complementarity, IsZeroWhereNothingTouches) {
  Complementarity problem({2.0, 1.0, 1.0, 2.0}, 2);
  Vector force{7.0, 7.0}, displacement{7.0, 7.0};
  for (const Vector& q : {Vector{-1.0, -2.0}, Vector{0.0, 0.0}, Vector{0.0, -1e-300}}) {
    problem.solve(q, force, displacement);
    EXPECT_EQ(force, (Vector{0.0, 0.0}));
    EXPECT_EQ(displacement, (Vector{0.0, 0.0}));
    EXPECT_EQ(problem.extent(), 0U);
  }
}

TEST(Complementarity, RefusesAMatrixThatIsNotPositiveDefinite) {
  EXPECT_THROW(Complementarity({1.0, 2.0, 2.0, 1.0}, 2), NotConverged);
  EXPECT_THROW(Complementarity({-1.0}, 1), NotConverged);
  EXPECT_THROW(Complementarity({0.0}, 1), NotConverged);
  EXPECT_THROW(Complementarity({std::nan("")}, 1), NotConverged);
}

TEST(Complementarity, RefusesPositionsThatAreNotNumbers) {
  const double nan = std::nan("");
  for (const Vector& bad :
       {Vector{nan, nan}, Vector{nan, 1.0}, Vector{1.0, nan}, Vector{nan, -1.0}, Vector{-1.0, nan}}) {
    Complementarity problem({2.0, 1.0, 1.0, 2.0}, 2);
    Vector force(2), displacement(2);
    EXPECT_THROW(problem.solve(bad, force, displacement), NotConverged) << bad[0] << ", " << bad[1];
  }
}

}  // namespace
}  // namespace stoss
