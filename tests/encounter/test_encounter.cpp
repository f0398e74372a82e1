// Who meets whom: the same contacts as made by hand, in SI and as ratios; refusals in one line.
#include "stoss/encounter/encounter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "stoss/encounter/document.hpp"
#include "stoss/quasistatic/yield.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

const Material steel{2.1e11, 0.3, 7850.0}, glass{7e10, 0.22, 2500.0};

double loss(const RefinableContact& contact, double speed) {
  return restitution(contact, speed, {.tolerance = 1e-2}).lost_fraction.value;
}

TEST(Encounter, IsTheContactMadeByHand) {
  const Encounter pair{.first = {.values = {{"poisson", 0.33}}},
                       .against = {.kind = "disk", .values = {{"radius", 2.0}, {"young", 3.0}}}};
  const Disk second{.poisson = 0.33, .radius = 2.0, .young = 3.0};
  EXPECT_EQ(loss(refinable(pair), 0.1), loss(RefinableContact(disk(0.33), disk(second)), 0.1));

  const Encounter wall{.first = {.kind = "sphere", .values = {{"poisson", 0.3}, {"loss_time", 0.1}}}};
  EXPECT_EQ(loss(refinable(wall), 0.1), loss(RefinableContact(sphere(Sphere{.poisson = 0.3, .loss_time = 0.1})), 0.1));

  const Encounter same{.first = {.kind = "rod"}, .against = {.kind = "same"}};
  EXPECT_EQ(second_maker(same)(10.0, {}).name, rod()(10.0, {}).name);
}

TEST(Encounter, HasAUsualCutoff) {
  const Encounter wall{.first = {.kind = "sphere", .values = {{"poisson", 0.3}}}};
  EXPECT_EQ(usual_cutoff(wall, 0.1), 50.0);
  EXPECT_EQ(usual_cutoff(wall, 0.1, 20.0), 20.0);

  Encounter block = wall;
  block.against.kind = "half-space";
  const RefinableContact contact = refinable(block);
  EXPECT_DOUBLE_EQ(usual_cutoff(block, 0.1), 64.0 / time_scale(contact.at(0)) / contact.stretch(0.1));
  EXPECT_EQ(usual_cutoff(block, 0.1, 5.0), 5.0);
  EXPECT_LT(usual_cutoff(block, 1e-8), 2.0);  // as long as it lasts there would be millions of modes
  EXPECT_LE(mode_count(contact_of(block, usual_cutoff(block, 1e-8), 1e-8)), 40000U);
  for (const double wrong : {0.0, -1.0, std::nan("")}) EXPECT_GT(usual_cutoff(block, wrong), 0.0);
}

TEST(Encounter, HasAUsualCutoffThatUnequalBodiesHave) {
  Encounter pair{.first = {.kind = "sphere", .values = {{"poisson", 0.3}}}, .against = {.kind = "sphere"}};
  const auto cutoff = [&](const std::string& name, double value) {
    pair.against.values = {{name, value}};
    return usual_cutoff(pair, 0.01);
  };
  EXPECT_EQ(cutoff("radius", 0.5), 50.0);
  EXPECT_EQ(cutoff("radius", 10.0), 50.0);
  EXPECT_EQ(cutoff("radius", 30.0), 20.0);   // 600 of its own
  EXPECT_GT(cutoff("radius", 0.03), 300.0);  // 9 of its own
  EXPECT_LE(cutoff("young", 1e-3), 64.0 / 22.0);
  EXPECT_THROW((void)cutoff("radius", 100.0), InvalidInput);
  pair.first.rigid = true;
  EXPECT_LE(cutoff("young", 1e-4), 600.0 / 100.0);
  EXPECT_GT(cutoff("young", 1e-4), 20.0 / 100.0);
}

TEST(Encounter, InSIHasTheUnitsOfTheFirst) {
  const Encounter drop{.first = {.kind = "sphere", .values = {{"radius", 0.005}}, .material = steel},
                       .against = {.kind = "half-space", .material = glass}};
  const auto block = std::get<HalfSpace>(*second_solid(drop));
  EXPECT_EQ(block.poisson, 0.22);
  EXPECT_DOUBLE_EQ(block.young, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(block.density, 2500.0 / 7850.0);
  EXPECT_DOUBLE_EQ(speed_unit(drop), std::sqrt(2.1e11 / 7850.0));
  EXPECT_DOUBLE_EQ(speed_in_c(drop, 1.0), 1.0 / std::sqrt(2.1e11 / 7850.0));
  EXPECT_EQ(unit_system(drop), UnitSystem::sphere_si);
}

TEST(Encounter, OfLongCylindersIsInPlaneStrain) {
  const Encounter pair{
      .first = {.values = {{"radius", 0.01}, {"loss_time", 1e-6}}, .material = steel, .plane = Plane::strain},
      .against = {.kind = "half-plane", .material = glass, .plane = Plane::strain}};
  const auto one = std::get<Disk>(first_solid(pair));
  EXPECT_DOUBLE_EQ(one.poisson, 0.3 / 0.7);
  EXPECT_EQ(one.radius, 1.0);
  EXPECT_DOUBLE_EQ(one.loss_time, 1e-6 / si_scales(pair)->time);
  const auto other = std::get<HalfPlane>(*second_solid(pair));
  EXPECT_NEAR(other.young, (7e10 / (1.0 - 0.22 * 0.22)) / (2.1e11 / (1.0 - 0.09)), 1e-15);
}

TEST(Encounter, BeginsToYield) {
  Material hard = steel;
  hard.yield_strength = 1.7e9;
  Encounter drop{.first = {.kind = "sphere", .values = {{"radius", 0.005}}, .material = hard}};
  EXPECT_EQ(yield_speed(drop), quasistatic::yield_speed(hard, 0.005));
  drop.against = {.kind = "same"};
  EXPECT_EQ(yield_speed(drop), quasistatic::yield_speed(hard, 0.005, hard, 0.005));
  drop.first.material = steel;
  EXPECT_FALSE(yield_speed(drop));
  EXPECT_EQ(yield_warning(drop, 1e9), "");
}

TEST(Encounter, SaysHowFarBeyondYieldASpeedIs) {
  const auto said = [](const std::string& ball, const std::string& against, double speed) {
    const std::string first = R"({"first":{"kind":"sphere","radius":0.005,"material":")" + ball + R"("},"against":)";
    return yield_warning(encounter_from_json(first + against + "}"), speed);
  };
  const std::string block = R"({"kind":"half-space","material":"glass"})";
  EXPECT_EQ(said("structural steel", block, 0.0155), "");
  EXPECT_EQ(said("structural steel", block, 1.0),
            "the ball yields above 0.0155 m/s (you asked for 1 m/s, 64 times that): the real rebound is much lower; "
            "give a yield_strength, or use "
            "stoss predict");
  EXPECT_EQ(said("bearing steel", R"("wall")", 0.2),
            "the ball yields above 0.128 m/s (you asked for 0.2 m/s, 1.56 times that): the real rebound is lower; give "
            "a yield_strength, or use "
            "stoss predict");
  const std::string soft = R"(,"material":"structural steel"})";
  EXPECT_EQ(said("glass", R"({"kind":"half-space")" + soft, 1.0).substr(0, 16), "the block yields");
  EXPECT_EQ(said("glass", R"({"kind":"plate","thickness":0.01)" + soft, 1.0).substr(0, 16), "the plate yields");
  EXPECT_EQ(said("glass", R"({"kind":"sphere","radius":0.01)" + soft, 1.0).substr(0, 21), "the other ball yields");
}

TEST(Encounter, SaysWhatIsTakenAsSound) {
  const auto said = [](const std::string& text) { return sound_warnings(encounter_from_json(text)); };
  const std::vector<std::string> ice{
      "ice is taken as sound, smooth, dry and uncracked: measured losses are often ten times as large and more"};
  EXPECT_EQ(said(R"({"first":{"kind":"sphere","radius":1,"material":"ice"},"against":"same"})"), ice);
  EXPECT_EQ(said(R"({"first":{"kind":"sphere","radius":1,"material":"ice"},
                     "against":{"kind":"half-space","material":"ice"}})"),
            ice);
  for (const std::string own : {R"("loss_time":0)", R"("quality":20)", R"("relaxation":[[0.1,1]])"}) {
    EXPECT_TRUE(
        said(R"({"first":{"kind":"sphere","radius":1,)" + own + R"(,"material":"ice"},"against":"same"})").empty());
  }
  EXPECT_TRUE(said(R"({"first":{"kind":"sphere","radius":1,"material":"brass"},"against":"same"})").empty());
}

TEST(Encounter, RefusesInOneLine) {
  const Participant ball{.kind = "sphere", .values = {{"poisson", 0.3}}};
  EXPECT_EQ(test::message_of<InvalidInput>([&] { validate(Encounter{.first = ball, .against = {.kind = "rod"}}); }),
            "against: got rod for a sphere, allowed wall, same, sphere, hollow-sphere, half-space, plate or modal (" +
                who_meets_whom() + ")");
  EXPECT_EQ(
      test::message_of<InvalidInput>(
          [&] { validate(Encounter{.first = ball, .against = {.kind = "half-space", .material = glass}}); }),
      "against: has a material, but the first body is dimensionless (give both a material and sizes in SI, or ratios)");
  EXPECT_EQ(test::message_of<InvalidInput>([] { validate(Encounter{.first = {.kind = "sphere", .material = steel}}); }),
            "radius: missing (a material needs it too, in m)");
  EXPECT_EQ(test::message_of<InvalidInput>([] { validate(Encounter{}); }).substr(0, 26), "poisson: missing, a number");
  EXPECT_EQ(test::message_of<InvalidInput>([&] {
              validate(Encounter{.first = ball, .against = {.kind = "sphere", .values = {{"young", -1.0}}}});
            }).substr(0, 22),
            "against young: got -1,");
  EXPECT_EQ(test::message_of<InvalidInput>([&] {
              validate(Encounter{.first = ball, .against = {.kind = "sphere", .values = {{"area", 1.0}}}});
            }),
            "against area: a sphere has none (leave it out)");
  Participant rigid_ball = ball;
  rigid_ball.rigid = true;
  EXPECT_EQ(test::message_of<InvalidInput>([&] { validate(Encounter{.first = rigid_ball}); }),
            "rigid: got a rigid sphere against wall, allowed only against an elastic sphere, hollow-sphere, "
            "half-space, plate or "
            "modal, which deforms");
}

}  // namespace
}  // namespace stoss
