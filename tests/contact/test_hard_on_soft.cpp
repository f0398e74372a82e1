// A stiff body on a soft one, down to a millionth of its modulus: the rigid body is the limit, and is reached as the
// ratio of the moduli.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>

#include "stoss/encounter/document.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

/// @param met of which the modulus is that of the second over the first
Restitution of(const std::string& kind, const std::string& met, double ratio, bool rigid, double speed) {
  const std::string first = R"({"kind":")" + kind + R"(","poisson":0.3)" + (rigid ? R"(,"rigid":true})" : "}");
  const Encounter encounter = encounter_from_json(R"({"first":)" + first + R"(,"against":{)" + met + R"(,"young":)" +
                                                  std::to_string(ratio * 1e9) + R"(e-9}})");
  return restitution(refinable(encounter), speed * std::sqrt(ratio));
}

struct SoftBody {
  std::string first, met;
};

/// As the list of tests shows it.
std::ostream& operator<<(std::ostream& out, const SoftBody& its) {
  return out << its.first << " on {" << its.met << "}";
}

class HardOnSoft : public testing::TestWithParam<SoftBody> {};

TEST_P(HardOnSoft, IsRigidInTheLimit) {
  const auto& [first, met] = GetParam();
  const double rigid = of(first, met, 1e-3, true, 0.01).lost_fraction.value;
  double last = 0.0;
  for (const double ratio : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const double difference = of(first, met, ratio, false, 0.01).lost_fraction.value / rigid - 1.0;
    EXPECT_LT(std::abs(difference), 10.0 * ratio) << ratio;
    if (ratio < 1e-3 && ratio > 1e-6) {
      EXPECT_NEAR(difference / last, 0.1, 0.02) << ratio;
    }
    last = difference;
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, HardOnSoft,
                         testing::Values(SoftBody{"sphere", R"("kind":"sphere","poisson":0.45)"},
                                         SoftBody{"sphere", R"("kind":"half-space","poisson":0.49,"density":0.14)"},
                                         SoftBody{"sphere", R"("kind":"half-space","poisson":0.3,"quality":10)"},
                                         SoftBody{"sphere", R"("kind":"plate","thickness":1,"poisson":0.3)"},
                                         SoftBody{"disk", R"("kind":"disk","poisson":0.3)"},
                                         SoftBody{"disk", R"("kind":"half-plane","poisson":0.3)"}),
                         [](const auto& of) {
                           std::string name = of.param.first + "_" + std::to_string(of.index);
                           return name;
                         });

TEST(HardOnSoft, EndsWhereTheStifferOneIsRigid) {
  const std::string said =
      test::message_of<InvalidInput>([] { (void)of("sphere", R"("kind":"half-space")", 1e-7, false, 0.01); });
  EXPECT_EQ(said,
            "young ratio: got 1e-07, allowed 1e-6 to 1e6 (of the half-space to the body; beyond, the stiffer one is "
            "rigid: let the first be rigid)");
}

// The modulus of a rigid body cancels: none need be given.
TEST(HardOnSoft, AsksForNoModulusOfARigidBody) {
  const auto value = [](const std::string& material) {
    const Encounter encounter =
        encounter_from_json(R"({"first":{"kind":"sphere","radius":0.005,"rigid":true,"material":{)" + material +
                            R"("density":7800}},"against":{"kind":"half-space","material":"rubber"}})");
    return restitution(refinable(encounter), speed_in_c(encounter, 1.0)).lost_fraction.value;
  };
  EXPECT_NEAR(value(""), value(R"("young":2.1e11,"poisson":0.28,)"), 1e-9);
  EXPECT_EQ(test::message_of<InvalidInput>([] {
              (void)encounter_from_json(R"({"first":{"kind":"sphere","radius":1,"material":{"density":1}}})");
            }).substr(0, 14),
            "first material");
}

}  // namespace
}  // namespace stoss
