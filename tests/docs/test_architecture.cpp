// The examples of docs/architecture.md, which quotes their sources, against exact answers.
#include <gtest/gtest.h>

#include <cmath>

#include "stoss/bodies/anvil.hpp"
#include "stoss/bodies/hammer.hpp"
#include "stoss/bodies/rod.hpp"
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

TEST(Anvil, IsMetByARodAsTheMethodOfCharacteristicsSays) {
  for (const double mass : {0.2, 1.0, 5.0, 100.0}) {
    const Impact found = impact(contact(rod(Rod{}, 1600.0), anvil(mass, 1600.0)), 0.1);
    EXPECT_NEAR(found.restitution, (1.0 + mass) * (1.0 - std::exp(-2.0 / mass)) - 1.0, 1e-3) << mass;
    EXPECT_EQ(found.energy.lost_to_second, 0.0) << mass;
    EXPECT_NEAR(found.energy.lost_to_first, found.lost_fraction, 1e-3) << mass;
  }
}

TEST(Anvil, MayBeRefined) {
  const BodyMaker heavy = [](double cutoff, const Poll&) { return anvil(2.0, cutoff); };
  const Restitution found = restitution(RefinableContact(rod(), heavy), 0.1, {.tolerance = 0.1});
  EXPECT_NEAR(found.restitution.value, 3.0 * (1.0 - std::exp(-1.0)) - 1.0, found.restitution.error);
}

}  // namespace
}  // namespace stoss
