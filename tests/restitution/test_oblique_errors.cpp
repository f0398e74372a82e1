// What is said of an oblique impact that has not converged.
#include "restitution/oblique_errors.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace stoss {
namespace {

TEST(ObliqueErrors, AToleranceThatHelpsIsSaidOnlyWhereThereIsOne) {
  EXPECT_EQ(way_out("use a larger tolerance", 0.0205), " (use a larger tolerance, from 0.021)");
  EXPECT_EQ(way_out("use a larger tolerance", 0.5), " (use a larger tolerance, from 0.5)");
  for (const double error : {0.501, 12.0, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(way_out("use a larger tolerance", error), " (no tolerance up to 0.5 is reached)");
  }
}

/// Three runs of a body at slip, with an error of s′ far above it.
TEST(ObliqueErrors, NoToleranceHelpsWhereTheErrorIsLargerThanTheSlip) {
  ObliqueRestitution result;
  result.speed = 0.01;
  result.before.friction = 0.1;
  result.sliding = 1e-3;
  result.runs.resize(3);
  result.sliding_after.error = 12e-3;
  mark_unconverged({}, result);
  EXPECT_NE(result.reason.find("asks for a higher cutoff"), std::string::npos) << result.reason;
  EXPECT_EQ(result.reason.find("from"), std::string::npos) << result.reason;
  EXPECT_NE(result.reason.find("no tolerance up to 0.5"), std::string::npos) << result.reason;
}

}  // namespace
}  // namespace stoss
