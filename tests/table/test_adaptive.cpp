// Functions to an error: against values computed directly between their knots.
#include "stoss/table/adaptive.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/curve.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

struct Meeting {
  std::string name;
  RefinableContact contact;
  double slowest, fastest;
  double least_error = 1e-4;
};

void PrintTo(const Meeting& meeting, std::ostream* stream) { *stream << meeting.name; }

std::vector<Meeting> meetings() {
  const BodyMaker ball = sphere(0.3);
  return {{"disk", RefinableContact(disk(0.33)), 1e-4, 0.3},
          {"sphere", RefinableContact(ball), 1e-3, 0.2},
          {"two_disks", RefinableContact(disk(0.33), disk(Disk{.poisson = 0.2, .radius = 2.0})), 1e-3, 0.3},
          {"half_space", RefinableContact(ball, half_space(HalfSpace{.poisson = 0.3})), 1e-3, 0.1},
          {"lossy_sphere", RefinableContact(sphere(Sphere{.poisson = 0.3, .loss_time = 0.1})), 1e-3, 0.1},
          // A wave front is a step, which no number of modes follows: rods do not reach 1e-4.
          {"two_rods", RefinableContact(rod(), rod(Rod{.length = 2.5})), 1e-4, 0.5, 1e-2}};
}

class Functions : public testing::TestWithParam<Meeting> {};

TEST_P(Functions, AreWithinTheirErrorOfValuesBetweenTheirKnots) {
  const auto& [name, contact, slowest, fastest, least] = GetParam();
  constexpr int points = 20;
  std::mt19937_64 random(11);
  for (const double error : {1e-2, 1e-3, 1e-4}) {
    if (error < least) continue;
    const RestitutionFunction function =
        restitution_function(contact, slowest, fastest, {.error = error, .threads = 2});
    EXPECT_LE(function.greatest_error(), error);
    EXPECT_EQ(function.slowest(), slowest);
    EXPECT_EQ(function.fastest(), fastest);
    std::vector<double> speeds;
    for (int i = 0; i < points; ++i) {
      const std::size_t k = random() % (function.values().speeds.size() - 1);
      const double left = function.values().speeds[k], right = function.values().speeds[k + 1];
      speeds.push_back(left * std::pow(right / left, 0.2 + 0.6 * 0x1p-64 * static_cast<double>(random())));
    }
    const auto direct =
        restitution_curve(contact, speeds, {.each = {.tolerance = 1e-15, .absolute = 0.1 * error}, .threads = 2});
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      const Estimate found = function(speeds[i]), exact = direct[i].restitution;
      const double distance = std::abs(found.value - exact.value) - exact.error;
      EXPECT_LE(distance, found.error) << "error " << error << ", v = " << speeds[i];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Adaptive, Functions, testing::ValuesIn(meetings()),
                         [](const auto& parameter) { return parameter.param.name; });

/// Maximum of the true over the stated error, between two speeds.
double worst_ratio(const RefinableContact& contact, double slowest, double fastest, double error, double from,
                   double to) {
  const RestitutionFunction function = restitution_function(contact, slowest, fastest, {.error = error, .threads = 2});
  EXPECT_LE(function.greatest_error(), error);
  constexpr int points = 25;
  std::vector<double> speeds;
  for (int i = 0; i < points; ++i) speeds.push_back(from * std::pow(to / from, (i + 0.5) / points));
  const auto direct =
      restitution_curve(contact, speeds, {.each = {.tolerance = 1e-15, .absolute = 0.1 * error}, .threads = 2});
  double worst = 0.0;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const Estimate found = function(speeds[i]);
    worst = std::max(worst, std::abs(found.value - direct[i].restitution.value) / found.error);
  }
  return worst;
}

TEST(AdaptiveFunction, IsWithinItsErrorWhereTheMiddleIsMetByChanceAtAnEnd) {
  // The first interval and its other half have one middle, which the interpolation meets: nothing but the next one
  // tells how far it is off between them.
  EXPECT_LE(worst_ratio(RefinableContact(sphere(-0.3)), 1e-3, 0.3, 1e-3, 1e-3, 1.3e-3), 1.0);
  const RefinableContact pair(sphere(0.3), sphere(Sphere{.poisson = 0.3, .radius = 0.4, .young = 0.2, .density = 3.0}));
  EXPECT_LE(worst_ratio(pair, 1e-3, 0.1, 1e-3, 1e-3, 1.3e-3), 1.0);
}

TEST(AdaptiveFunction, IsWithinItsErrorWhereItTurns) {
  EXPECT_LE(worst_ratio(RefinableContact(sphere(0.3)), 1e-4, 0.3, 1e-4, 0.038, 0.042), 1.0);
}

TEST(AdaptiveFunction, IsTheSameForAnyNumberOfThreads) {
  const auto with = [](int threads) {
    return restitution_function(RefinableContact(disk(0.33)), 1e-3, 0.3, {.error = 1e-3, .threads = threads});
  };
  const RestitutionFunction one = with(1), three = with(3);
  EXPECT_EQ(one.values().speeds, three.values().speeds);
  EXPECT_EQ(one.nodes(), three.nodes());
  EXPECT_EQ(one.errors(), three.errors());
}

TEST(AdaptiveFunction, PutsSpeedsWhereTheWaveNeedsThem) {
  const RefinableContact contact(sphere(0.3));
  const auto count = [&](double error) {
    return restitution_function(contact, 1e-5, 0.4, {.error = error}).values().speeds;
  };
  const std::vector<double> coarse = count(1e-2), fine = count(1e-4);
  EXPECT_LT(coarse.size(), 80U);
  EXPECT_GT(2 * fine.size(), 3 * coarse.size());
  // A slow sphere loses next to nothing: its wave matters only where it is fast.
  const auto above = [](const std::vector<double>& speeds) {
    return std::count_if(speeds.begin(), speeds.end(), [](double speed) { return speed > 1e-2; });
  };
  EXPECT_GT(above(fine), static_cast<long>(fine.size()) / 2);
}

TEST(AdaptiveFunction, SaysWhatItCannotDo) {
  const RefinableContact contact(disk(0.33));
  const auto make = [&](double slowest, double fastest, FunctionOptions options) {
    return [&contact, slowest, fastest, options] { (void)restitution_function(contact, slowest, fastest, options); };
  };
  const double nan = std::nan("");
  test::expect_refusal(make(0.1, 0.1, {}), {"range"});
  test::expect_refusal(make(0.2, 0.1, {}), {"range"});
  for (const double bad : {0.0, -0.1, nan, 2.0}) {
    test::expect_refusal(make(bad, 0.5, {}), {"speed"});
    test::expect_refusal(make(1e-3, bad, {}), {});
  }
  for (const double bad : {0.0, -1e-3, nan, 1e-9, 0.5})
    test::expect_refusal(make(0.01, 0.1, {.error = bad}), {"error"});
  test::expect_refusal(make(0.01, 0.1, {.most_speeds = 3}), {"most_speeds"});
  test::expect_refusal(make(0.01, 0.1, {.threads = -1}), {"threads"});
  test::expect_refusal(make(0.01, 0.1, {.beyond = Beyond::law}), {"beyond"});
  const std::string more = test::message_of<NotConverged>(make(1e-6, 0.5, {.most_speeds = 50, .threads = 2}));
  EXPECT_NE(more.find("more than 50 values"), std::string::npos) << more;
  const std::string finer = test::message_of<NotConverged>(make(0.2, 0.5, {.error = 1e-7, .threads = 2}));
  EXPECT_NE(finer.find("at speed"), std::string::npos) << finer;
}

TEST(AdaptiveFunction, EndsWithWhatItsPollThrows) {
  struct Enough {};
  int calls = 0;
  const FunctionOptions options{.error = 1e-5, .threads = 2, .poll = [&calls] {
                                  if (++calls > 3) throw Enough{};
                                }};
  EXPECT_THROW((void)restitution_function(RefinableContact(disk(0.33)), 1e-6, 0.5, options), Enough);
}

}  // namespace
}  // namespace stoss
