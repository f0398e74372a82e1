// The table of inputs: what questions take besides who meets whom.
#include "stoss/encounter/inputs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "stoss/encounter/encounter.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

using test::message_of;

constexpr double infinity = std::numeric_limits<double>::infinity();

template <typename See>
void for_each_use(See see) {
  for (const Input& each : inputs()) {
    for (const Use& use : each.uses) see(each, use);
  }
}

TEST(Inputs, HaveOneRowForEachNameOfAQuestion) {
  std::set<std::pair<Question, std::string_view>> seen;
  for_each_use([&](const Input& each, const Use& use) {
    EXPECT_TRUE(seen.insert({use.question, each.name}).second) << each.name;
    EXPECT_EQ(&input(use.question, each.name), &each);
    EXPECT_EQ(each.use(use.question), &use);
  });
  for (const auto& [question, name] : questions()) {
    if (question == Question::calibrate) continue;  // its speeds are measured
    EXPECT_TRUE(seen.contains({question, "speed"})) << name;
    EXPECT_TRUE(seen.contains({question, "height"})) << name;
  }
}

TEST(Inputs, HaveASentenceARangeAndADefaultInsideOfIt) {
  for_each_use([](const Input& each, const Use& use) {
    EXPECT_GT(each.help.size(), 10U) << each.name;
    EXPECT_TRUE(each.help.front() >= 'A' && each.help.front() <= 'Z' && each.help.back() != '.') << each.help;
    EXPECT_LT(each.low, each.high) << each.name;
    EXPECT_FALSE(each.range.empty()) << each.name;
    EXPECT_FALSE(use.usual && use.needed) << each.name;
    if (use.usual) {
      EXPECT_NO_THROW(require(each, *use.usual, std::nullopt, UnitSystem::sphere)) << each.name;
    }
  });
}

TEST(Inputs, AreRefusedOutsideOfTheirRange) {
  for_each_use([](const Input& each, const Use&) {
    for (const double value : {std::nan(""), infinity, -infinity, each.low - 1.0, each.high + 1.0}) {
      if (value > each.low && value < each.high) continue;  // of any size
      try {
        require(each, value, std::nullopt, UnitSystem::sphere);
        ADD_FAILURE() << each.name << ' ' << value;
      } catch (const InvalidInput& refusal) {
        EXPECT_EQ(refusal.kind(), InvalidInput::Kind::out_of_range);
        EXPECT_EQ(refusal.name(), each.name);
        EXPECT_NE(refusal.allowed().find(each.range), std::string::npos) << refusal.what();
      }
    }
    if (!std::isfinite(each.low)) return;
    const auto at_the_end = [&] { require(each, each.low, std::nullopt, UnitSystem::sphere); };
    if (each.low_included) {
      EXPECT_NO_THROW(at_the_end()) << each.name;
    } else {
      EXPECT_THROW(at_the_end(), InvalidInput) << each.name;
    }
  });
}

TEST(Inputs, AreInUnitsOfTheFirstBodyWhereItHasAMaterial) {
  const Encounter ball_in_si{.first = {.kind = "sphere",
                                       .values = {{"radius", 0.005}},
                                       .material = Material{.young = 2e11, .poisson = 0.3, .density = 8000.0}}};
  const auto scales = si_scales(ball_in_si);
  ASSERT_TRUE(scales);
  const Input& speed = input(Question::restitution, "speed");
  EXPECT_DOUBLE_EQ(in_own_units(speed, 50.0, scales, UnitSystem::sphere_si), 0.01);
  EXPECT_EQ(in_own_units(speed, 0.01, std::nullopt, UnitSystem::sphere), 0.01);
  EXPECT_DOUBLE_EQ(in_own_units(input(Question::oblique, "spin"), 1e4, scales, UnitSystem::sphere_si), 0.01);
  EXPECT_DOUBLE_EQ(in_own_units(input(Question::bounce, "flight_time"), 1.0, scales, UnitSystem::sphere_si), 1e6);
  EXPECT_DOUBLE_EQ(in_own_units(input(Question::bounce, "gravity"), 10.0, scales, UnitSystem::sphere_si), 2e-9);
  EXPECT_DOUBLE_EQ(in_own_units(input(Question::restitution, "tolerance"), 0.01, scales, UnitSystem::sphere_si), 0.01);
  // The ends of a range in SI are of the range: no rounding leads beyond them.
  for (const double end : {speed.low, speed.high}) {
    EXPECT_EQ(in_own_units(speed, end * scales->speed, scales, UnitSystem::sphere_si), end);
  }
  EXPECT_EQ(message_of<InvalidInput>([&] { (void)in_own_units(speed, 6000.0, scales, UnitSystem::sphere_si); }),
            "speed: got 6000, allowed 5e-05 to 5000 m/s (speed of approach, along the normal, 1e-8 to 1 c)");
}

TEST(Inputs, OfASeriesAreRefusedAsTheyWereTypedOrToSixDigits) {
  const Input& speed = input(Question::restitution, "speed");
  const auto refused = [&](const char* text) {
    return message_of<InvalidInput>([&] { (void)series_in_own_units(speed, text, std::nullopt, UnitSystem::sphere); });
  };
  EXPECT_EQ(series_in_own_units(speed, "0.1,0.2", std::nullopt, UnitSystem::sphere), (std::vector{0.1, 0.2}));
  EXPECT_TRUE(refused("0.1,1.23456789").starts_with("speed: got 1.23456789, allowed 1e-8 to 1 c"));
  EXPECT_TRUE(refused("lin:0.5:1.5:4").starts_with("speed: got 1.16667 of 'lin:0.5:1.5:4', allowed 1e-8 to 1 c"));
}

TEST(Inputs, OfNoQuestionAreRefused) {
  test::expect_refusal([] { (void)input(Question::impact, "friction"); }, {"input", "friction"});
}

}  // namespace
}  // namespace stoss
