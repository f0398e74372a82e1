// Tables of the collision rule against rules that are computed afresh, at random places: any share of velocity and
// spins in what slides, also against each other.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <string>

#include "stoss/bodies/half_space.hpp"
#include "stoss/restitution/oblique.hpp"
#include "stoss/table/adaptive.hpp"
#include "stoss/table/adaptive_rule.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

struct RuleCase {
  std::string name;
  std::function<RefinableContact(double)> contact;  ///< of a ratio
  std::optional<Mixture> mixture{};
  double slowest = 0.0, fastest = 0.0;
  double second_radius = 0.0;  ///< 0: it does not turn
  RuleTableOptions options{};
};

void PrintTo(const RuleCase& each, std::ostream* stream) { *stream << each.name; }

RuleCase of_two(std::string name, const RefinableContact& contact, double slowest, double fastest, double second_radius,
                const RuleTableOptions& options) {
  return {std::move(name), [contact](double) { return contact; }, {}, slowest, fastest, second_radius, options};
}

std::vector<RuleCase> rule_cases() {
  const BodyMaker ball = sphere(0.3);
  return {of_two("ball", RefinableContact(ball), 1e-4, 1e-2, 0.0, {}),
          of_two("fast_ball", RefinableContact(ball), 1e-2, 0.1, 0.0, {.tolerance = 0.08})};
}

/// Impacts of disks share nothing; balls with balls are the mixture, too.
std::vector<RuleCase> long_cases() {
  const BodyMaker plate = disk(0.33), ball = sphere(0.3);
  const Mixture balls = mixture(Sphere{.poisson = 0.3});
  return {of_two("ball_on_block", RefinableContact(ball, half_space(HalfSpace{.poisson = 0.2})), 1e-3, 1e-2, 0.0,
                 {.tolerance = 0.05}),
          {"mixture", balls.contact, balls, 1e-3, 3e-3, 1.0, {.error = 2e-3, .tolerance = 0.05}},
          of_two("balls", RefinableContact(ball, ball), 1e-4, 1e-2, 1.0, {}),
          of_two("unequal_balls", RefinableContact(ball, sphere(Sphere{.poisson = 0.2, .radius = 2.0, .young = 3.0})),
                 1e-4, 1e-2, 2.0, {.tolerance = 0.05}),
          of_two("disks", RefinableContact(plate, plate), 3e-2, 0.1, 1.0, {.tolerance = 0.05}),
          of_two("disk", RefinableContact(plate), 3e-2, 0.1, 0.0, {.error = 5e-3, .tolerance = 0.05, .friction = 0.3})};
}

void expect_honest_errors(const RuleCase& c) {
  const RuleTable rule = c.mixture ? rule_table(*c.mixture, c.slowest, c.fastest, 0.8, 1.3, c.options)
                                   : rule_table(c.contact(1.0), c.slowest, c.fastest, c.options);
  EXPECT_LE(rule.greatest_restitution_error(), c.options.error);
  EXPECT_LE(rule.greatest_sliding_error(), c.options.tolerance);
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto either = [&] { return 2.0 * uniform(random) - 1.0; };
  constexpr int points = 20;
  int outside = 0;
  for (int i = 0; i < points; ++i) {
    const double v = c.slowest * std::pow(c.fastest / c.slowest, uniform(random));
    const double ratio = c.mixture ? 0.8 * std::pow(1.3 / 0.8, uniform(random)) : 1.0;
    const double friction = c.options.friction.value_or(0.01 + 0.3 * uniform(random)), limit = friction * v;
    const double radius = c.mixture ? ratio : c.second_radius;
    double velocity = either(), spin = either(), second = radius > 0.0 ? either() : 0.0;
    if (std::abs(velocity + spin + second) < 0.2) spin += 0.3;
    const double share = std::tan(1.5 * uniform(random)) * limit / (velocity + spin + second);
    velocity *= share, spin *= share, second *= share;
    const double most = std::abs(velocity) + std::abs(spin) + std::abs(second) + limit;  // what errors are over
    const double sliding = velocity + spin + second;
    const ObliqueOptions fresh{.tolerance = std::min(0.5, 0.1 * c.options.tolerance * most / std::max(sliding, limit))};
    const Obliquity before{velocity, spin, radius > 0.0 ? second / radius : 0.0, friction};
    const ObliqueRestitution direct = oblique_restitution(c.contact(ratio), v, before, fresh);
    const Rule found = rule(v, direct.sliding, friction, ratio);
    const double along = std::abs(found.sliding_after - direct.sliding_after.value) / most / found.sliding_error;
    const double normal = std::abs(found.restitution.value - direct.restitution.value) / found.restitution.error;
    outside += along > 1.0 || normal > 1.0;
    EXPECT_LT(std::max(along, normal), 3.0) << "v = " << v << ", s = " << sliding / limit << " mu v";
  }
  EXPECT_LE(outside, points / 20);
}

class AdaptiveRule : public testing::TestWithParam<RuleCase> {};
TEST_P(AdaptiveRule, HasHonestErrors) { expect_honest_errors(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Bodies, AdaptiveRule, testing::ValuesIn(rule_cases()),
                         [](const auto& each) { return each.param.name; });

class LongAdaptiveRule : public testing::TestWithParam<RuleCase> {};
TEST_P(LongAdaptiveRule, HasHonestErrors_long) { expect_honest_errors(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Bodies, LongAdaptiveRule, testing::ValuesIn(long_cases()),
                         [](const auto& each) { return each.param.name; });

TEST(AdaptiveRules, HaveTheFunctionOfHeadOnImpacts) {
  const RefinableContact balls(sphere(0.3), sphere(0.3));
  const RuleTable rule = rule_table(balls, 1e-3, 1e-2, {.tolerance = 0.1});
  const RestitutionFunction function = restitution_function(balls, 1e-3, 1e-2);
  for (const double v : {1e-3, 2.3e-3, 7e-3, 1e-2}) {
    const Estimate found = rule(v, 0.1, 0.2).restitution, expected = function(v);
    EXPECT_NEAR(found.value, expected.value, 1e-15);
    EXPECT_EQ(found.error, expected.error);
  }
}

TEST(AdaptiveRules, HaveTheSameBitsForAnyThreads) {
  RuleTableOptions options{.tolerance = 0.1, .threads = 1};
  const RefinableContact ball(sphere(0.3));
  const RuleTable one = rule_table(ball, 1e-3, 1e-2, options);
  options.threads = 3;
  const RuleTable three = rule_table(ball, 1e-3, 1e-2, options);
  EXPECT_EQ(one.sliding_nodes(), three.sliding_nodes());
  EXPECT_EQ(one.sliding_errors(), three.sliding_errors());
}

TEST(AdaptiveRules, SayWhatCannotBe) {
  const RefinableContact ball(sphere(0.3)), plate(disk(0.33)), plates(disk(0.33), disk(0.33));
  const auto refuse = [](const RefinableContact& contact, double slowest, double fastest,
                         const RuleTableOptions& options, const std::vector<std::string>& parts) {
    test::expect_refusal([&] { (void)rule_table(contact, slowest, fastest, options); }, parts);
  };
  refuse(ball, 0.01, 0.001, {}, {"speed"});
  refuse(ball, 0.001, 0.01, {.error = 1.0}, {"error: got 1"});
  refuse(ball, 0.001, 0.01, {.tolerance = 1e-6}, {"tolerance: got 1e-06"});
  refuse(ball, 0.001, 0.01, {.friction = 0.3}, {"friction: got 0.3, allowed none"});
  refuse(plates, 0.001, 0.01, {.friction = 0.3}, {"friction: got 0.3, allowed none"});
  refuse(plate, 0.001, 0.01, {}, {"friction: missing"});
  refuse(plate, 0.001, 0.01, {.friction = 6.0}, {"friction: got 6"});
  refuse(plate, 0.001, 0.2, {.friction = 1.0}, {"speed: got up to 0.2 c, allowed up to 0.11"});
  refuse(ball, 0.001, 0.01, {.beyond = Beyond::law}, {"beyond"});
  const std::string far = test::message_of<NotConverged>([&] { (void)rule_table(ball, 1e-3, 0.2); });
  EXPECT_NE(far.find("allow a larger tolerance, from 0."), std::string::npos) << far;
  const std::string many =
      test::message_of<NotConverged>([&] { (void)rule_table(ball, 1e-4, 1e-3, {.most_values = 100}); });
  EXPECT_NE(many.find("100"), std::string::npos) << many;
}

}  // namespace
}  // namespace stoss
