// How an estimate is written whose error is not known.
#include "output/estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace stoss::cli {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(Estimate, UnknownErrorIsAWord) {
  EXPECT_EQ(std::get<std::string>(error_of(3.35, infinite)), "unknown");
  EXPECT_EQ(std::get<std::string>(error_of(3.35, none)), "unknown");
  EXPECT_EQ(std::get<double>(error_of(3.35, 0.5)), 0.5);
  EXPECT_TRUE(std::isnan(std::get<double>(error_of(none, none))));
  EXPECT_EQ(with_error(3.35, infinite), "3.35 ± unknown");
  EXPECT_EQ(with_error(3.35, 0.5), "3.35 ± 0.50");
}

TEST(Estimate, ErrorHasTwoDigits) {
  EXPECT_EQ(with_error(0.94706, 0.000038), "0.947060 ± 0.000038");
  EXPECT_EQ(with_error(0.94706123, 1.2e-7), "0.94706123(12)");
  EXPECT_EQ(with_error(0.94706123, 1.2e-14), "0.947061230000(0)");
  EXPECT_EQ(with_error(1.4153e-9, 1.2e-11), "0.000000001415(12)");
  EXPECT_EQ(with_error(3.497938e-19, 1.37e-23), "3.49794(14)e-19");
  EXPECT_EQ(with_error(-3.497938e-19, 1.37e-20), "-3.50(14)e-19");
  EXPECT_EQ(with_error(9.9999e-20, 1.37e-22), "1.0000(14)e-19");
  EXPECT_EQ(with_error(9.9e-20, 9.6e-20), "9.9(96)e-20");
  EXPECT_EQ(with_error(3.4e-280, 1e-281), "3.40(10)e-280");
}

}  // namespace
}  // namespace stoss::cli
