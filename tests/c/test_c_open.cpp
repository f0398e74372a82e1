// An encounter that is handed over as a JSON document is the one of handles, and of C++.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/stoss.h"
#include "support/body_files.hpp"
#include "support/c_handles.hpp"

namespace stoss {
using namespace test;

namespace {

constexpr const char* steel_on_glass =
    R"({"first": {"kind": "sphere", "radius": 0.005, "material": {"young": 2.1e11, "poisson": 0.3, "density": 7850}},
        "against": {"kind": "half-space", "material": {"young": 7e10, "poisson": 0.22, "density": 2500}}})";

stoss_result at(const stoss_contact* contact, double speed) {
  stoss_result result{};
  EXPECT_EQ(stoss_curve(contact, &speed, 1, 1e-2, 1e-6, nullptr, &result), STOSS_OK) << stoss_message();
  return result;
}

TEST(COpen, IsTheContactOfHandles) {
  CContact opened, made;
  ASSERT_EQ(stoss_open(steel_on_glass, &opened), STOSS_OK) << stoss_message();
  CBody ball, block;
  ASSERT_EQ(stoss_sphere_make(0.3, 1.0, 1.0, 1.0, 0.0, &ball), STOSS_OK);
  ASSERT_EQ(stoss_half_space_make(0.22, 7e10 / 2.1e11, 2500.0 / 7850.0, 0.0, &block), STOSS_OK);
  ASSERT_EQ(stoss_pair_contact_make(ball, block, &made), STOSS_OK);
  EXPECT_EQ(stoss_speed_unit(opened), std::sqrt(2.1e11 / 7850));
  EXPECT_EQ(stoss_speed_unit(made), 1.0);
  EXPECT_EQ(stoss_speed_unit(nullptr), 1.0);
  const double speed = 1.0 / stoss_speed_unit(opened);
  EXPECT_EQ(at(opened, speed).restitution.value, at(made, speed).restitution.value);

  stoss_function* function = nullptr;
  ASSERT_EQ(stoss_function_make(opened, 0.01, 0.05, 1e-2, STOSS_BEYOND_LAW, nullptr, &function), STOSS_OK);
  stoss_function_free(function);
}

/// A cube that is struck in the middle of a face, with its lowest modes made up.
constexpr const char* cube =
    R"({"kind": "modal", "body": {"format": "stoss modal body 1", "name": "cube", "mass": 0.00785, "curvature": 0,
        "young": 2.1e11, "poisson": 0.3, "density": 7850, "compliance": -2e-10, "complete_to": 3e5,
        "modes": {"frequency": [1.6e5, 2.4e5], "displacement": [9, -14]}}})";

TEST(COpen, TakesBodiesByTheirModes) {
  const std::string ball = R"({"kind": "sphere", "radius": 0.005, "material": "structural steel"})";
  CContact at_wall, met, meeting, none;
  EXPECT_EQ(stoss_open((R"({"first": )" + std::string(cube) + "}").c_str(), &at_wall), STOSS_INVALID_INPUT);  // flat
  ASSERT_EQ(stoss_open((R"({"first": )" + ball + R"(, "against": )" + cube + "}").c_str(), &met), STOSS_OK);
  ASSERT_EQ(stoss_open((R"({"first": )" + std::string(cube) + R"(, "against": )" + ball + "}").c_str(), &meeting),
            STOSS_OK);
  EXPECT_DOUBLE_EQ(stoss_speed_unit(meeting), std::sqrt(2.1e11 / 7850));
  // Whoever is called the first.
  const double speed = 1e-4;
  stoss_result one{}, other{};
  ASSERT_EQ(stoss_curve(met, &speed, 1, 0.2, 1e-6, nullptr, &one), STOSS_OK) << stoss_message();
  ASSERT_EQ(stoss_curve(meeting, &speed, 1, 0.2, 1e-6, nullptr, &other), STOSS_OK) << stoss_message();
  EXPECT_LT(one.restitution.value, 1.0);
  EXPECT_NEAR(one.restitution.value, other.restitution.value, one.restitution.error + other.restitution.error);
  EXPECT_EQ(stoss_open(R"({"first": {"kind": "modal", "body": {"format": "stoss modal body 1"}}})", &none),
            STOSS_INVALID_INPUT);
  EXPECT_EQ(std::string(stoss_message()).rfind("first body mass: missing", 0), 0U) << stoss_message();
}

TEST(COpen, MakesPlatesOfLayers) {
  const std::string ball = R"({"first": {"kind": "sphere", "poisson": 0.3}, "against": )";
  CContact opened, made, coated, none;
  ASSERT_EQ(stoss_open((ball + R"({"kind": "plate", "thickness": 2, "young": 0.5}})").c_str(), &opened), STOSS_OK);
  CBody sphere, plate;
  ASSERT_EQ(stoss_sphere_make(0.3, 1.0, 1.0, 1.0, 0.0, &sphere), STOSS_OK);
  ASSERT_EQ(stoss_plate_make(2.0, 0.3, 0.5, 1.0, 0.0, &plate), STOSS_OK);
  ASSERT_EQ(stoss_pair_contact_make(sphere, plate, &made), STOSS_OK);
  EXPECT_EQ(at(opened, 0.1).restitution.value, at(made, 0.1).restitution.value);

  ASSERT_EQ(stoss_open((ball + R"({"kind": "plate", "layers": [{"thickness": 1}, {"young": 2}]}})").c_str(), &coated),
            STOSS_OK);
  EXPECT_EQ(stoss_open((ball + R"({"kind": "plate"}})").c_str(), &none), STOSS_INVALID_INPUT);
  EXPECT_EQ(std::string(stoss_message()).rfind("against thickness: missing", 0), 0U) << stoss_message();
}

TEST(COpen, TakesVibrationAlong) {
  const std::string ball = R"({"first": {"kind": "sphere", "poisson": 0.3})";
  CContact unexcited, excited;
  ASSERT_EQ(stoss_open((ball + "}").c_str(), &unexcited), STOSS_OK);
  ASSERT_EQ(stoss_open((ball + R"(,"vibration":[{"order":2,"index":0,"energy":0.1}]})").c_str(), &excited), STOSS_OK);
  const double expected =
      restitution_curve(RefinableContact(sphere(0.3)), {0.05},
                        {.each = {.tolerance = 1e-2, .absolute = 1e-6, .vibration = {{0, 2, 0, 0.1, 0.0}}}})[0]
          .restitution.value;
  EXPECT_EQ(at(excited, 0.05).restitution.value, expected);
  EXPECT_NE(at(unexcited, 0.05).restitution.value, expected);

  stoss_function* function = nullptr;
  EXPECT_EQ(stoss_function_make(excited, 0.01, 0.05, 1e-2, STOSS_BEYOND_ERROR, nullptr, &function),
            STOSS_INVALID_INPUT);
  EXPECT_STREQ(stoss_message(), "vibration: a function of the speed is of bodies that do not vibrate before");
}

TEST(COpen, RefusesWithALine) {
  stoss_contact* contact = nullptr;
  EXPECT_EQ(stoss_open(nullptr, &contact), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_open(steel_on_glass, nullptr), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_open("{", &contact), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_open(R"({"first": {"kind": "sphere", "poisson": 0.5}})", &contact), STOSS_INVALID_INPUT);
  EXPECT_STREQ(
      stoss_message(),
      "poisson: got 0.5, allowed -0.95 to 0.4999 (Poisson's ratio of the material; at 0.5 it would be incompressible)");
  EXPECT_EQ(contact, nullptr);
}

TEST(COpen, LetsAPartnerOfAFileYieldAsTheSphereOfItsCurvature) {
  const std::string ball = steel_ball("0.005"), yields = R"(, "yield_strength": 3e8)";
  CContact of_file, itself;
  ASSERT_EQ(stoss_open(meeting_of(ball, body_of_file("sphere", yields)).c_str(), &of_file), STOSS_OK)
      << stoss_message();
  ASSERT_EQ(stoss_open(meeting_of(ball, steel_ball("0.01", yields)).c_str(), &itself), STOSS_OK) << stoss_message();
  const double speed = 0.3 / stoss_speed_unit(itself);
  stoss_result found{}, exact{};
  ASSERT_EQ(stoss_curve(of_file, &speed, 1, 0.2, 1e-6, nullptr, &found), STOSS_OK) << stoss_message();
  ASSERT_EQ(stoss_curve(itself, &speed, 1, 0.2, 1e-6, nullptr, &exact), STOSS_OK) << stoss_message();
  EXPECT_LT(found.restitution.value, 0.7);
  EXPECT_NEAR(found.restitution.value, exact.restitution.value, found.restitution.error + exact.restitution.error);
  EXPECT_NEAR(found.restitution.value, exact.restitution.value, 2e-3);
}

}  // namespace
}  // namespace stoss
