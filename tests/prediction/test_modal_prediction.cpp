// Predictions of bodies of files that yield: those of a sphere of the same curvature, in which the dent takes nearly
// all.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "stoss/encounter/document.hpp"
#include "stoss/prediction/prediction.hpp"
#include "support/body_files.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace modal_predictions {
namespace {

using test::body_of_file;
using test::meeting_of;
using test::steel_ball;

constexpr const char* yields = R"(, "yield_strength": 3e8)";

/// A file that is struck, or is met, and in its place the sphere of which it is a mesh.
std::vector<std::pair<Encounter, Encounter>> pairs() {
  const std::string of_file = body_of_file("sphere", yields), itself = steel_ball("0.01", yields);
  std::vector<std::pair<Encounter, Encounter>> all;
  const auto add = [&all](const std::string& found, const std::string& exact) {
    all.emplace_back(encounter_from_json(found), encounter_from_json(exact));
  };
  add(meeting_of(steel_ball("0.005"), of_file), meeting_of(steel_ball("0.005"), itself));
  add(meeting_of(of_file, R"("wall")"), meeting_of(itself, R"("wall")"));
  add(meeting_of(of_file, R"("same")"), meeting_of(itself, R"("same")"));
  return all;
}

TEST(ModalPrediction, IsThatOfTheSphereWhereItYields) {
  for (const auto& [of_file, itself] : pairs()) {
    EXPECT_NEAR(*yield_speed(of_file), *yield_speed(itself), 1e-4 * *yield_speed(itself));
    const std::vector<double> speeds{0.01, 0.5};
    const auto found = predict(of_file, speeds), exact = predict(itself, speeds);
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      // Beside the models, both leave the grid of the dent open.
      const double errors = found[i].restitution.error + exact[i].restitution.error + 0.01 * exact[i].by_models;
      EXPECT_NEAR(found[i].restitution.value, exact[i].restitution.value, errors) << i;
      EXPECT_NEAR(found[i].share(Channel::yield), exact[i].share(Channel::yield), 2e-3) << i;
      EXPECT_NEAR(found[i].by_models, exact[i].by_models, 0.01 * exact[i].by_models) << i;
      EXPECT_EQ(found[i].dominant, Channel::yield);
    }
  }
}

// What the errors of a file change is in the numerical error, though the doubt of the law of yield is far larger.
TEST(ModalPrediction, CarriesTheErrorOfTheCompliance) {
  const std::string file = body_of_file("sphere", yields), key = R"("compliance_error": )";
  const std::size_t place = file.find(key) + key.size(), end = file.find(',', place);
  ASSERT_LT(place, end);
  std::string worse = file;
  worse.replace(place, end - place, std::to_string(6.15e12 * std::stod(file.substr(place))) + "e-12");
  const auto error = [](const std::string& body) {
    return predict(encounter_from_json(meeting_of(steel_ball("0.005"), body)), {0.2}).front().restitution.error;
  };
  EXPECT_GT(error(worse), 4.0 * error(file));
  EXPECT_LT(error(worse), 8.0 * error(file));
}

TEST(ModalPrediction, ChangesWithItsConstantsAsThatOfTheSphere) {
  const auto [of_file, itself] = pairs()[1];
  const PredictionOptions options{.uncertainties = {{"young", 0.1}, {"density", 0.1}, {"yield_strength", 0.1}}};
  const auto found = predict(of_file, {0.5}, options).front(), exact = predict(itself, {0.5}, options).front();
  ASSERT_EQ(found.influences.size(), 3U);
  ASSERT_EQ(exact.influences.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(found.influences[i].constant, exact.influences[i].constant);
    EXPECT_NEAR(found.influences[i].change, exact.influences[i].change, 0.05 * std::abs(exact.influences[i].change));
  }
}

TEST(ModalPrediction, IsOfNoSoftWall) {
  const std::string wall = R"({"kind": "exponential", "hardness": 300})";
  const Encounter encounter = encounter_from_json(meeting_of(body_of_file("sphere", yields), wall));
  test::expect_refusal([&] { (void)predict(encounter, {0.5}); },
                       {"against", "exponential", "half-space, plate or modal"});
}

TEST(ModalPrediction, IsATable) {
  const auto [of_file, itself] = pairs().front();
  const double slow = speed_in_c(itself, 0.05), fast = speed_in_c(itself, 0.5);
  const RestitutionFunction found = predicted_function(of_file, slow, fast, {.error = 1e-2}).function;
  const RestitutionFunction exact = predicted_function(itself, slow, fast, {.error = 1e-2}).function;
  for (const double speed : {slow, 2.0 * slow, 5.0 * slow, fast}) {
    EXPECT_NEAR(found(speed).value, exact(speed).value, 2e-3);
  }
}

}  // namespace
}  // namespace modal_predictions
}  // namespace stoss
