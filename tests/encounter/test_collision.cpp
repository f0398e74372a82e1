// How two bodies meet: its units, and its document.
#include "stoss/encounter/collision.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "stoss/encounter/schema.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

using test::message_of;

const Encounter ball_in_c{.first = {.kind = "sphere", .values = {{"poisson", 0.3}}}};
const Encounter ball_in_si{.first = {.kind = "sphere",
                                     .values = {{"radius", 0.005}},
                                     .material = Material{.young = 2e11, .poisson = 0.3, .density = 8000.0}}};

std::string said(const Encounter& encounter, const Collision& collision) {
  return message_of<InvalidInput>([&] { (void)own_units(encounter, collision); });
}

TEST(Collision, IsInUnitsOfTheFirstBody) {
  const Collision collision{.speed = 0.1, .tangential = -0.2, .spin = 0.3, .second_spin = -0.4, .friction = 0.5};
  const auto [speed, before] = own_units(ball_in_c, collision);
  EXPECT_EQ(speed, 0.1);
  EXPECT_EQ(before.tangential, -0.2);
  EXPECT_EQ(before.spin, 0.3);
  EXPECT_EQ(before.second_spin, -0.4);
  EXPECT_EQ(before.friction, 0.5);
}

TEST(Collision, IsInSiWithAMaterial) {
  // c = 5000 m/s, c/R = 1e6 rad/s
  const auto [speed, before] = own_units(ball_in_si, {.speed = 5.0, .tangential = 10.0, .spin = 2e3, .friction = 0.5});
  EXPECT_DOUBLE_EQ(speed, 1e-3);
  EXPECT_DOUBLE_EQ(before.tangential, 2e-3);
  EXPECT_DOUBLE_EQ(before.spin, 2e-3);
  EXPECT_EQ(before.friction, 0.5);
}

TEST(Collision, MayHaveAnAngleInPlaceOfTheVelocityAlong) {
  for (const Encounter& encounter : {ball_in_c, ball_in_si}) {
    const auto [speed, before] = own_units(encounter, {.speed = 0.1, .angle = 60.0});
    EXPECT_NEAR(before.tangential / speed, std::sqrt(3.0), 1e-15);
  }
  EXPECT_EQ(said(ball_in_c, {.speed = 0.1, .tangential = 0.1, .angle = 60.0}),
            "angle: cannot be combined with tangential (give one of them)");
  EXPECT_EQ(said(ball_in_c, {.speed = 0.1, .angle = 90.0}).substr(0, 13), "angle: got 90");
}

TEST(Collision, IsRefusedByTheNameOfWhatIsOutOfRange) {
  EXPECT_EQ(said(ball_in_c, {.speed = 2.0}), "speed: got 2, allowed 1e-8 to 1 c (speed of approach, along the normal)");
  EXPECT_EQ(said(ball_in_c, {.speed = 0.1, .friction = 5.5}),
            "friction: got 5.5, allowed 0 to 5 (coefficient of Coulomb's law)");
  EXPECT_EQ(said(ball_in_si, {.speed = 5.0, .tangential = 6000.0}).substr(0, 52),
            "tangential: got 6000, allowed -5000 to 5000 m/s (vel");
  EXPECT_EQ(said(ball_in_c, {.speed = std::nan("")}).substr(0, 10), "speed: got");
}

TEST(Collision, IsReadBackFromItsDocument) {
  const Collision given{.speed = 0.1, .spin = 0.3, .second_spin = -0.4, .friction = 0.5};
  const std::string text = to_json(given);
  EXPECT_EQ(text, R"({"speed":0.1,"spin":0.3,"second_spin":-0.4,"friction":0.5})");
  EXPECT_EQ(to_json(collision_from_json(text)), text);
  const Collision leaning = collision_from_json(R"({"speed": 1, "angle": 30})");
  EXPECT_EQ(leaning.angle, 30.0);
  EXPECT_EQ(to_json(leaning), R"({"speed":1.0,"angle":30.0})");
  EXPECT_EQ(to_json(collision_from_json(R"({"speed": 1})")), R"({"speed":1.0})");
}

TEST(Collision, HasItsKeysInTheSchema) {
  const auto schema = nlohmann::json::parse(encounter_schema());
  const auto& properties = schema["$defs"]["collision"]["properties"];
  EXPECT_EQ(properties.size(), 6U);
  for (const auto& [name, value] : properties.items()) {
    const std::string text = nlohmann::json{{"speed", 0.1}, {name, 0.1}}.dump();
    EXPECT_NO_THROW((void)collision_from_json(text)) << name;
  }
}

TEST(Collision, ThatCannotBeReadIsRefusedInOneLine) {
  const auto refused = [](const std::string& text) {
    return message_of<InvalidInput>([&] { (void)collision_from_json(text); });
  };
  EXPECT_EQ(refused("{}"), "collision speed: missing, a number");
  EXPECT_EQ(refused(R"({"speed": "fast"})"), "speed: got \"fast\", allowed a finite number");
  EXPECT_EQ(refused(R"({"speed": 1, "mu": 0.3})").substr(0, 20), "collision: got \"mu\",");
  EXPECT_EQ(refused("[1]").substr(0, 9), "collision");
  EXPECT_EQ(refused("{").substr(0, 9), "collision");
}

}  // namespace
}  // namespace stoss
