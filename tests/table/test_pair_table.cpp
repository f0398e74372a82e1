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

TEST(PairTable, MeetsItsNodes) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(0.3, 1.0);
  const TableValues given = values(uneven().speeds, uneven().ratios, [&](double, double) { return uniform(random); });
  const PairTable table(given);
  ASSERT_EQ(table.nodes().size(), 4 * 36U);
  for (std::size_t k = 0; k < 6; ++k) {
    for (std::size_t j = 0; j < 6; ++j) {
      EXPECT_NEAR(table.value(given.speeds[k], given.ratios[j]), given.values[6 * k + j].value, 1e-13);
      EXPECT_EQ(table.nodes()[4 * (6 * k + j)], given.values[6 * k + j].value);
    }
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

TEST(PairTable, OfBodiesThatAreAlikeIsSymmetric) {
  TableValues given = values({0.01, 0.02, 0.1}, {1.0, 1.5, 3.0}, smooth);
  given.alike = true;
  const PairTable table(given);
  for (const double r : {1.0, 1.1, 1.7, 2.2, 3.0}) {
    EXPECT_NEAR(table.value(0.03, r), table.value(0.03, 1.0 / r), 1e-15);
    EXPECT_NEAR(table.value(0.03, r), smooth(0.03, r), 1e-13);
  }
  const double step = 1e-4;  // no kink at 1
  EXPECT_NEAR(table.value(0.03, 1.0 + step), table.value(0.03, 1.0), step * step);
}

TEST(PairTable, RefusesWhatIsBeyondItsRangeOrClampsIt) {
  const PairTable strict(uneven());
  test::expect_refusal([&] { (void)strict(0.009, 1.0); }, {"speed", "0.009", "0.01", "0.2"});
  test::expect_refusal([&] { (void)strict.value(0.21, 1.0); }, {"speed", "0.21"});
  test::expect_refusal([&] { (void)strict.value(0.1, 0.4); }, {"ratio", "0.4", "0.5", "7"});
  test::expect_refusal([&] { (void)strict(0.1, 8.0); }, {"ratio", "8"});
  const PairTable clamped(uneven(), Beyond::clamp);
  EXPECT_DOUBLE_EQ(clamped.value(1e-3, 2.0), clamped.value(0.01, 2.0));
  EXPECT_DOUBLE_EQ(clamped.value(0.1, 9.0), clamped.value(0.1, 7.0));
  EXPECT_DOUBLE_EQ(clamped.value(3.0, 0.1), clamped.value(0.2, 0.5));
  for (const double nothing : {0.0, -0.0}) {  // lies below every range
    EXPECT_EQ(clamped(nothing, 2.0).value, clamped.value(1e-3, 2.0));
    EXPECT_EQ(clamped(nothing, 2.0).error, std::numeric_limits<double>::infinity());
    test::expect_refusal([&] { (void)strict(nothing, 2.0); }, {"speed: got 0", "0.01 to 0.2"});
  }
  EXPECT_EQ(clamped(1e-3, 2.0).error, std::numeric_limits<double>::infinity());
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity}) {
    test::expect_refusal([&] { (void)clamped(bad, 1.0); }, {"speed"});
    test::expect_refusal([&] { (void)clamped.value(0.1, bad); }, {"ratio"});
  }
  test::expect_refusal([&] { (void)clamped(0.1, 0.0); }, {"ratio"});
  test::expect_refusal([&] { (void)clamped(0.1, -1.0); }, {"ratio", "-1"});
}

TEST(PairTable, RefusesValuesOfNoTable) {
  TableValues given = uneven();
  given.speeds[1] = 0.01;
  test::expect_refusal([&] { (void)PairTable(given); }, {"speeds", "0.01"});
  given = uneven();
  given.ratios[0] = -0.5;
  test::expect_refusal([&] { (void)PairTable(given); }, {"ratios", "-0.5"});
  given = uneven();
  given.alike = true;
  test::expect_refusal([&] { (void)PairTable(given); }, {"ratios", "0.5"});
  given = uneven();
  given.values.pop_back();
  test::expect_refusal([&] { (void)PairTable(given); }, {"restitution", "35", "36"});
  given = uneven();
  given.values[7].error = std::numeric_limits<double>::infinity();
  test::expect_refusal([&] { (void)PairTable(given); }, {"restitution", "inf"});
  given = uneven();
  given.interpolation_error[3] = -1.0;
  test::expect_refusal([&] { (void)PairTable(given); }, {"interpolation_error"});
  test::expect_refusal([] { (void)PairTable({}); }, {"speeds", "0"});
  test::expect_refusal([] { (void)PairTable(uneven(), Beyond::law); }, {"beyond", "law"});
}

}  // namespace
}  // namespace stoss
