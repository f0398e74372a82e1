// Tables of ε over speed and ratio of radii, of values that are given.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "stoss/table/pair_table.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

double relative(double ratio) { return (ratio - 1.0) / (ratio + 1.0); }

/// Values of a function on a grid, each with the error 1e-3.
template <typename Function>
TableValues values(std::vector<double> speeds, std::vector<double> ratios, Function function) {
  TableValues table;
  for (const double v : speeds) {
    for (const double r : ratios) table.values.push_back({function(v, r), 1e-3});
  }
  table.interpolation_error.assign((speeds.size() - 1) * (ratios.size() - 1), 2e-3);
  table.speeds = std::move(speeds);
  table.ratios = std::move(ratios);
  return table;
}

double smooth(double v, double r) { return 0.9 + 0.02 * std::log(v) - 0.3 * relative(r) * relative(r); }

TableValues uneven() { return values({0.01, 0.013, 0.02, 0.05, 0.06, 0.2}, {0.5, 0.6, 0.9, 1.3, 2.0, 7.0}, smooth); }

TEST(PairTable, IsExactForLinesInTheLogarithmAndParabolasBetweenRatios) {
  const PairTable table(uneven());
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const double v = 0.01 * std::pow(20.0, uniform(random)), r = 0.5 * std::pow(14.0, uniform(random));
    EXPECT_NEAR(table.value(v, r), smooth(v, r), 1e-13);
    EXPECT_EQ(table(v, r).value, table.value(v, r));
    EXPECT_EQ(table.value(-v, r), table.value(v, r));
    EXPECT_DOUBLE_EQ(table(v, r).error, 1.25e-3 + 2e-3);
  }
}

TEST(PairTable, IsSmoothAcrossItsCells) {
  const PairTable table(values(uneven().speeds, uneven().ratios,
                               [](double v, double r) { return 0.7 + 0.2 * std::sin(2.0 * std::log(v) + r); }));
  const double step = 1e-6;
  const auto jump = [step](double before, double here, double after) {
    return std::abs(after - 2.0 * here + before) / step;  // of the derivative
  };
  for (const double v : {0.013, 0.02, 0.05, 0.06}) {
    const double here = table.value(v, 1.1);
    EXPECT_LT(jump(table.value(v * (1.0 - step), 1.1), here, table.value(v * (1.0 + step), 1.1)), 1e-4);
  }
  for (const double r : {0.6, 0.9, 1.3, 2.0}) {
    const double here = table.value(0.03, r);
    EXPECT_LT(jump(table.value(0.03, r - step), here, table.value(0.03, r + step)), 1e-4);
  }
}

}  // namespace
}  // namespace stoss
