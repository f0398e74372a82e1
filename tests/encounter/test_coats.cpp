// Coats as they are given: alike in SI and in units of the body, on either face, and refused in one line.
#include <gtest/gtest.h>

#include <string>

#include "stoss/encounter/document.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

double lost_with_coat(const std::string& document, double speed) {
  const Encounter encounter = encounter_from_json(document);
  return restitution(refinable(encounter), speed_in_c(encounter, speed)).lost_fraction.value;
}

TEST(Coats, AreAlikeInSIAndInUnitsOfTheBody) {
  const std::string coat = R"("coat_poisson":0.45,"coat_quality":8)";
  const double own =
      lost_with_coat(R"({"first":{"kind":"sphere","poisson":0.25,"coat":0.002,"coat_young":0.01,)" + coat + "}}", 0.01);
  const std::string material = R"("material":{"young":1e10,"poisson":0.25,"density":2500})";
  const double si = lost_with_coat(
      R"({"first":{"kind":"sphere","radius":0.02,)" + material + R"(,"coat":4e-5,"coat_young":1e8,)" + coat + "}}",
      0.01 * 2000.0);
  EXPECT_NEAR(si, own, 1e-9 * own);
}

TEST(Coats, AreTheSameOnEitherFace) {
  const std::string ball = R"("kind":"sphere","poisson":0.3)", block = R"("kind":"half-space","young":3,"poisson":0.2)";
  const std::string coat = R"(,"coat":0.001,"coat_young":0.02,"coat_poisson":0.4)";
  const double one = lost_with_coat(R"({"first":{)" + ball + coat + R"(},"against":{)" + block + "}}", 0.02);
  const double other = lost_with_coat(R"({"first":{)" + ball + R"(},"against":{)" + block + coat + "}}", 0.02);
  EXPECT_NEAR(one, other, 1e-9 * one);
}

TEST(Coats, AreRefusedInOneLine) {
  const auto said = [](const std::string& numbers) {
    return test::message_of<InvalidInput>(
        [&] { validate(encounter_from_json(R"({"first":{"kind":"sphere","poisson":0.3,)" + numbers + "}}")); });
  };
  EXPECT_EQ(said(R"("coat":0.1)"), "coat_young: missing (a coat needs its modulus)");
  EXPECT_EQ(said(R"("coat_young":0.1)"), "coat: missing (its thickness; there is a coat_young)");
  EXPECT_EQ(said(R"("coat":-1,"coat_young":1)").substr(0, 24), "coat: got -1, allowed 0 ");
  EXPECT_EQ(said(R"("coat":0.1,"coat_young":1,"coat_poisson":0.5)").substr(0, 21), "coat_poisson: got 0.5");
  EXPECT_EQ(said(R"("coat":0.1,"coat_young":1,"coat_quality":1)").substr(0, 12), "coat_quality");
}

}  // namespace
}  // namespace stoss
