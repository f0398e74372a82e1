// Are the errors of restitution() honest? A sample of what the validation program judges (docs/validation.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/csv.hpp"

namespace stoss {
namespace {

std::vector<test::CsvRow> sample() {
  std::vector<test::CsvRow> rows = test::read_csv("restitution_fine.csv");
  for (test::CsvRow& row : test::read_csv("restitution_hard_wall.csv")) rows.push_back(std::move(row));
  return rows;
}

class ValidationSample : public ::testing::TestWithParam<double> {};

TEST_P(ValidationSample, HasHonestErrors) {
  const double tolerance = GetParam();
  std::map<double, RefinableContact> disks;
  std::vector<double> padding;  // estimated over true error
  int points = 0, within = 0;
  for (const auto& row : sample()) {
    const double poisson = row.number("poisson"), speed = row.number("speed");
    SCOPED_TRACE(::testing::Message() << "poisson " << poisson << ", speed " << speed);
    const RefinableContact& body = disks.try_emplace(poisson, disk(poisson)).first->second;
    const Restitution result = restitution(body, speed, {.tolerance = tolerance});
    const auto [value, error] = result.lost_fraction;
    EXPECT_TRUE(result.converged);
    EXPECT_GT(error, 0.0);
    EXPECT_LE(error, tolerance * value);

    const double uncertainty = row.number("uncertainty");
    const double difference = std::abs(value - row.number("lost_fraction"));
    EXPECT_LE(difference, 3.0 * error + uncertainty);
    ++points;
    if (difference <= error + uncertainty) ++within;
    // Elsewhere the difference is the reference's error as much as that of the value.
    if (uncertainty <= 0.1 * error) padding.push_back(error / difference);
  }
  EXPECT_GE(within, 0.9 * points);
  ASSERT_GE(padding.size(), 10U);
  std::nth_element(padding.begin(), padding.begin() + static_cast<std::ptrdiff_t>(padding.size() / 2), padding.end());
  EXPECT_LE(padding[padding.size() / 2], 10.0);
}

INSTANTIATE_TEST_SUITE_P(Tolerances, ValidationSample, ::testing::Values(1e-2, 1e-3));

}  // namespace
}  // namespace stoss
