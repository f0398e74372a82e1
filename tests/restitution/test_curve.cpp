// Curves: many speeds, several threads, one answer.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/restitution/curve.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

std::vector<double> speeds(int count) {
  std::vector<double> result;
  for (int i = 0; i < count; ++i) result.push_back(1e-4 * std::pow(3e3, i / (count - 1.0)));
  return result;
}

TEST(Curve, HasTheSameBitsForAnyNumberOfThreads) {
  const auto one = restitution_curve(0.33, speeds(12), {.each = {.tolerance = 1e-2}, .threads = 1});
  for (const int threads : {2, 3, 64}) {
    const auto many = restitution_curve(0.33, speeds(12), {.each = {.tolerance = 1e-2}, .threads = threads});
    ASSERT_EQ(many.size(), one.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(many[i].restitution.value, one[i].restitution.value);
      EXPECT_EQ(many[i].lost_fraction.error, one[i].lost_fraction.error);
      EXPECT_EQ(many[i].finest.energy.unresolved, one[i].finest.energy.unresolved);
      EXPECT_EQ(many[i].steps, one[i].steps);
    }
  }
}

TEST(Curve, IsThePointsOneByOne) {
  const RefinableContact body{disk(0.9)};
  const auto curve = restitution_curve(body, {0.2, 0.01, 0.2}, {.each = {.tolerance = 3e-3}});
  ASSERT_EQ(curve.size(), 3U);
  for (const Restitution& point : curve) {
    const Restitution alone = restitution(body, point.finest.speed, {.tolerance = 3e-3});
    EXPECT_EQ(point.lost_fraction.value, alone.lost_fraction.value);
    EXPECT_TRUE(point.converged);
  }
  EXPECT_EQ(curve[1].finest.speed, 0.01);
  EXPECT_TRUE(restitution_curve(0.33, {}).empty());
}

TEST(Curve, IsObservedInOrderOnTheCallingThread) {
  std::vector<std::size_t> order;
  const auto here = std::this_thread::get_id();
  const auto observer = [&](std::size_t i, const Restitution& point) {
    EXPECT_EQ(std::this_thread::get_id(), here);
    EXPECT_EQ(point.finest.speed, speeds(9)[i]);
    order.push_back(i);
  };
  restitution_curve(RefinableContact(disk(0.33)), speeds(9), {.each = {.tolerance = 1e-2}, .threads = 4}, observer);
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(Curve, EndsSoonWhenPollOrObserverThrow) {
  struct Enough {};
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const auto poll = [&] {
    if (Clock::now() - begin > std::chrono::milliseconds(100)) throw Enough{};
  };
  // Each point alone takes seconds.
  EXPECT_THROW((void)restitution_curve(0.33, speeds(50),
                                       {.each = {.tolerance = 1e-9, .absolute = 0.0, .poll = poll}, .threads = 2}),
               Enough);
  EXPECT_LT(Clock::now() - begin, std::chrono::seconds(10));
  std::size_t seen = 0;
  const auto observer = [&](std::size_t i, const Restitution&) {
    seen = i;
    if (i == 2) throw Enough{};
  };
  EXPECT_THROW(restitution_curve(RefinableContact(disk(0.33)), speeds(50), {.each = {.tolerance = 1e-2}}, observer),
               Enough);
  EXPECT_EQ(seen, 2U);
}

TEST(Curve, GoesOnBeyondAPointThatDoesNotConverge) {
  const auto curve = restitution_curve(RefinableContact(rod()), {0.1, 0.2});
  ASSERT_EQ(curve.size(), 2U);
  for (const Restitution& point : curve) {
    EXPECT_FALSE(point.converged);
    EXPECT_FALSE(point.reason.empty());
    EXPECT_NEAR(point.restitution.value, 1.0, point.restitution.error);
  }
  // A body that no wall ever releases.
  const RefinableContact stuck([](double cutoff, const Poll&) {
    Body body = rod(cutoff);
    body.residual_compliance = [](const ContactPoints&, const Poll&) { return std::vector<double>{-1.0}; };
    return body;
  });
  const auto failed = restitution_curve(stuck, {0.1});
  ASSERT_EQ(failed.size(), 1U);
  EXPECT_TRUE(std::isnan(failed[0].restitution.value));
  EXPECT_FALSE(failed[0].converged);
  EXPECT_NE(failed[0].reason.find("positive definite"), std::string::npos);
  EXPECT_EQ(failed[0].finest.speed, 0.1);
}

TEST(Curve, RefusesBadInputBeforeItComputes) {
  int seen = 0;
  const auto observer = [&seen](std::size_t, const Restitution&) { ++seen; };
  test::expect_refusal(
      [&] {
        restitution_curve(RefinableContact(disk(0.33)), {0.1, 2.0}, {}, observer);
      },
      {"speed", "got 2,"});
  test::expect_refusal(
      [&] {
        restitution_curve(RefinableContact(disk(0.33)), {0.1, std::nan("")}, {}, observer);
      },
      {"speed", "nan"});
  test::expect_refusal(
      [&] { restitution_curve(RefinableContact(disk(0.33)), {0.1}, {.each = {.tolerance = 0.0}}, observer); },
      {"tolerance"});
  test::expect_refusal([&] { restitution_curve(RefinableContact(disk(0.33)), {0.1}, {.threads = -1}, observer); },
                       {"threads", "-1"});
  test::expect_refusal([&] { (void)restitution_curve(1.1, {0.1}); }, {"poisson", "1.1"});
  EXPECT_EQ(seen, 0);
}

}  // namespace
}  // namespace stoss
