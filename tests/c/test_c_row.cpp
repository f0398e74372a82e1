// Rows of bodies through the C interface.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "stoss/encounter/row.hpp"
#include "stoss/stoss.h"

namespace stoss {
namespace {

constexpr const char* cradle =
    R"({"bodies": [{"kind": "sphere", "poisson": 0.3}, {"kind": "sphere"}, {"kind": "sphere"}]})";
constexpr const char* of_glass = R"({"bodies": [{"kind": "sphere", "radius": 0.01, "material": "glass"},
  {"kind": "sphere", "radius": 0.02, "material": "glass"}], "after": "wall"})";

TEST(CRow, IsThatOfTheLibraryInTheUnitOfTheSpeeds) {
  for (const char* json : {cradle, of_glass}) {
    const GivenRow given = row_from_json(json);
    const double unit = speed_unit(first_of(given));
    std::vector<double> speeds(given.bodies.size());
    speeds.front() = 1e-3 * unit;
    std::array<stoss_estimate, 3> found{};
    ASSERT_EQ(stoss_row(json, speeds.data(), speeds.size(), 1e-3, nullptr, found.data()), STOSS_OK) << stoss_message();
    const RowResult same = row(given, speeds);
    for (std::size_t b = 0; b < speeds.size(); ++b) {
      EXPECT_EQ(found[b].value, unit * same.velocities_after[b].value);
      EXPECT_EQ(found[b].error, unit * same.velocities_after[b].error);
    }
  }
}

TEST(CRow, RefusesInOneLine) {
  const std::array<double, 3> speeds{0.1, 0.0, 0.0};
  std::array<stoss_estimate, 3> found{};
  const auto status = [&](const char* json, const double* of, size_t count, double tolerance) {
    return stoss_row(json, of, count, tolerance, nullptr, found.data());
  };
  EXPECT_EQ(status(nullptr, speeds.data(), 3, 1e-3), STOSS_INVALID_INPUT);
  EXPECT_EQ(status(cradle, nullptr, 3, 1e-3), STOSS_INVALID_INPUT);
  EXPECT_EQ(status(cradle, speeds.data(), 2, 1e-3), STOSS_INVALID_INPUT);
  EXPECT_STREQ(stoss_last_refusal().name, "count");
  EXPECT_EQ(status(cradle, speeds.data(), 3, std::nan("")), STOSS_INVALID_INPUT);
  EXPECT_STREQ(stoss_last_refusal().name, "tolerance");
  const std::array<double, 3> none{0.0, 0.0, 0.0}, wrong{0.1, std::nan(""), 0.0};
  EXPECT_EQ(status(cradle, none.data(), 3, 1e-3), STOSS_INVALID_INPUT);
  EXPECT_EQ(status(cradle, wrong.data(), 3, 1e-3), STOSS_INVALID_INPUT);
  EXPECT_STREQ(stoss_last_refusal().name, "speed");
  EXPECT_EQ(status(R"({"bodies": []})", speeds.data(), 3, 1e-3), STOSS_INVALID_INPUT);
  EXPECT_EQ(status(R"({"bodies": [{"kind": "sphere", "poisson": 0.3}], "after": "ice"})", speeds.data(), 1, 1e-3),
            STOSS_INVALID_INPUT);
}

TEST(CRow, EndsAtThePoll) {
  const std::array<double, 3> speeds{1e-8, 0.0, 0.0};
  std::array<stoss_estimate, 3> found{};
  const stoss_control control{1, [](void*) { return 1; }, nullptr};
  EXPECT_EQ(stoss_row(cradle, speeds.data(), 3, 1e-6, &control, found.data()), STOSS_INTERRUPTED);
}

}  // namespace
}  // namespace stoss
