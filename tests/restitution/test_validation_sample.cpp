// Are the errors of restitution() honest? A sample of what the validation program judges
// (docs/developer/validation.md).
#include <gtest/gtest.h>

#include <map>
#include <utility>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/csv.hpp"
#include "support/judged.hpp"

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
  test::Judged judged;
  for (const auto& row : sample()) {
    const double poisson = row.number("poisson"), speed = row.number("speed");
    SCOPED_TRACE(::testing::Message() << "poisson " << poisson << ", speed " << speed);
    const RefinableContact& body = disks.try_emplace(poisson, disk(poisson)).first->second;
    const Restitution result = restitution(body, speed, {.tolerance = tolerance});
    const auto [value, error] = result.lost_fraction;
    EXPECT_TRUE(result.converged);
    EXPECT_GT(error, 0.0);
    EXPECT_LE(error, tolerance * value);

    judged.add(result.lost_fraction, row.number("lost_fraction"), row.number("uncertainty"), 3.0);
  }
  judged.expect_honest(0.9, 10);
}

INSTANTIATE_TEST_SUITE_P(Tolerances, ValidationSample, ::testing::Values(1e-2, 1e-3));

}  // namespace
}  // namespace stoss
