// Oblique impacts through the C interface are those of C++.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/oblique_curve.hpp"
#include "stoss/stoss.h"
#include "support/body_files.hpp"
#include "support/c_handles.hpp"

namespace stoss {
using namespace test;

namespace {

const std::string rough_balls =
    R"({"first": {"kind": "sphere", "poisson": 0.3}, "against": {"kind": "sphere", "radius": 2}})";

void expect_same(const stoss_estimate& in_c, const Estimate& expected) {
  EXPECT_EQ(in_c.value, expected.value);
  EXPECT_EQ(in_c.error, expected.error);
}

TEST(COblique, IsThatOfCpp) {
  CContact contact;
  ASSERT_EQ(stoss_open(rough_balls.c_str(), &contact), STOSS_OK) << stoss_message();
  constexpr double friction = 0.2;
  const std::array<stoss_obliquity, 3> asked{
      {{0.05, 0.02, 0.0, 0.01, friction}, {0.05, 0.0, 0.1, 0.0, friction}, {0.1, 0.0, 0.0, 0.0, friction}}};
  std::array<stoss_oblique_result, 3> results{};
  ASSERT_EQ(stoss_oblique(contact, asked.data(), asked.size(), STOSS_OBLIQUE_TOLERANCE, nullptr, results.data()),
            STOSS_OK)
      << stoss_message();
  std::vector<ObliqueCase> cases;
  for (const stoss_obliquity& each : asked) {
    cases.push_back({each.speed, {each.tangential, each.spin, each.second_spin, each.friction}});
  }
  const auto expected = oblique_curve({sphere(0.3), sphere(Sphere{.poisson = 0.3, .radius = 2.0})}, cases);
  for (std::size_t i = 0; i < results.size(); ++i) {
    EXPECT_EQ(results[i].before.speed, asked[i].speed);
    EXPECT_EQ(results[i].before.tangential, asked[i].tangential);
    EXPECT_EQ(results[i].before.spin, asked[i].spin);
    EXPECT_EQ(results[i].before.second_spin, asked[i].second_spin);
    EXPECT_EQ(results[i].before.friction, 0.2);
    EXPECT_EQ(results[i].sliding, expected[i].sliding);
    expect_same(results[i].restitution, expected[i].restitution);
    expect_same(results[i].tangential_restitution, expected[i].tangential_restitution);
    expect_same(results[i].sliding_after, expected[i].sliding_after);
    expect_same(results[i].tangential_after, expected[i].tangential_after);
    expect_same(results[i].spin_after, expected[i].spin_after);
    expect_same(results[i].second_spin_after, expected[i].second_spin_after);
    expect_same(results[i].friction_loss, expected[i].friction_loss);
    expect_same(results[i].vibration, expected[i].vibration);
    EXPECT_EQ(results[i].dundurs, expected[i].neglected.dundurs);
    EXPECT_EQ(results[i].coupling_restitution, expected[i].neglected.restitution);
    EXPECT_EQ(results[i].coupling_tangential_restitution, expected[i].neglected.tangential_restitution);
    EXPECT_EQ(results[i].coupling_sliding_after, expected[i].neglected.sliding_after);
    EXPECT_EQ(results[i].converged, 1);
  }
  EXPECT_EQ(results[2].tangential_restitution.error, infinity);  // nothing slides
}

TEST(COblique, ReadsCollisionsInTheUnitsOfTheContact) {
  CContact plain, steel;
  ASSERT_EQ(stoss_open(rough_balls.c_str(), &plain), STOSS_OK);
  stoss_obliquity read{};
  ASSERT_EQ(stoss_collision(plain, R"({"speed": 0.05, "angle": 45, "spin": 0.1, "friction": 0.2})", &read), STOSS_OK);
  EXPECT_EQ(read.speed, 0.05);
  EXPECT_NEAR(read.tangential, 0.05, 1e-15);
  EXPECT_EQ(read.spin, 0.1);
  EXPECT_EQ(read.second_spin, 0.0);
  EXPECT_EQ(read.friction, 0.2);
  ASSERT_EQ(stoss_open(R"({"first": {"kind": "sphere", "radius": 0.005, "material": "glass"}})", &steel), STOSS_OK);
  const double c = stoss_speed_unit(steel);
  ASSERT_EQ(stoss_collision(steel, R"({"speed": 2, "tangential": -1, "second_spin": 30})", &read), STOSS_OK);
  EXPECT_EQ(read.speed, 2.0 / c);
  EXPECT_EQ(read.tangential, -1.0 / c);
  EXPECT_NEAR(read.second_spin, 30.0 * 0.005 / c, 1e-15 * read.second_spin);
  EXPECT_EQ(stoss_collision(plain, R"({"speed": 5})", &read), STOSS_INVALID_INPUT);
  EXPECT_EQ(std::string(stoss_last_refusal().name), "speed");
  EXPECT_EQ(stoss_collision(plain, nullptr, &read), STOSS_INVALID_INPUT);
}

TEST(COblique, KeepsWhatMissesTheTolerance) {
  CContact contact;
  ASSERT_EQ(stoss_open(R"({"first": {"kind": "sphere", "poisson": 0.3}})", &contact), STOSS_OK);
  const std::array<stoss_obliquity, 2> asked{{{0.05, 0.5, 0.0, 0.0, 0.1}, {0.05, 0.005, 0.0, 0.0, 0.1}}};
  std::array<stoss_oblique_result, 2> results{};
  EXPECT_EQ(stoss_oblique(contact, asked.data(), 2, 1e-5, nullptr, results.data()), STOSS_NOT_CONVERGED);
  EXPECT_EQ(std::string(stoss_message()).rfind("obliquity 1: the tolerance asks for", 0), 0U) << stoss_message();
  EXPECT_EQ(results[0].converged, 1);
  EXPECT_EQ(results[1].converged, 0);
  EXPECT_GT(results[1].sliding_after.error, 0.0);
}

TEST(COblique, RefusesAndStops) {
  CContact bar, ball;
  ASSERT_EQ(stoss_open(R"({"first": {"kind": "rod"}})", &bar), STOSS_OK);
  ASSERT_EQ(stoss_open(R"({"first": {"kind": "sphere", "poisson": 0.3}})", &ball), STOSS_OK);
  const stoss_obliquity asked{0.05, 0.02, 0.0, 0.0, 0.1}, steep{0.05, 2.0, 0.0, 0.0, 0.1};
  stoss_oblique_result result{};
  const auto said = [&](const stoss_contact* contact, const stoss_obliquity* obliquity) {
    EXPECT_EQ(stoss_oblique(contact, obliquity, 1, 1e-2, nullptr, &result), STOSS_INVALID_INPUT);
    return std::string(stoss_message());
  };
  EXPECT_EQ(said(bar, &asked).rfind("friction: not available for 'rod", 0), 0U);
  EXPECT_EQ(said(ball, &steep).rfind("tangential: got 2", 0), 0U);
  EXPECT_EQ(said(nullptr, &asked), "contact: got NULL, allowed a pointer to it");
  EXPECT_EQ(said(ball, nullptr), "obliquities: got NULL, allowed a pointer to it");
  const stoss_control control{1, [](void*) { return 1; }, nullptr};
  EXPECT_EQ(stoss_oblique(ball, &asked, 1, 1e-2, &control, &result), STOSS_INTERRUPTED);
  EXPECT_EQ(result.before.speed, 0.0);  // as it was
}

TEST(COblique, TakesBodiesOfFilesWithATangent) {
  const std::string ball = R"({"first": {"kind": "sphere", "radius": 0.005, "material": "bearing steel"}, "against": )";
  CContact beam, bell;
  ASSERT_EQ(stoss_open((ball + body_of_file("beam_0") + "}").c_str(), &beam), STOSS_OK) << stoss_message();
  const double speed = 0.5 / stoss_speed_unit(beam);
  const std::array<stoss_obliquity, 2> asked{{{speed, speed, 0.0, 0.0, 0.2}, {speed, -speed, 0.0, 0.0, 0.2}}};
  std::array<stoss_oblique_result, 2> results{};
  ASSERT_EQ(stoss_oblique(beam, asked.data(), asked.size(), STOSS_OBLIQUE_TOLERANCE, nullptr, results.data()), STOSS_OK)
      << stoss_message();
  EXPECT_EQ(results[0].sliding_after.value, -results[1].sliding_after.value);
  // All slides at 45°: Coulomb's law takes 3.5 of the ball and some of the beam, over the impulse of the normal impact.
  const double slid = (results[0].sliding - results[0].sliding_after.value) / (0.2 * speed);
  EXPECT_GT(slid, 3.4 * (1.0 + results[0].restitution.value));
  EXPECT_LT(slid, 3.5 * (1.0 + results[0].restitution.value));
  ASSERT_EQ(stoss_open((ball + body_of_file("bell") + "}").c_str(), &bell), STOSS_OK) << stoss_message();
  EXPECT_EQ(stoss_oblique(bell, asked.data(), 1, STOSS_OBLIQUE_TOLERANCE, nullptr, results.data()),
            STOSS_INVALID_INPUT);
  EXPECT_EQ(std::string(stoss_message()).rfind("friction: got 'bell' without tangential data", 0), 0U)
      << stoss_message();
}

}  // namespace
}  // namespace stoss
