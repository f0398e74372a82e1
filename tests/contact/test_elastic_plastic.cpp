// The law of a contact that yields: its curves, its works, and the finite elements that it is fitted to.
#include "stoss/contact/elastic_plastic.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "stoss/errors.hpp"
#include "support/csv.hpp"

namespace stoss {
namespace {

TEST(ElasticPlastic, LoadsContinuouslyAndReturnsToLessThanItWent) {
  EXPECT_NEAR(loading_force(1.0 + 1e-9), 1.0, 1e-8);
  EXPECT_NEAR(loading_stiffness(1.0 + 1e-9), 1.5, 1e-2);
  EXPECT_NEAR(loading_work(1.0), 0.4, 1e-15);
  double last = 1.0;
  for (const double depth : {1.2, 2.0, 5.0, 20.0, 100.0, 300.0, 1e4}) {
    const double step = 1e-5 * depth;
    const double slope = (loading_force(depth + step) - loading_force(depth - step)) / (2.0 * step);
    EXPECT_NEAR(loading_stiffness(depth), slope, 1e-6 * slope) << depth;
    const double work = (loading_work(depth + step) - loading_work(depth - step)) / (2.0 * step);
    EXPECT_NEAR(loading_force(depth), work, 1e-6 * work) << depth;
    EXPECT_LT(loading_force(depth), depth * std::sqrt(depth)) << "stronger than elastic at " << depth;
    const Unloading back = unloading(depth);
    EXPECT_GT(back.residual, 0.0);
    EXPECT_LT(back.residual, depth);
    EXPECT_GT(back.radius_ratio, 1.0);
    const double share = unloading_work(depth) / loading_work(depth);
    EXPECT_LT(share, last) << depth;
    last = share;
  }
}

TEST(ElasticPlastic, HasTheNumbersOfTheFiniteElements) {
  // Of ν = 0.3, each with the error that the study states: residual depths, ε and the speed of its compression.
  std::size_t count = 0;
  for (const auto& row : test::read_csv("yield_restitution.csv")) {
    if (row.number("nu") != 0.3) continue;
    const double depth = row.number("d_max");
    const double ratio = std::sqrt(2.5 * loading_work(depth));
    EXPECT_NEAR(ratio, row.number("V_over_V_y"), 1e-3 * ratio);
    const double square = std::pow(plastic_restitution(ratio), 2);
    EXPECT_NEAR(square, row.number("W_unload_over_W_load"), row.number("W_ratio_error") + 2e-3 * square) << depth;
    EXPECT_NEAR(loading_force(depth), row.number("f_max"), 0.01 * row.number("f_max")) << depth;
    EXPECT_NEAR(unloading(depth).residual, row.number("d_r"), row.number("d_r_error") + 1e-2 * depth) << depth;
    ++count;
  }
  EXPECT_GE(count, 14U);
}

TEST(ElasticPlastic, KnowsTheDepthOfAWork) {
  for (const double depth : {1e-8, 0.5, 1.0, 1.0001, 3.0, 77.0, 1600.0, 9e5}) {
    EXPECT_NEAR(depth_of_work(loading_work(depth)), depth, 1e-12 * depth);
  }
}

TEST(ElasticPlastic, RefusesWhatIsNoNumber) {
  EXPECT_THROW((void)loading_force(-1.0), InvalidInput);
  EXPECT_THROW((void)unloading(std::nan("")), InvalidInput);
  EXPECT_THROW((void)depth_of_work(1e300), InvalidInput);
  EXPECT_THROW((void)plastic_restitution(1e6), InvalidInput);
}

}  // namespace
}  // namespace stoss
