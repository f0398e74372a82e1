// Materials that relax as they are given: read, resolved in the units of the first body, refused in one line.
#include "stoss/encounter/relaxing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <string>

#include "stoss/bodies/plate.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/encounter/laws.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/prediction/prediction.hpp"
#include "stoss/relaxation/constant_quality.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

std::string refusal(const std::string& first, const std::string& against = R"("wall")") {
  return test::message_of<InvalidInput>(
      [&] { (void)encounter_from_json(R"({"first":)" + first + R"(,"against":)" + against + "}"); });
}

/// 1 − ε of what a document describes. @param speed as it is given
double lost(const std::string& document, double speed, double cutoff = 20.0) {
  const Encounter encounter = encounter_from_json(document);
  const double own = speed / speed_unit(encounter);
  return 1.0 - impact(contact_of(encounter, cutoff, own), own).restitution;
}

TEST(RelaxingMaterial, IsReadFromATextAndWrittenAsOne) {
  const Relaxation read = parse_relaxation("relaxation", "0.5:1+2e-1:1e+1");
  EXPECT_EQ(read, (Relaxation{{{0.5, 1.0}, {0.2, 10.0}}}));
  EXPECT_EQ(text_of(read), "0.5:1+0.2:10");
  for (const char* garbage : {"", "0.5", "0.5:", ":1", "0.5:1+", "0.5:1,0.2:10", "0.5:1:2", "a:b", "0.5:1++0.2:10"}) {
    EXPECT_THROW((void)parse_relaxation("relaxation", garbage), InvalidInput) << garbage;
  }
}

TEST(RelaxingMaterial, ReadsBackAsItWasWritten) {
  const std::string text =
      R"({"format":"stoss encounter 1","first":{"kind":"sphere","radius":0.005,"relaxation":[[0.5,1e-05],[0.2,0.0001]],)"
      R"("material":{"young":2000000.0,"poisson":0.49,"density":1100.0}},)"
      R"("against":{"kind":"half-space","material":{"young":70000000000.0,"poisson":0.22,"density":2500.0,)"
      R"("relaxation":[[0.1,0.001]]}}})";
  EXPECT_EQ(to_json(encounter_from_json(text)), text);
}

TEST(RelaxingMaterial, IsTheSameInSIAndInOwnUnitsAndFromItsRelaxedModulus) {
  const double c = std::sqrt(2e6 / 1100.0), time = 0.01 / c;
  const std::string terms = "[[0.5," + std::to_string(time * 1e6) + "e-6],[0.2," + std::to_string(time * 1e7) + "e-6]]";
  const auto in_si = [](const std::string& young, const std::string& beside) {
    return R"({"first":{"kind":"sphere","radius":0.01,)" + beside + R"("material":{"young":)" + young +
           R"(,"poisson":0.3,"density":1100}}})";
  };
  const double own = lost(R"({"first":{"kind":"sphere","poisson":0.3,"relaxation":[[0.5,1],[0.2,10]]}})", 0.1);
  EXPECT_GT(own, 0.2);
  EXPECT_NEAR(lost(in_si("2e6", R"("relaxation":)" + terms + ","), 0.1 * c), own, 1e-6);
  EXPECT_NEAR(lost(in_si("6e5", R"("young_is":"relaxed","relaxation":)" + terms + ","), 0.1 * c), own, 1e-6);
  EXPECT_NEAR(lost(in_si("2e6", ""), 0.1 * c), lost(R"({"first":{"kind":"sphere","poisson":0.3}})", 0.1), 1e-9);
}

TEST(RelaxingMaterial, OfAPartnerIsInTimesOfTheFirst) {
  const auto pair = [](const std::string& first, const std::string& second) {
    return lost(
        R"({"first":{"kind":"sphere","poisson":0.3)" + first + R"(},"against":{"kind":"sphere")" + second + "}}", 0.1);
  };
  const double lossy = pair("", R"(,"radius":2,"young":0.25,"relaxation":[[0.5,4]])");
  EXPECT_GT(lossy, 0.01);
  // A ball of the same size and modulus with the same times is the first.
  EXPECT_NEAR(pair(R"(,"relaxation":[[0.5,3]])", R"(,"relaxation":[[0.5,3]])"),
              lost(R"({"first":{"kind":"sphere","poisson":0.3,"relaxation":[[0.5,3]]},"against":"same"})", 0.1), 1e-9);
  EXPECT_NEAR(lossy, pair("", R"(,"radius":2,"young":0.25,"relaxation":[[0.25,4],[0.25,4]])"), 1e-6);
  // The same two, the other of which has R/c = 4 and c = 1/2, with that one as the first.
  const std::string turned = R"({"first":{"kind":"sphere","poisson":0.3,"relaxation":[[0.5,1]]},)"
                             R"("against":{"kind":"sphere","radius":0.5,"young":4}})";
  EXPECT_NEAR(lost(turned, 0.2, 80.0), lossy, 2e-3);
}

TEST(ConstantQuality, HoldsTheModulusAtItsFrequency) {
  const Encounter ball = encounter_from_json(
      R"({"first":{"kind":"sphere","radius":0.01,"material":{"young":2e6,"poisson":0.3,"density":1100,"quality":10,)"
      R"("frequency":3000}}})");
  const Relaxation its = constant_quality(10.0, lowest_of_body, highest_of_body);
  const Scales scales = si_scales(ball).value();
  const double young = scales.speed * scales.speed * 1100.0;
  EXPECT_NEAR(young * std::abs(modulus(its, {0.0, 3000.0 * scales.time})) / 2e6, 1.0, 3e-3);
  const double lossy = lost(to_json(ball), 1.0);
  EXPECT_GT(lossy, 0.05);
  EXPECT_NEAR(lost(R"({"first":{"kind":"sphere","poisson":0.3,"quality":10}})", 1.0 / scales.speed), lossy, 1e-12);
}

TEST(RelaxingMaterial, IsRefusedInOneLine) {
  const auto ball = [](const std::string& more) { return R"({"kind":"sphere","poisson":0.3,)" + more + "}"; };
  EXPECT_EQ(refusal(ball(R"("relaxation":[[0.75,1],[0.5,2]])")),
            "relaxation: got shares of 1.25 in sum, allowed at most 1 (what is left of it is E_inf/E(0))");
  EXPECT_EQ(refusal(ball(R"("relaxation":[[0.5,0]])")),
            "relaxation: got 0, allowed times above 0, 1e-30 to 1e30 (tau_j of a term)");
  EXPECT_EQ(refusal(ball(R"("relaxation":[[0,1]])")),
            "relaxation: got 0, allowed shares of E(0) above 0, up to 1 (E_j/E(0) of a term)");
  EXPECT_EQ(refusal(ball(R"("relaxation":[0.5,1])")),
            "first relaxation: got 0.5, allowed a list of pairs [share, time], as in [[0.5, 1], [0.2, 10]]");
  EXPECT_EQ(
      refusal(ball(R"("relaxation":[[0.5,1]],"loss_time":0.1)")),
      "relaxation: got a relaxation beside a loss_time, allowed one of them (each says by itself how the material "
      "loses energy)");
  EXPECT_EQ(refusal(ball(R"("relaxation":[[0.5,1]],"quality":10)")),
            "relaxation: got a relaxation beside a quality, allowed one of them (each says by itself how the material "
            "loses energy)");
  EXPECT_EQ(refusal(ball(R"("young_is":"relaxed")")), "young_is: there is no relaxation (leave it out, or give one)");
  EXPECT_EQ(refusal(ball(R"("relaxation":[[0.5,1]],"young_is":"E0")")),
            R"(first young_is: got "E0", allowed "instantaneous" or "relaxed")");
  EXPECT_EQ(refusal(ball(R"("relaxation":[[1,1]],"young_is":"relaxed")")),
            "young_is: got relaxed, with shares of 1 in sum, allowed instantaneous (E_inf is 0: nothing is left of the "
            "modulus)");
  EXPECT_EQ(refusal(ball(R"("quality":2)")).substr(0, 35), "quality: got 2, allowed 3 to 1e9 (Q");
  EXPECT_EQ(refusal(ball(R"("quality":10)"), R"({"kind":"sphere","rigid":true,"relaxation":[[0.5,1]]})"),
            "against relaxation: got 0.5:1, allowed none of a rigid body, which loses nothing");
  EXPECT_EQ(refusal(ball(R"("quality":10)"), R"({"kind":"sphere","rigid":true,"quality":10})"),
            "against quality: got 10, allowed 0 of a rigid body, which loses nothing");
  EXPECT_EQ(refusal(ball(R"("quality":10)"),
                    R"({"kind":"plate","layers":[{"thickness":1,"relaxation":[[0.5,1]]},{"thickness":1}]})"),
            R"(against layers 1: got "relaxation", allowed only what is of one layer)");
}

TEST(RelaxingMaterial, HasLawsOfSlowImpactsOfBallsOnly) {
  const auto read = [](const std::string& kind, const std::string& against) {
    return encounter_from_json(R"({"first":{"kind":")" + kind + R"(","poisson":0.3,"quality":10},"against":)" +
                               against + "}");
  };
  const std::string equal = R"({"kind":"sphere","poisson":0.3,"quality":10})";
  const double at_wall = slow_law(read("sphere", R"("wall")"))(1e-5).value;
  EXPECT_NEAR(10.0 * (1.0 - at_wall * at_wall), 2.1747, 0.01 * 2.1747);
  for (const std::string& met : {std::string(R"("same")"), equal}) {
    EXPECT_EQ(slow_law(read("sphere", met))(2e-5).value, at_wall);
  }
  // A named material has one, in SI.
  const Encounter glass = encounter_from_json(R"({"first":{"kind":"sphere","radius":1,"material":"glass"}})");
  EXPECT_NEAR(1.0 - slow_law(glass)(1e-6).value, 0.5 * 2.4065e-3, 0.01 * 1.2e-3);
  for (const Encounter& each : {read("disk", R"("wall")"), read("sphere", R"({"kind":"half-space"})"),
                                read("sphere", R"({"kind":"sphere","quality":20})")}) {
    EXPECT_EQ(test::message_of<InvalidInput>([&] { (void)slow_law(each); }),
              "relaxation: the law of slow impacts knows materials that relax of a sphere at a wall or against its "
              "equal only (give a loss_time; 0: no loss)");
  }
  EXPECT_EQ(test::message_of<InvalidInput>([&] { (void)mixture(read("sphere", equal)); }),
            "quality: a table of pairs knows no material that relaxes (give a loss_time; 0: no loss)");
}

TEST(RelaxingLayers, HaveTheirOwnOrOneForAll) {
  const auto plate = [](const std::string& first, const std::string& second, const std::string& whole) {
    return R"({"kind":"plate",)" + whole + R"("layers":[{"thickness":0.01,"material":{"young":1e9,"poisson":0.3,)" +
           R"("density":1000)" + first +
           R"(}},{"thickness":0.01,"material":{"young":2e9,"poisson":0.3,"density":1000)" + second + R"(}}]})";
  };
  const std::string ball = R"({"kind":"sphere","radius":0.01,"material":"bearing steel","loss_time":0})";
  const std::string relaxation = R"(,"relaxation":[[0.5,1e-5]])";
  const auto differ = [&](const std::string& taken) {
    const Encounter made = encounter_from_json(R"({"first":)" + ball + R"(,"against":)" + taken + "}");
    EXPECT_EQ(layers_differ(made.against), !std::get<Plate>(*second_solid(made)).losses.empty());
    return layers_differ(made.against);
  };
  EXPECT_TRUE(differ(plate(relaxation, "", "")));
  EXPECT_TRUE(differ(plate("", R"(,"quality":20)", "")));
  EXPECT_FALSE(differ(plate(relaxation, relaxation, "")));
  EXPECT_FALSE(differ(plate(relaxation, "", R"("relaxation":[[0.2,1e-5]],)")));
  EXPECT_EQ(refusal(ball, plate(R"(,"loss_time":1e-6,"quality":20)", "", "")).substr(0, 43),
            "against quality: got a quality beside a los");
}

}  // namespace
}  // namespace stoss
