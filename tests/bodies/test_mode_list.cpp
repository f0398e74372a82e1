// The list that bodies::disk::modes returns: its order, its end at the cutoff, and what it refuses.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "stoss/bodies/disk/modes.hpp"
#include "support/refusal.hpp"

namespace stoss {
using namespace bodies::disk;

namespace {

class ModeList : public ::testing::TestWithParam<double> {};

TEST_P(ModeList, IsSortedByOrderThenFrequency) {
  const auto modes = bodies::disk::modes(GetParam(), 100.0);
  EXPECT_EQ(modes.front().order, 0);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    EXPECT_GT(modes[i].omega, 1.0);
    EXPECT_LE(modes[i].omega, 100.0);
    if (i == 0 || modes[i].order != modes[i - 1].order) {
      EXPECT_EQ(modes[i].index, 0);
      EXPECT_TRUE(i == 0 || modes[i].order == modes[i - 1].order + 1);
    } else {
      EXPECT_EQ(modes[i].index, modes[i - 1].index + 1);
      EXPECT_GT(modes[i].omega, modes[i - 1].omega);
    }
  }
}

TEST_P(ModeList, OfALowerCutoffIsTheLowerPartOfEveryOrder) {
  const auto low = bodies::disk::modes(GetParam(), 50.0);
  std::map<std::pair<int, int>, Mode> high;
  std::size_t below = 0;
  for (const Mode& mode : bodies::disk::modes(GetParam(), 100.0)) {
    high.emplace(std::pair{mode.order, mode.index}, mode);
    if (mode.omega <= 50.0) ++below;
  }
  EXPECT_EQ(low.size(), below);
  for (const Mode& mode : low) {
    const Mode& same = high.at({mode.order, mode.index});
    const double amplitude = std::max(same.radial, std::abs(same.tangential));
    EXPECT_NEAR(mode.omega / same.omega, 1.0, 1e-13);
    EXPECT_NEAR(mode.radial, same.radial, 1e-10 * amplitude);
    EXPECT_NEAR(mode.tangential, same.tangential, 1e-10 * amplitude);
  }
}

TEST_P(ModeList, EndsAtTheCutoffWhereverItLies) {
  // A cutoff just above or below a root decides whether this root is in.
  const auto modes = bodies::disk::modes(GetParam(), 12.0);
  for (std::size_t i = 0; i < modes.size(); i += 5) {
    const double omega = modes[i].omega;
    const auto contains = [&](double cutoff) {
      for (const Mode& mode : bodies::disk::modes(GetParam(), cutoff)) {
        if (mode.order == modes[i].order && mode.index == modes[i].index) return true;
      }
      return false;
    };
    EXPECT_TRUE(contains(omega * (1.0 + 1e-11))) << omega;
    if (omega > 2.0) {
      EXPECT_FALSE(contains(omega * (1.0 - 1e-11))) << omega;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Poisson, ModeList, ::testing::Values(-0.95, -0.5, 0.0, 0.33, 0.9, 0.995));

TEST(ModeListInput, RefusesPoissonNumbersOutOfRange) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const auto& [value, text] : std::vector<std::pair<double, std::string>>{{std::nan(""), "nan"},
                                                                               {infinity, "inf"},
                                                                               {-infinity, "-inf"},
                                                                               {1.0, "got 1,"},
                                                                               {-1.0, "got -1,"},
                                                                               {1.5, "got 1.5,"},
                                                                               {0.9951, "got 0.9951,"}}) {
    const double poisson = value;
    test::expect_refusal([&] { (void)bodies::disk::modes(poisson, 25.0); }, {"poisson", text, "-0.95 to 0.995"});
    test::expect_refusal([&] { (void)static_flexibility(poisson, 2); }, {"poisson", text, "-0.95 to 0.995"});
  }
}

TEST(ModeListInput, RefusesCutoffsOutOfRange) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const auto& [value, text] : std::vector<std::pair<double, std::string>>{
           {std::nan(""), "nan"}, {infinity, "inf"}, {0.0, "got 0,"}, {-3.0, "got -3,"}, {1e9, "got 1000000000,"}}) {
    const double cutoff = value;
    test::expect_refusal([&] { (void)bodies::disk::modes(0.33, cutoff); }, {"cutoff", text, "to 1000"});
  }
  // Below the lowest mode: the message gives its frequency.
  test::expect_refusal([] { (void)bodies::disk::modes(0.33, 1.2); }, {"cutoff", "got 1.2,", "1.43853"});
  test::expect_refusal([] { (void)bodies::disk::modes(0.9, 1.2); }, {"cutoff", "got 1.2,", "1.20715"});
  EXPECT_EQ(bodies::disk::modes(0.33, 1.43854).size(), 1U);
}

TEST(ModeListInput, RefusesNegativeOrders) {
  test::expect_refusal([] { (void)static_flexibility(0.33, -1); }, {"order", "got -1,"});
}

}  // namespace
}  // namespace stoss
