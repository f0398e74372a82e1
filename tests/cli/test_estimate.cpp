// How an estimate is written whose error is not known.
#include "estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace stoss::cli {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(Estimate, UnknownErrorIsAWord) {
  EXPECT_EQ(std::get<std::string>(error_of({3.35, infinite})), "unknown");
  EXPECT_EQ(std::get<std::string>(error_of({3.35, none})), "unknown");
  EXPECT_EQ(std::get<double>(error_of({3.35, 0.5})), 0.5);
  EXPECT_TRUE(std::isnan(std::get<double>(error_of({none, none}))));
  EXPECT_EQ(with_error(3.35, infinite), "3.35 ± unknown");
  EXPECT_EQ(with_error(3.35, 0.5), "3.35 ± 0.50");
}

TEST(Estimate, RecordHasTheWordInPlaceOfTheErrorAndTheTableInPlaceOfTheValue) {
  Record record;
  add_estimate(record, "contact_time", "R/c", {3.35, infinite}, 13);
  add_estimate(record, "contact_time", "R/c", {3.35, 0.1}, 13);
  ASSERT_EQ(record.size(), 4U);
  EXPECT_EQ(std::get<double>(record[0].value), 3.35);
  EXPECT_EQ(record[0].shown, "unknown");
  EXPECT_EQ(record[1].key, "contact_time_error");
  EXPECT_EQ(std::get<std::string>(record[1].value), "unknown");
  EXPECT_EQ(record[2].shown, "");
  EXPECT_EQ(std::get<double>(record[3].value), 0.1);
}

}  // namespace
}  // namespace stoss::cli
