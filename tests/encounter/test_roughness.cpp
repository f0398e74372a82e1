// Rough faces as they are given: read, resolved in the units of the first body, refused in one line.
#include "stoss/encounter/roughness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "stoss/encounter/document.hpp"
#include "stoss/encounter/laws.hpp"
#include "stoss/prediction/prediction.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

Encounter met(const std::string& first, const std::string& against = R"("wall")") {
  return encounter_from_json(R"({"first":)" + first + R"(,"against":)" + against + "}");
}

std::string why_not(const std::string& first, const std::string& against = R"("wall")") {
  return test::message_of<InvalidInput>([&] { (void)met(first, against); });
}

/// u₀ of the contact that an encounter makes, R of the first.
double of_contact(const Encounter& encounter) { return contact_of(encounter, 6.0, 0.01).asperities; }

const std::string a_ball = R"("kind":"sphere","poisson":0.3)";
const std::string of_glass = R"("kind":"sphere","radius":0.005,"material":"glass")";

TEST(Roughness, ReadsBackAsItWasWritten) {
  for (const std::string text : {R"({"kind":"sphere","poisson":0.3,"roughness":0.01})", R"({"kind":"wall","u0":0.02})",
                                 R"({"kind":"plate","layers":[{"thickness":0.1},{"thickness":0.2}],"u0":0.01})"}) {
    EXPECT_EQ(to_json(participant_from_json("body", text)), text);
  }
}

TEST(Roughness, HasTheLengthOfItsLawByOneFactor) {
  EXPECT_DOUBLE_EQ(asperities_of(met("{" + a_ball + R"(,"roughness":0.01})")), asperities_over_rms * 0.01);
  EXPECT_EQ(asperities_of(met("{" + a_ball + R"(,"u0":0.01})")), 0.01);
  EXPECT_EQ(asperities_of(met("{" + a_ball + R"(,"roughness":0,"u0":0.01})")), 0.01);
  EXPECT_EQ(asperities_of(met("{" + a_ball + R"(,"roughness":0})")), 0.0);
}

// Of both faces together, in whatever units they are given, whatever meets what.
TEST(Roughness, IsThatOfBothFacesInEveryUnit) {
  const double both = 0.01 * std::sqrt(2.0);
  for (const std::string against :
       {R"("same")", R"({"kind":"wall","u0":0.01})", R"({"kind":"half-space","u0":0.01})",
        R"({"kind":"sphere","radius":3,"u0":0.01})", R"({"kind":"plate","thickness":0.7,"u0":0.01})",
        R"({"kind":"exponential","hardness":100})", R"({"kind":"half-space","young":3,"density":2,"u0":0.01})"}) {
    const Encounter encounter = met("{" + a_ball + R"(,"u0":0.01})", against);
    EXPECT_NEAR(asperities_of(encounter), both, 1e-12) << against;
    EXPECT_NEAR(of_contact(encounter), both, 1e-12) << against;
  }
  for (const std::string against :
       {R"("same")", R"({"kind":"wall","u0":5e-5})", R"({"kind":"half-space","material":"structural steel","u0":5e-5})",
        R"({"kind":"sphere","radius":0.02,"material":"glass","u0":5e-5})",
        R"({"kind":"plate","thickness":0.004,"material":"glass","u0":5e-5})"}) {
    EXPECT_NEAR(of_contact(met("{" + of_glass + R"(,"u0":5e-5})", against)), both, 1e-12) << against;
  }
  const std::string rod = R"({"kind":"rod","length":2,"u0":0.02})";
  for (const std::string against : {R"("same")", R"({"kind":"wall","u0":0.02})", R"({"kind":"rod","u0":0.02})"}) {
    EXPECT_NEAR(of_contact(met(rod, against)), both, 1e-12) << against;
  }
  const std::string steel = R"({"kind":"rod","length":0.2,"area":1e-4,"material":"structural steel","u0":0.002})";
  EXPECT_NEAR(of_contact(met(steel, R"("same")")), both, 1e-12);
  const std::string scaled = R"({"kind":"sphere","poisson":0.3,"radius":2,"u0":0.02})";
  EXPECT_NEAR(of_contact(met(scaled, R"({"kind":"half-space","u0":0.02})")), both, 1e-12);
  EXPECT_NEAR(of_contact(met(scaled, R"({"kind":"wall","u0":0.02})")), both, 1e-12);
}

TEST(Roughness, IsInTheNameOfABody) {
  EXPECT_EQ(contact_of(met("{" + a_ball + R"(,"u0":0.01})"), 6.0, 0.01).first->name,
            "sphere poisson=0.3 asperities=0.01");
}

TEST(Roughness, IsRefusedInOneLine) {
  const std::string low = "got -1, allowed 0 or more";
  EXPECT_EQ(why_not("{" + a_ball + R"(,"roughness":0.1,"u0":0.1})"),
            "roughness: given beside u0, which is 0.45 of it (give one of both)");
  EXPECT_NE(why_not("{" + a_ball + R"(,"roughness":-1})").find("roughness: " + low), std::string::npos);
  EXPECT_NE(why_not("{" + a_ball + R"(,"u0":1.01})").find("u0: got 1.01, allowed 0 to 1 "), std::string::npos);
  EXPECT_NE(why_not("{" + a_ball + R"(,"roughness":1e300})").find("roughness: got 1e+300, allowed 0 to 2.22222"),
            std::string::npos);
  EXPECT_NE(why_not("{" + of_glass + R"(,"u0":0.006})").find("u0: got 0.006, allowed 0 to 0.005 "), std::string::npos);
  EXPECT_NE(why_not("{" + a_ball + "}", R"({"kind":"wall","u0":-1})").find("against u0: " + low), std::string::npos);
  EXPECT_NE(why_not("{" + a_ball + "}", R"({"kind":"sphere","u0":2})").find("against u0: got 2, allowed 0 to 1 "),
            std::string::npos);
  EXPECT_NE(why_not("{" + a_ball + "}", R"({"kind":"same","u0":0.1})").find("against"), std::string::npos);
  EXPECT_NE(why_not("{" + a_ball + "}", R"({"kind":"plate","layers":[{"thickness":1,"u0":0.1}]})").find("u0"),
            std::string::npos);
}

TEST(Roughness, IsNotForWhatKnowsSmoothFacesAlone) {
  const Encounter rough = met("{" + a_ball + R"(,"roughness":0.1})");
  EXPECT_EQ(test::message_of<InvalidInput>([&] { (void)slow_law(rough); }),
            "roughness: the law of slow impacts knows smooth faces alone (leave it out)");
  const Encounter wall = met("{" + a_ball + "}", R"({"kind":"exponential"})");
  EXPECT_EQ(test::message_of<InvalidInput>([&] { (void)slow_law(wall); }),
            "against hardness: the law of slow impacts knows smooth faces alone (leave it out)");
  EXPECT_THROW((void)mixture(met("{" + a_ball + "}", R"({"kind":"sphere","u0":0.1})")), InvalidInput);
}

TEST(Roughness, PredictionSaysWhatItSavesAndBelowWhichSpeedItCounts) {
  const std::string steel = R"("kind":"sphere","radius":0.005,"material":"bearing steel")";
  const PredictionOptions quick{.influences = false, .tolerance = 1e-2};
  const Encounter smooth = met("{" + steel + "}"), rough = met("{" + steel + R"(,"roughness":24e-9})");
  EXPECT_EQ(thresholds(smooth).rough, thresholds(rough).rough);  // as smooth as a bearing ball
  const auto said = [](const Prediction& made, const std::string& begin) {
    for (const std::string& each : made.warnings) {
      if (each.starts_with(begin)) return each;
    }
    return std::string();
  };
  const double limit = thresholds(smooth).rough;
  EXPECT_GT(limit, 0.02);
  EXPECT_LT(limit, 0.2);  // at 0.1 m/s it is compressed by 1.9 µm
  const std::vector<Prediction> at = predict(smooth, {0.9 * limit, 1.1 * limit}, quick);
  EXPECT_NE(said(at[0], "faces are taken as smooth: below "), "");
  EXPECT_EQ(said(at[1], "faces are taken as smooth"), "");
  const std::vector<Prediction> with = predict(rough, {0.2 * limit}, quick);
  EXPECT_EQ(said(with[0], "faces are taken as smooth"), "");
  EXPECT_NE(said(with[0], "asperities: waves take "), "");
  EXPECT_LT(with[0].share(Channel::ringing), predict(smooth, {0.2 * limit}, quick)[0].share(Channel::ringing));
}

// 0.45 is known to 0.05, which is an uncertain constant of every prediction with a roughness.
TEST(Roughness, IsAnUncertainConstantOfAPrediction) {
  const Encounter rough = met(R"({"kind":"sphere","radius":0.005,"material":"bearing steel"})",
                              R"({"kind":"half-space","material":"glass","roughness":1e-6})");
  const Prediction made = predict(rough, {0.05}, {.tolerance = 1e-2})[0];
  const auto its = std::find_if(made.influences.begin(), made.influences.end(),
                                [](const Influence& each) { return each.constant == "against.roughness"; });
  ASSERT_NE(its, made.influences.end());
  EXPECT_NEAR(its->uncertainty, 1.0 / 9.0, 1e-12);
  EXPECT_GT(its->change, 0.0);
}

}  // namespace
}  // namespace stoss
