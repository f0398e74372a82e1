// What a drop test shows: computed channels as they are, models on top, and how both go together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "prediction/touching.hpp"
#include "stoss/contact/elastic_plastic.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/encounter/materials.hpp"
#include "stoss/prediction/prediction.hpp"
#include "stoss/prediction/quantities.hpp"
#include "stoss/restitution/curve.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

Encounter read(const std::string& text) { return encounter_from_json(text); }

Encounter ball_on(const std::string& ball, const std::string& block, double radius = 0.005) {
  return read(R"({"first": {"kind": "sphere", "radius": )" + std::to_string(radius) + R"(, "material": ")" + ball +
              R"("}, "against": {"kind": "half-space", "material": ")" + block + R"("}})");
}

double sum(const Prediction& of) { return std::accumulate(of.shares.begin(), of.shares.end(), 0.0); }

/// A ball whose numbers are of no named material.
Encounter own(const std::string& more, const std::string& against = R"("wall")") {
  return read(R"({"first": {"kind": "sphere", "radius": 0.01, "material": {"young": 2e11, "poisson": 0.3,
                  "density": 7800)" +
              more + R"(}}, "against": )" + against + "}");
}

TEST(Predict, WithoutModelsIsTheComputedRestitution) {
  const std::string block = R"({"kind": "half-space", "material": {"young": 7e10, "poisson": 0.22, "density": 2500,
                               "loss_time": 2e-9}})";
  for (const Encounter& each : {own(R"(, "loss_time": 1e-9)"), own(R"(, "loss_time": 1e-9)", block), own("", block)}) {
    for (const Prediction& made : predict(each, {0.01, 1.0, 30.0})) {
      const Restitution computed = restitution(refinable(each), speed_in_c(each, made.speed), {.absolute = 1e-5});
      EXPECT_EQ(made.without_models.value, computed.restitution.value);
      EXPECT_NEAR(made.restitution.value, computed.restitution.value, 1e-9);
      EXPECT_NEAR(made.restitution.error, computed.restitution.error, 1e-8);
      EXPECT_EQ(made.by_models, 0.0);
      EXPECT_NEAR(made.share(Channel::material), computed.dissipated, 1e-8);
      EXPECT_NEAR(sum(made), computed.lost_fraction.value, 1e-8);
      EXPECT_EQ(made.share(Channel::yield), 0.0);
      EXPECT_EQ(made.share(Channel::adhesion), 0.0);
    }
  }
}

TEST(Predict, SharesAddUpAndTheSpreadHoldsTheValue_long) {
  for (const auto& [ball, block] : std::vector<std::pair<std::string, std::string>>{
           {"structural steel", "structural steel"}, {"rubber", "structural steel"}, {"brass", "glass"}}) {
    for (const Prediction& made : predict(ball_on(ball, block), {1e-3, 0.03, 1.0})) {
      EXPECT_NEAR(sum(made), 1.0 - made.restitution.value * made.restitution.value, 1e-9) << ball << made.speed;
      for (const double share : made.shares) EXPECT_GE(share, -1e-9) << ball << made.speed;
      EXPECT_LE(made.models_low, made.restitution.value);
      EXPECT_GE(made.models_high, made.restitution.value);
      EXPECT_LE(made.models_high, 1.0);
      EXPECT_LE(made.restitution.value, made.without_models.value + made.without_models.error + 1e-9);
      EXPECT_EQ(made.share(made.dominant), *std::max_element(made.shares.begin(), made.shares.end()));
      EXPECT_NEAR(made.rebound_height, made.restitution.value * made.restitution.value * made.drop_height, 1e-15);
    }
  }
}

TEST(Predict, YieldAloneIsThatOfItsLaw) {
  // At a rigid wall, where hardly any wave is raised.
  const Encounter ball = own(R"(, "yield_strength": 3e8)");
  const double onset = *thresholds(ball).yield;
  for (const double ratio : {0.5, 2.0, 20.0}) {
    const Prediction made = predict(ball, {ratio * onset}).front();
    const double expected = plastic_restitution(ratio);
    // The elasticity of the whole ball makes it a little less (YieldingImpact.TendsToTheWorksOfItsLaw).
    EXPECT_NEAR(made.restitution.value, expected, ratio < 1.0 ? 1e-4 : 0.02 * expected) << ratio;
    if (ratio < 1.0) continue;
    EXPECT_LT(made.restitution.value, expected) << ratio;
    EXPECT_EQ(made.dominant, Channel::yield);
    EXPECT_LT(made.models_low, made.models_high);
  }
}

TEST(Predict, AdhesionAloneIsThatOfItsLawAndSticks) {
  const Encounter dust = read(R"({"first": {"kind": "sphere", "radius": 1e-6, "material": {"young": 7e10,
                                  "poisson": 0.22, "density": 2200}}, "against": "wall"})");
  const PredictionOptions options{.work_of_adhesion = 0.1};
  const double sticking = thresholds(dust, options).sticking;
  for (const double ratio : {1.1, 3.0, 20.0}) {
    const Prediction made = predict(dust, {ratio * sticking}, options).front();
    EXPECT_NEAR(made.restitution.value, std::sqrt(1.0 - 1.0 / (ratio * ratio)), 2e-3) << ratio;
  }
  const Prediction stuck = predict(dust, {0.9 * sticking}, options).front();
  EXPECT_EQ(stuck.restitution.value, 0.0);
  EXPECT_EQ(stuck.dominant, Channel::adhesion);
  EXPECT_TRUE(std::isinf(stuck.contact_time));
  EXPECT_NEAR(sum(stuck), 1.0, 1e-9);
}

TEST(Predict, LossesTogetherAreNotTheirSumButNearlyWhereSmall) {
  const std::string block = R"({"kind": "half-space", "material": {"young": 7e10, "poisson": 0.22, "density": 2500}})";
  const auto lost = [](const Prediction& made) { return 1.0 - made.restitution.value * made.restitution.value; };
  const Encounter elastic = own("", block), yields = own(R"(, "yield_strength": 3e8)", block);
  const double onset = *thresholds(yields).yield;
  // Barely yielding: the sum.
  const double ratio = 1.05, slow = ratio * onset;
  const double plastic = 1.0 - std::pow(plastic_restitution(ratio), 2);
  const double both = lost(predict(yields, {slow}).front());
  const double waves = lost(predict(elastic, {slow}).front());
  EXPECT_NEAR(both, waves + plastic, 0.15 * (waves + plastic));
  // Far beyond: the softer contact radiates less than the elastic one, or yield has less to take; the whole ball is
  // stiffer than its law by itself.
  const Prediction fast = predict(yields, {50.0 * onset}).front();
  const double alone = 1.0 - std::pow(plastic_restitution(50.0), 2);
  EXPECT_LT(lost(fast), 1.01 * (lost(predict(elastic, {50.0 * onset}).front()) + alone));
  EXPECT_GT(lost(fast), alone);
}

TEST(Predict, SpreadOfYieldIsWhatItsLawLeavesOpen) {
  // 3 % of ε² up and 4 % down for Poisson's ratio, times what yield takes, and what the law leaves open: 1 % and more
  // of the smaller of what is left and what flow takes, in the errors of the engine alone.
  const Encounter ball = own(R"(, "yield_strength": 5e7)");
  Encounter given = own("");
  given.first.values["yield_strength"] = 5e7;
  const double onset = *thresholds(ball).yield;
  for (const double ratio : {3.0, 100.0, 1000.0}) {
    const Prediction made = predict(ball, {ratio * onset}, {.influences = false}).front();
    const double its = made.restitution.value, share = made.share(Channel::yield), square = its * its;
    const Restitution same = restitution(refinable(given), speed_in_c(given, ratio * onset), {.absolute = 1e-5});
    const double numerical = made.restitution.error * (std::sqrt(square + 2.0 * its * made.restitution.error) + its);
    const double open = made.models_high * made.models_high - square * (1.0 + 0.03 * share);
    EXPECT_GT(share, 0.1) << ratio;
    EXPECT_GT(open, 0.0099 * std::min(share, 1.0 - share)) << ratio;
    EXPECT_NEAR(open + numerical, same.lost_fraction.error, 0.01 * same.lost_fraction.error) << ratio;
    EXPECT_NEAR(made.models_low * made.models_low, square * (1.0 - 0.04 * share) - open, 1e-12) << ratio;
    EXPECT_EQ(made.by_models, std::max(made.models_high - its, its - made.models_low));
  }
  test::expect_refusal([&] { (void)predict(ball, {20000.0 * onset}); }, {"speed: got ", "1600 times"});
}

TEST(Predict, HasTheYieldOfTheImpact) {
  const std::string block = R"({"kind": "half-space", "material": {"young": 7e10, "poisson": 0.22, "density": 2500}})";
  const Encounter named = own(R"(, "yield_strength": 3e8)", block);
  Encounter given = own("", block);
  given.first.values["yield_strength"] = 3e8;
  const Prediction made = predict(named, {1.0}, {.influences = false}).front();
  const Restitution same = restitution(refinable(given), speed_in_c(given, 1.0), {.absolute = 1e-5});
  EXPECT_EQ(made.restitution.value, same.restitution.value);
  EXPECT_LT(made.restitution.error, 0.2 * same.restitution.error);  // what the law leaves open is among the models
  EXPECT_EQ(made.share(Channel::yield), same.yielded);
  EXPECT_EQ(predict(given, {1.0}, {.influences = false}).front().restitution.value, made.restitution.value);
}

TEST(Predict, SaysWhereOnlySoundSamplesReboundSo) {
  const auto said = [](const Encounter& of) {
    const Prediction made = predict(of, {0.1}, {.influences = false}).front();
    return std::count_if(made.warnings.begin(), made.warnings.end(), [](const std::string& each) {
      return each.find("sound, smooth, dry and uncracked") != std::string::npos;
    });
  };
  for (const char* each : {"glass", "ice", "granite"}) EXPECT_EQ(said(ball_on(each, each)), 1) << each;
  EXPECT_EQ(said(ball_on("ice", "granite")), 2);
  EXPECT_EQ(said(ball_on("bearing steel", "brass")), 0);
}

TEST(Predict, TakesPlatesOfLayersOfOneMaterial) {
  const Encounter plate = read(R"({"first": {"kind": "sphere", "radius": 0.005, "material": "glass"},
                                   "against": {"kind": "plate", "layers": [{"thickness": 0.01, "material": "glass"},
                                                                           {"thickness": 0.02, "material": "glass"}]}})");
  const Prediction made = predict(plate, {1.0}, {.influences = false}).front();
  EXPECT_NEAR(made.restitution.value, made.without_models.value, 1e-4);
  EXPECT_GT(made.share(Channel::material), 1e-3);
}

TEST(Predict, PropagatesConstantsOneAtATime) {
  const Encounter ball = own(R"(, "yield_strength": 3e8)");
  const double onset = *thresholds(ball).yield, speed = 30.0 * onset;
  const PredictionOptions options{.uncertainties = {{"yield_strength", 0.2}, {"young", 0.05}}};
  const Prediction made = predict(ball, {speed}, options).front();
  ASSERT_EQ(made.influences.size(), 2U);
  EXPECT_EQ(made.influences[0].constant, "yield_strength");
  const double stronger = predict(own(R"(, "yield_strength": 3.6e8)"), {speed}).front().restitution.value;
  EXPECT_NEAR(made.influences[0].change, stronger - made.restitution.value, 2e-3 * made.influences[0].change);
  EXPECT_GT(made.influences[0].change, 0.0);
  EXPECT_LT(made.influences[1].change, 0.0);
  EXPECT_NEAR(made.by_constants, std::hypot(made.influences[0].change, made.influences[1].change), 1e-15);
}

TEST(Predict, ElasticConstantsChangeWhatTheyChange) {
  // One impact of the finest resolution in place of a ladder: as good as both ladders.
  const std::string stiffer = R"({"kind": "half-space", "material": {"young": 7.7e10, "poisson": 0.22,
                                 "density": 2500}})";
  const std::string block = R"({"kind": "half-space", "material": {"young": 7e10, "poisson": 0.22, "density": 2500}})";
  const Prediction base = predict(own("", block), {1.0}, {.uncertainties = {{"against.young", 0.1}}}).front();
  const Prediction other = predict(own("", stiffer), {1.0}).front();
  EXPECT_NEAR(base.influences.front().change, other.restitution.value - base.restitution.value,
              base.without_models.error + other.without_models.error);
  EXPECT_GT(base.influences.front().change, 10.0 * base.without_models.error);
}

TEST(Predict, WarnsWithTheSpeedsAtWhichModelsMatter) {
  const Prediction made = predict(own(R"(, "yield_strength": 3e8)"), {5.0}).front();
  const auto has = [&made](const std::string& text) {
    return std::any_of(made.warnings.begin(), made.warnings.end(),
                       [&](const std::string& each) { return each.find(text) != std::string::npos; });
  };
  EXPECT_TRUE(has("yields above 0.00"));
  EXPECT_TRUE(has("no loss in the material of the first body"));
}

TEST(Predict, IsTheSameForAnyNumberOfThreads) {
  const std::vector<double> speeds{0.01, 0.1, 1.0};
  const auto one = predict(ball_on("glass", "structural steel"), speeds, {.threads = 1});
  const auto two = predict(ball_on("glass", "structural steel"), speeds, {.threads = 2});
  for (std::size_t i = 0; i < speeds.size(); ++i) EXPECT_EQ(one[i].restitution.value, two[i].restitution.value);
}

TEST(Predict, HasAQuantityForEachChannel) {
  const Prediction made = predict(own(""), {1.0}).front();
  std::string names;
  for (const auto& each : prediction_quantities()) {
    names += each.name + " ";
    (void)each.value(made);
  }
  for (const auto& channel : channel_names) EXPECT_NE(names.find(channel), std::string::npos);
}

TEST(Predict, RefusesWhatItsModelsDoNotKnow) {
  test::expect_refusal([&] { (void)predict(read(R"({"first": {"kind": "sphere", "poisson": 0.3}})"), {0.1}); },
                       {"material: missing"});
  test::expect_refusal(
      [&] {
        (void)predict(read(R"({"first": {"kind": "disk", "material": "structural steel", "radius": 1}})"), {1.0});
      },
      {"body: got a disk, allowed a sphere"});
  test::expect_refusal([&] { (void)predict(own(""), {-1.0}); }, {"speed: got -1"});
  test::expect_refusal([&] { (void)predict(own(""), {std::nan("")}); }, {"speed: got"});
  test::expect_refusal([&] { (void)predict(own(""), {1.0}, {.work_of_adhesion = -1.0}); }, {"adhesion: got -1"});
  test::expect_refusal(
      [&] {
        (void)predict(own(""), {1.0}, {.uncertainties = {{"colour", 0.1}}});
      },
      {"uncertainties: got 'colour'"});
  test::expect_refusal(
      [&] {
        (void)predict(own(""), {1.0}, {.uncertainties = {{"young", -0.1}}});
      },
      {"uncertainties young: got -0.1"});
  test::expect_refusal([&] { (void)predict(own(""), {1.0}, {.tolerance = 0.0}); }, {"tolerance"});
  EXPECT_TRUE(predict(own(""), {}).empty());
}

}  // namespace
}  // namespace stoss
