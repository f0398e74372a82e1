// The cosine integral against values of mpmath.
#include <gtest/gtest.h>

#include <cmath>

#include "numeric/cosine_integral.hpp"

namespace stoss::numeric {
namespace {

TEST(CosineIntegral, HasItsValues) {
  EXPECT_NEAR(cosine_integral(1e-6), -13.238294893062991, 1e-14);
  EXPECT_NEAR(cosine_integral(0.5), -0.1777840788066129, 1e-14);
  EXPECT_NEAR(cosine_integral(2.9), 0.15289532415958834, 1e-14);
  EXPECT_NEAR(cosine_integral(3.0), 0.11962978600800033, 1e-14);
  EXPECT_NEAR(cosine_integral(3.1), 0.08699183119553696, 1e-14);
  EXPECT_NEAR(cosine_integral(6.25), -0.027855291197105028, 1e-14);
  EXPECT_NEAR(cosine_integral(8.0), 0.12243388253200956, 1e-14);
  EXPECT_NEAR(cosine_integral(19.0), 0.0051503710084261286, 1e-14);
  EXPECT_NEAR(cosine_integral(50.0), -0.0056283863241163054, 1e-14);
  EXPECT_NEAR(cosine_integral(2000.0), 0.00046511138444836849, 1e-14);
}

}  // namespace
}  // namespace stoss::numeric
