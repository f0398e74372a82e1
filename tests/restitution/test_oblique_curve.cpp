// Many collision rules: one answer for any number of threads and neighbours, central impacts without friction.
#include "stoss/restitution/oblique_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/restitution/quantities.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

std::vector<ObliqueCase> fan(double speed, int count) {
  std::vector<ObliqueCase> cases;
  for (int i = 0; i < count; ++i) cases.push_back({speed, {0.002 * i, -0.001 * i, 0.0, 0.2}});
  return cases;
}

void expect_same(const ObliqueRestitution& one, const ObliqueRestitution& other) {
  EXPECT_EQ(one.restitution.value, other.restitution.value);
  EXPECT_EQ(one.sliding_after.value, other.sliding_after.value);
  EXPECT_EQ(one.sliding_after.error, other.sliding_after.error);
  EXPECT_EQ(one.spin_after.value, other.spin_after.value);
  EXPECT_EQ(one.friction_loss.value, other.friction_loss.value);
  EXPECT_EQ(one.neglected.sliding_after, other.neglected.sliding_after);
  EXPECT_EQ(one.neglected.restitution, other.neglected.restitution);
  EXPECT_EQ(one.steps, other.steps);
}

TEST(ObliqueCurve, IsTheRulesOneByOneForAnyNumberOfThreads) {
  const RefinableContact ball{sphere(0.3)};
  std::vector<ObliqueCase> cases = fan(0.05, 40);  // more than one job has
  for (const ObliqueCase& each : fan(0.01, 3)) cases.push_back(each);
  const auto one = oblique_curve(ball, cases, {.threads = 1}), many = oblique_curve(ball, cases, {.threads = 3});
  ASSERT_EQ(one.size(), cases.size());
  ASSERT_EQ(many.size(), cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    EXPECT_EQ(one[i].speed, cases[i].speed);
    EXPECT_EQ(one[i].before.spin, cases[i].before.spin);
    expect_same(one[i], many[i]);
  }
  for (const std::size_t i : {7U, 35U, 41U}) {
    expect_same(one[i], oblique_restitution(ball, cases[i].speed, cases[i].before));
  }
}

TEST(ObliqueCurve, OfDisksComesInOrderAsItsRules) {
  const RefinableContact plate{disk(0.33)};
  const std::vector<ObliqueCase> cases{{0.2, {0.1, 0.0, 0.0, 0.3}}, {0.2, {0.2, 0.0, 0.0, 0.1}}};
  std::vector<std::size_t> order;
  oblique_curve(plate, cases, {.each = {.tolerance = 0.1}, .threads = 2}, [&](std::size_t i, const auto& result) {
    order.push_back(i);
    expect_same(result, oblique_restitution(plate, 0.2, cases[i].before, {.tolerance = 0.1}));
  });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1}));
}

TEST(ObliqueCurve, WithoutFrictionIsTheCentralImpact) {
  for (const RefinableContact& body :
       {RefinableContact(disk(0.33)), RefinableContact(sphere(0.3)), RefinableContact(rod())}) {
    const auto result = oblique_curve(body, {{0.1, {0.05, 0.0, 0.0, 0.0}}}).front();
    const Restitution central = best_restitution(body, 0.1, {});
    EXPECT_EQ(result.restitution.value, central.restitution.value);
    EXPECT_EQ(result.restitution.error, central.restitution.error);
    EXPECT_EQ(result.tangential_restitution.value, -1.0);
    EXPECT_EQ(result.sliding_after.error, 0.0);
    EXPECT_EQ(result.tangential_after.value, 0.05);
    EXPECT_TRUE(result.converged);
  }
}

TEST(ObliqueCurve, ARigidBallMeetsAnElasticOne) {
  const RefinableContact pair(rigid(sphere(0.3)), sphere(0.3));
  const auto result = oblique_restitution(pair, 0.02, {0.03, 0.0, 0.0, 0.1});  // it slides all the time
  EXPECT_TRUE(result.converged);
  const double change = 0.1 * (1.0 + result.restitution.value) * 3.5 * 0.02;
  EXPECT_NEAR(result.sliding_after.value, 0.03 - change, 5e-3 * change);  // arms are a little shorter than the radius
}

TEST(ObliqueCurve, AnglesAreFromTheNormal) {
  EXPECT_DOUBLE_EQ(tangential_at(45.0, 0.2), 0.2);
  EXPECT_DOUBLE_EQ(tangential_at(-60.0, 0.1), -0.1 * std::sqrt(3.0));
  EXPECT_EQ(tangential_at(0.0, 0.1), 0.0);
  for (const double angle : {90.0, -90.0, 91.0, std::nan("")}) {
    test::expect_refusal([&] { (void)tangential_at(angle, 0.1); }, {"angle: got ", "-90 to 90"});
  }
}

TEST(ObliqueCurve, RefusesBeforeItComputes) {
  const RefinableContact ball{sphere(0.3)}, bar{rod()};
  const auto refused = [](const RefinableContact& contact, const std::vector<ObliqueCase>& cases,
                          const ObliqueCurveOptions& options, const std::vector<std::string>& parts) {
    const auto compute = [&] {
      oblique_curve(contact, cases, options, [](std::size_t, const ObliqueRestitution&) { FAIL(); });
    };
    test::expect_refusal(compute, parts);
  };
  const ObliqueCase good{0.1, {0.1, 0.0, 0.0, 0.3}};
  refused(ball, {good, {2.0, good.before}}, {}, {"speed: got 2"});
  refused(ball, {good, {0.1, {1.5, 0.0, 0.0, 0.3}}}, {}, {"tangential: got 1.5"});
  refused(ball, {good, {0.1, {0.0, -2.0, 0.0, 0.3}}}, {}, {"spin: got -2"});
  refused(ball, {good, {0.1, {0.0, 0.0, 0.1, 0.3}}}, {}, {"second_spin: got one that is not 0", "only 0"});
  refused(ball, {good, {0.1, {0.0, 0.0, 0.0, 5.1}}}, {}, {"friction: got 5.1", "0 to 5"});
  refused(ball, {good}, {.each = {.tolerance = 1e-9}}, {"tolerance: got 1e-09"});
  refused(ball, {}, {.each = {.tolerance = 1.0}}, {"tolerance: got 1"});
  refused(ball, {good}, {.threads = -1}, {"threads: got -1"});
  refused(ball, {good}, {.each = {.vibration = {{.order = 99, .index = 0, .energy = 0.1}}}},
          {"vibration: got mode (99, 0)"});
  refused(bar, {good}, {}, {"friction: not available for 'rod"});
}

TEST(ObliqueCurve, QuantitiesHaveErrorsAndUnits) {
  const auto result = oblique_restitution(RefinableContact(sphere(0.3)), 0.05, {0.05, 0.0, 0.0, 0.2});
  for (const auto& each : oblique_quantities()) {
    const Value value = each.value(result);
    if (const auto* number = std::get_if<double>(&value)) {
      EXPECT_TRUE(std::isfinite(*number)) << each.name;
    }
    if (each.error) {
      EXPECT_TRUE(std::isfinite(each.error(result))) << each.name;
    }
    const bool turns = each.name.starts_with("spin") || each.name.starts_with("second_spin") || each.name == "cutoff";
    EXPECT_EQ(each.dimension == Dimension::frequency, turns) << each.name;
  }
  ObliqueRestitution none;
  for (const auto& each : oblique_quantities()) {
    if (each.name == "contact_time" || each.name == "cutoff" || each.name == "energy_error") {
      EXPECT_TRUE(std::isnan(std::get<double>(each.value(none)))) << each.name;
    }
  }
}

}  // namespace
}  // namespace stoss
