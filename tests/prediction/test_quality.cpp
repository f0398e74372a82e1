// Materials of one quality at all frequencies lose what springs with their memory do.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "quasistatic/lossy_motion.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/prediction/prediction.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

TEST(PredictedQuality, QualityOfNamedMaterialsIsThatOfEachContact) {
  // 2.407/Q at every speed and 3 % of it beyond the slow limit at the faster (docs/theory/loss.md), where 3.54/Q was
  // said.
  const Encounter glass = encounter_from_json(R"({"first": {"kind": "sphere", "radius": 0.005, "material": "glass"}})");
  for (const Prediction& made : predict(glass, {1e-3, 0.01, 1.0}, {.work_of_adhesion = 0.0})) {
    EXPECT_NEAR(made.share(Channel::material), 2.407e-3, 0.03 * 2.407e-3) << made.speed;
  }
  // Q = 10: (1 − ε²)Q = 2.1747 in the slow limit, to which a loss time that loses as much leads at finite loss too.
  const Encounter rubber =
      encounter_from_json(R"({"first": {"kind": "sphere", "radius": 0.005, "material": "rubber"}})");
  const Prediction slow = predict(rubber, {1e-4}, {.work_of_adhesion = 0.0, .influences = false}).front();
  EXPECT_NEAR(1.0 - std::pow(slow.restitution.value, 2), 0.21747, 0.01 * 0.21747);
}

TEST(PredictedQuality, LossTimesStayThoseOfKelvinAndVoigt) {
  const std::string text =
      R"({"first": {"kind": "sphere", "radius": 0.005, "loss_time": 1.6e-8, "material": "glass"}})";
  const Prediction made =
      predict(encounter_from_json(text), {0.1}, {.work_of_adhesion = 0.0, .influences = false}).front();
  const Restitution same =
      restitution(refinable(encounter_from_json(text)), speed_in_c(encounter_from_json(text), 0.1), {.absolute = 1e-5});
  EXPECT_EQ(made.without_models.value, same.restitution.value);
}

TEST(PredictedQuality, LossOfAQualityIsThatOfSpringsWithMemory) {
  // studies/loss/constant_quality.py: springs with Maxwell branches, and Ting's integrals without them.
  for (const auto& [quality, product] : std::vector<std::pair<double, double>>{{300.0, 2.40140},
                                                                               {100.0, 2.38534},
                                                                               {30.0, 2.32960},
                                                                               {10.0, 2.17471},
                                                                               {3.0, 1.69829},
                                                                               {1.0, 0.90735},
                                                                               {0.5, 0.49069}}) {
    EXPECT_NEAR(quasistatic::loss_of_quality(quality) * quality, product, 1e-4 * product) << quality;
    const double number = quasistatic::loss_number_of_quality(quality);
    const double restitution = lossy_motion(quasistatic::LossyLaw::ting, number).restitution;
    EXPECT_NEAR((1.0 - restitution * restitution) * quality, product, 1e-4 * product) << quality;
  }
  EXPECT_NEAR(quasistatic::loss_of_quality(1e9) * 1e9, 2.4094, 2e-4);
  EXPECT_NEAR(quasistatic::loss_number_of_quality(1e12) * 1e12, 2.40947 / 2.306898, 1e-4);
  test::expect_refusal([] { (void)quasistatic::loss_of_quality(0.4); }, {"quality: got 0.4"});
}

}  // namespace
}  // namespace stoss
