// Plates and strips of one layer and of several: documents, SI and ratios, refusals in one line.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "stoss/encounter/document.hpp"
#include "stoss/encounter/laws.hpp"
#include "stoss/encounter/materials.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "stoss/encounter/waves.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

const std::string ball = R"({"first":{"kind":"sphere","poisson":0.3},"against":)";
const std::string steel_ball = R"({"first":{"kind":"sphere","radius":0.005,"material":"structural steel"},"against":)";
const std::string laminated =
    R"({"kind":"plate","layers":[{"thickness":0.004,"material":"glass"},{"thickness":0.0008,"material":"PVB"},)"
    R"({"thickness":0.004,"material":"glass"}],"loss_time":0.0}})";

Plate plate_of(const std::string& document) {
  return std::get<Plate>(second_solid(encounter_from_json(document)).value());
}

std::string refusal_of(const std::string& document) {
  return test::message_of<InvalidInput>([&] { (void)encounter_from_json(document); });
}

TEST(Plates, HaveTheNumbersOfTheirDocument) {
  const Plate of_one = plate_of(ball + R"({"kind":"plate","thickness":2,"young":0.5,"density":3,"loss_time":0.1}})");
  EXPECT_EQ(of_one.thickness, 2.0);
  EXPECT_EQ(of_one.poisson, 0.3);  // that of the ball
  EXPECT_EQ(of_one.young, 0.5);
  EXPECT_EQ(of_one.density, 3.0);
  EXPECT_EQ(of_one.loss_time, 0.1);
  EXPECT_TRUE(of_one.below.empty());
  const Encounter flat = encounter_from_json(
      R"({"first":{"kind":"disk","poisson":0.3,"radius":2},"against":{"kind":"strip","thickness":0.5,"poisson":0.6}})");
  const auto strip = std::get<Strip>(second_solid(flat).value());
  EXPECT_EQ(strip.thickness, 0.5);
  EXPECT_EQ(strip.poisson, 0.6);
}

TEST(Plates, MayHaveLayersOfWhichTheLastHasNoEnd) {
  const Plate coated = plate_of(
      ball +
      R"({"kind":"plate","layers":[{"thickness":0.1,"young":4},{"thickness":0.2,"poisson":0.4},{"density":2}]}})");
  EXPECT_EQ(coated.thickness, 0.1);
  EXPECT_EQ(coated.young, 4.0);
  ASSERT_EQ(coated.below.size(), 2U);
  EXPECT_EQ(coated.below[0].thickness, 0.2);
  EXPECT_EQ(coated.below[0].poisson, 0.4);
  EXPECT_EQ(coated.below[0].young, 1.0);
  EXPECT_TRUE(std::isinf(coated.below[1].thickness));
  EXPECT_EQ(coated.below[1].poisson, 0.3);
  EXPECT_EQ(coated.below[1].density, 2.0);
}

TEST(Plates, InSIAreRatiosToTheBall) {
  const std::string elastic =
      R"({"first":{"kind":"sphere","radius":0.005,"loss_time":0,"material":"structural steel"},"against":)";
  const Plate pane = plate_of(elastic + laminated);
  const Material &steel = named_material("structural steel"), &glass = named_material("glass"),
                 &pvb = named_material("PVB");
  EXPECT_DOUBLE_EQ(pane.thickness, 0.8);
  EXPECT_DOUBLE_EQ(pane.young, glass.young / steel.young);
  EXPECT_EQ(pane.loss_time, 0.0);
  ASSERT_EQ(pane.below.size(), 2U);
  EXPECT_DOUBLE_EQ(pane.below[0].thickness, 0.16);
  EXPECT_DOUBLE_EQ(pane.below[0].density, pvb.density / steel.density);
  EXPECT_EQ(pane.below[0].poisson, pvb.poisson);
  EXPECT_DOUBLE_EQ(pane.below[1].young, glass.young / steel.young);
}

TEST(Plates, OfOneMaterialHaveItsQuality) {
  const std::string document =
      R"({"kind":"plate","layers":[{"thickness":0.004,"material":"glass"},{"thickness":0.004,"material":"glass"}]}})";
  const Encounter drop = encounter_from_json(steel_ball + document);
  EXPECT_EQ(losses_of(drop.against).quality, named_material("glass").quality);
  EXPECT_EQ(plate_of(steel_ball + document).loss_time, 0.0);
}

std::string with_format(const std::string& document) {
  return R"({"format":"stoss encounter 1",)" + document.substr(1);
}

TEST(Plates, ReadBackAsTheyWereWritten) {
  for (const std::string& document :
       {steel_ball + laminated, ball + R"({"kind":"plate","loss_time":0.1,"thickness":2.0,"young":0.5}})",
        ball + R"({"kind":"plate","layers":[{"thickness":0.1,"young":4.0},{"poisson":0.4}]}})"}) {
    EXPECT_EQ(to_json(encounter_from_json(document)), with_format(document));
  }
  EXPECT_EQ(to_json(encounter_from_json(ball + R"({"kind":"plate","layers":[{"thickness":2.0}]}})")),
            with_format(ball + R"({"kind":"plate","thickness":2.0}})"));
}

TEST(Plates, AreRefusedInOneLine) {
  const auto plate = [](const std::string& numbers) {
    return refusal_of(ball + R"({"kind":"plate",)" + numbers + "}}");
  };
  const auto layers = [&](const std::string& list) { return plate(R"("layers":[)" + list + "]"); };
  EXPECT_EQ(refusal_of(ball + R"("plate"})"), "against thickness: missing, a number (thickness, from face to face)");
  EXPECT_EQ(plate(R"("thickness":0)").substr(0, 25), "against thickness: got 0,");
  EXPECT_EQ(plate(R"("thickness":-1)").substr(0, 26), "against thickness: got -1,");
  EXPECT_EQ(plate(R"("thickness":null)"), "against thickness: got null, allowed a finite number");
  EXPECT_EQ(plate(R"("thickness":1,"rigid":true)").substr(0, 22), "against: got \"rigid\", ");
  EXPECT_EQ(
      plate(R"("thickness":1,"layers":[{"thickness":1}])"),
      "against: got \"thickness\", allowed kind, layers, relaxation, young_is, loss_time, quality, roughness, u0, "
      "coat, coat_young, coat_poisson, coat_quality, yield_strength, yield_hardening, yield_rate");
  EXPECT_EQ(plate(R"("layers":[])"), "against layers: got [], allowed a list of layers, from the top");
  EXPECT_EQ(layers("3"), "against layers 1: got 3, allowed an object");
  EXPECT_EQ(layers("{}"), "against thickness: missing, a number (thickness, from face to face)");
  EXPECT_EQ(layers(R"({"thickness":1},{},{"thickness":1})"),
            "against layer 2 thickness: missing (only the last layer may have none: it has no end)");
  EXPECT_EQ(layers(R"({"thickness":1,"loss_time":0})"),
            "against layers 1: got \"loss_time\", allowed only what is of one layer");
  EXPECT_NE(layers(R"({"thickness":1},{"thickness":0})"), "");
  EXPECT_NE(layers(R"({"thickness":1},{"thickness":1,"poisson":0.6})"), "");
  std::string many = R"({"thickness":1})";
  for (std::size_t i = 0; i < most_layers; ++i) many += R"(,{"thickness":1})";
  EXPECT_EQ(layers(many), "against layers: got 21, allowed 1 to 20 of a plate");
  EXPECT_EQ(
      refusal_of(R"({"first":{"kind":"disk","poisson":0.3},"against":{"kind":"strip","layers":[]}})").substr(0, 23),
      "against: got \"layers\", ");
  EXPECT_EQ(refusal_of(R"({"first":{"kind":"plate","thickness":1,"poisson":0.3}})"),
            "body: a plate cannot be the first body, because it does not move (give it as what is met)");
}

TEST(Plates, AreRefusedMaterialsThatDoNotGoTogether) {
  const auto layers = [](const std::string& list) {
    return refusal_of(steel_ball + R"({"kind":"plate","layers":[)" + list + "]}}");
  };
  EXPECT_EQ(layers(R"({"thickness":1,"material":"glass"},{"thickness":1})"),
            "against layer 2 material: missing (the first layer has one, so all need one)");
  EXPECT_EQ(layers(R"({"thickness":1},{"thickness":1,"material":"glass"})"),
            "against: needs a material too, because the first body has one (e.g. plate,material=glass)");
  EXPECT_EQ(layers(R"({"thickness":1,"material":"glass"},{"thickness":1,"material":"tin"})").substr(0, 20),
            "material: got 'tin',");
  EXPECT_EQ(layers(R"({"thickness":1,"material":"glass"},{"material":{"young":1e9,"poisson":0.3,"density":1e3,)"
                   R"("relaxation":[[0.5,-1]]}})")
                .substr(0, 38),
            "against layer 2 relaxation: got -1, al");
}

TEST(Plates, HaveTheLossesOfTheirLayers) {
  const auto losses = [](const std::string& of_all) {
    const Encounter made = encounter_from_json(
        steel_ball + R"({"kind":"plate",)" + of_all +
        R"("layers":[{"thickness":1,"material":"glass"},{"thickness":0.1,"material":{"young":1e9,"poisson":0.3,)" +
        R"("density":1e3,"relaxation":[[0.5,1e-5]]}},{"material":{"young":1e9,"poisson":0.3,"density":1e3,)" +
        R"("quality":30}}]}})");
    return std::pair(std::get<Plate>(*second_solid(made)), made);
  };
  const auto [plate, made] = losses("");
  ASSERT_EQ(plate.losses.size(), 3);
  EXPECT_EQ(plate.loss_time, 0.0);
  const double unit = si_scales(made)->time;
  EXPECT_GT(plate.losses[0].relaxation.terms.size(), 4);
  ASSERT_EQ(plate.losses[1].relaxation.terms.size(), 1);
  EXPECT_NEAR(plate.losses[1].relaxation.terms[0].time * unit, 1e-5, 1e-15);
  EXPECT_GT(plate.losses[2].relaxation.terms.size(), 4);
  // E of a quality is that at a frequency, E(0) is more.
  EXPECT_LT(plate.below[0].young / plate.young, 1.0 / 70.0);
  EXPECT_NEAR(plate.below[0].young / plate.young, 1.0 / 70.0, 1e-2 / 70.0);
  EXPECT_GT(plate.below[1].young / plate.below[0].young, 1.03);
  EXPECT_LT(plate.below[1].young / plate.below[0].young, 1.3);
  EXPECT_TRUE(losses(R"("loss_time":0,)").first.losses.empty());
  EXPECT_TRUE(losses(R"("relaxation":[[0.1,1]],)").first.losses.empty());
}

TEST(Plates, OfValuesInCppAreRefusedToo) {
  Encounter encounter{.first = {.kind = "sphere", .values = {{"poisson", 0.3}}},
                      .against = {.kind = "plate", .values = {{"thickness", 1.0}}, .below = {{}, {}}}};
  const auto refusal = [&] { return test::message_of<InvalidInput>([&] { validate(encounter); }); };
  EXPECT_EQ(refusal().substr(0, 34), "against layer 2 thickness: missing");
  encounter.against.below = {{.values = {{"loss_time", 0.1}}}};
  EXPECT_EQ(refusal(), "against layer 2 loss_time: one holds for the whole plate (give it with the first layer)");
  encounter.against = {.kind = "half-space", .below = {{}}};
  EXPECT_EQ(refusal(), "against layers: got 2, allowed 1 of a half-space");
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    encounter.against = {.kind = "plate", .values = {{"thickness", bad}}};
    EXPECT_EQ(refusal().substr(0, 23), "against thickness: got ");
  }
}

TEST(Plates, HaveNoSlowLawAndTheSpeedsOfTheirMaterial) {
  const Encounter drop = encounter_from_json(ball + R"({"kind":"plate","thickness":2}})");
  EXPECT_EQ(test::message_of<InvalidInput>([&] { (void)slow_law(drop); }),
            "beyond: got law, allowed error or clamp (there is no law of slow impacts of these bodies)");
  const Encounter block = encounter_from_json(ball + R"({"kind":"half-space"}})");
  EXPECT_EQ(wave_speeds(drop).shear, wave_speeds(block).shear);
  const Encounter wall = encounter_from_json(ball + R"("wall"})");
  EXPECT_EQ(test::message_of<InvalidInput>([&] { (void)wave_speeds(wall); }),
            "against: got wall, allowed a half-space, a half-plane, a plate or a strip");
}

TEST(Plates, BeginToYieldAsABlockOfTheFirstLayer) {
  const auto yields = [](const std::string& against) {
    return yield_speed(encounter_from_json(
        R"({"first":{"kind":"sphere","radius":0.005,"material":"bearing steel"},"against":)" + against + "}"));
  };
  EXPECT_EQ(yields(R"({"kind":"plate","thickness":0.01,"material":"aluminium"})"),
            yields(R"({"kind":"half-space","material":"aluminium"})"));
}

}  // namespace
}  // namespace stoss
