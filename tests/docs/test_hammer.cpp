// A body of one's own as docs/architecture.md says, against exact answers.
#include <gtest/gtest.h>

#include <cmath>

#include "stoss/bodies/hammer.hpp"
#include "stoss/restitution.hpp"

namespace stoss {
namespace {

TEST(Hammer, MeetsTheWallAsTheMethodOfCharacteristicsSays) {
  for (const double ratio : {0.1, 0.5, 0.8}) {
    const Impact found = impact(contact(hammer(ratio, 1600.0)), 0.1);
    const double logarithm = std::log(4.0);
    EXPECT_NEAR(found.contact_time, 2.0 + ratio * logarithm, 2e-3) << ratio;
    EXPECT_NEAR(found.restitution, (2.0 + (3.0 - logarithm) * ratio) / (1.0 + ratio) - 1.0, 1e-3) << ratio;
  }
}

// Σ over all modes of C²/(mω²) and of C²/(mω⁴).
TEST(Hammer, HasTheComplianceOfTheModesThatAreNotKept) {
  constexpr double ratio = 0.5, low = 10.0;
  const Body few = hammer(ratio, low), many = hammer(ratio, 2e4);
  double compliance = many.residual_compliance({}, {}).front(), moment = many.residual_second_moment({}, {}).front();
  for (std::size_t l = mode_count(few); l < mode_count(many); ++l) {
    const double omega = many.groups[0].omega[l], amplitude = many.groups[0].upper[l];
    compliance += amplitude * amplitude / (many.mass * omega * omega);
    moment += amplitude * amplitude / (many.mass * std::pow(omega, 4));
  }
  EXPECT_NEAR(few.residual_compliance({}, {}).front(), compliance, 1e-12);
  EXPECT_NEAR(few.residual_second_moment({}, {}).front(), moment, 1e-12);
  EXPECT_GT(many.residual_compliance({}, {}).front(), 0.0);
}

TEST(Hammer, MeetsItsEqualAsAWallAtHalfTheSpeed) {
  const Impact wall = impact(contact(hammer(0.5, 100.0)), 0.1);
  const Impact pair = impact(contact(hammer(0.5, 100.0), hammer(0.5, 100.0)), 0.2);
  EXPECT_NEAR(pair.restitution, wall.restitution, 1e-12);
}

}  // namespace
}  // namespace stoss
