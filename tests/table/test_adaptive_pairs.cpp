// Tables that find their speeds and ratios: honest errors, symmetries, one answer for any threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "stoss/restitution/restitution.hpp"
#include "stoss/table/adaptive_pairs.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

struct Case {
  std::string name;
  Mixture mixture;
  double slowest, fastest, smallest, greatest, error;
};

std::ostream& operator<<(std::ostream& out, const Case& each) { return out << each.name; }

double between(double low, double high, double share) { return low * std::pow(high / low, share); }

class AdaptivePairs : public testing::TestWithParam<Case> {};

TEST_P(AdaptivePairs, HaveHonestErrors) {
  const Case& c = GetParam();
  const PairTable table = pair_table(c.mixture, c.slowest, c.fastest, c.smallest, c.greatest, {.error = c.error});
  EXPECT_LE(table.greatest_error(), c.error);
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  constexpr int points = 30;
  int outside = 0;
  double worst = 0.0;
  for (int i = 0; i < points; ++i) {
    const double v = between(c.slowest, c.fastest, uniform(random));
    const double r = between(c.smallest, c.greatest, uniform(random));
    const Restitution direct = restitution(c.mixture.contact(r), v, {.tolerance = 1e-15, .absolute = 0.05 * c.error});
    const Estimate found = table(v, r);
    const double distance = std::abs(found.value - direct.restitution.value) / found.error;
    outside += distance > 1.0;
    worst = std::max(worst, distance);
  }
  EXPECT_LE(outside, points / 20);
  EXPECT_LT(worst, 3.0);
}

INSTANTIATE_TEST_SUITE_P(
    Mixtures, AdaptivePairs,
    testing::Values(Case{"disks", mixture(Disk{.poisson = 0.33}), 1e-3, 0.3, 1.0, 3.0, 1e-3},
                    Case{"disks_of_two_materials", mixture(Disk{.poisson = 0.33}, Disk{.poisson = 0.1, .young = 3.0}),
                         1e-2, 0.2, 0.5, 2.0, 2e-3},
                    Case{"spheres", mixture(Sphere{.poisson = 0.3}), 1e-3, 0.1, 1.0, 2.0, 2e-3},
                    Case{"spheres_of_two_materials",
                         mixture(Sphere{.poisson = 0.3}, Sphere{.poisson = 0.22, .young = 0.4, .density = 0.33}), 1e-3,
                         0.1, 0.7, 1.5, 2e-3}),
    [](const testing::TestParamInfo<Case>& each) { return each.param.name; });
INSTANTIATE_TEST_SUITE_P(Mixtures_long, AdaptivePairs,
                         testing::Values(Case{"disks_of_all_sizes", mixture(Disk{.poisson = 0.33}), 1e-2, 0.2, 0.05,
                                              20.0, 1e-2}),
                         [](const testing::TestParamInfo<Case>& each) { return each.param.name; });

TEST(AdaptivePair, OfOneMaterialHoldsRatiosFromOneOn) {
  const Mixture disks = mixture(Disk{.poisson = 0.33, .radius = 7.0});
  EXPECT_TRUE(disks.alike);
  const PairTableOptions options{.error = 0.05};
  const PairTable inverse = pair_table(disks, 0.05, 0.2, 1.0 / 3.0, 0.5, options);
  EXPECT_DOUBLE_EQ(inverse.values().ratios.front(), 2.0);
  EXPECT_DOUBLE_EQ(inverse.values().ratios.back(), 3.0);
  EXPECT_EQ(pair_table(disks, 0.05, 0.2, 2.0, 3.0, options).value(0.1, 2.5), inverse.value(0.1, 2.5));
  const PairTable both = pair_table(disks, 0.05, 0.2, 0.5, 1.5, options);
  EXPECT_EQ(both.values().ratios.front(), 1.0);
  EXPECT_EQ(both.values().ratios.back(), 2.0);
  for (const double r : {1.1, 1.9, 2.0}) EXPECT_NEAR(both.value(0.1, r), both.value(0.1, 1.0 / r), 1e-14);
}

TEST(AdaptivePair, HasTheSameBitsForAnyThreads) {
  PairTableOptions options{.error = 1e-2, .threads = 1};
  const PairTable one = pair_table(mixture(Disk{.poisson = 0.33}), 0.05, 0.3, 1.0, 1.5, options);
  options.threads = 3;
  const PairTable three = pair_table(mixture(Disk{.poisson = 0.33}), 0.05, 0.3, 1.0, 1.5, options);
  ASSERT_EQ(one.values().speeds, three.values().speeds);
  ASSERT_EQ(one.values().ratios, three.values().ratios);
  EXPECT_EQ(one.errors(), three.errors());
  EXPECT_EQ(one.nodes(), three.nodes());
}

TEST(AdaptivePair, SaysWhatCannotBe) {
  const Mixture disks = mixture(Disk{.poisson = 0.33});
  const auto refuse = [&](double slowest, double fastest, double smallest, double greatest,
                          const PairTableOptions& options, const std::vector<std::string>& parts) {
    test::expect_refusal([&] { (void)pair_table(disks, slowest, fastest, smallest, greatest, options); }, parts);
  };
  refuse(0.0, 0.1, 1.0, 2.0, {}, {"speed"});
  refuse(0.2, 0.1, 1.0, 2.0, {}, {"speed", "0.2", "0.1"});
  refuse(0.1, 0.2, 0.0, 2.0, {}, {"ratio"});
  refuse(0.1, 0.2, 2.0, 2.0, {}, {"ratio", "2"});
  refuse(0.1, 0.2, 1.0, 1e4, {}, {"ratio", "10000"});
  refuse(0.1, 0.2, 1.0, 2.0, {.error = 1e-9}, {"error", "1e-09"});
  refuse(0.1, 0.2, 1.0, 2.0, {.beyond = Beyond::law}, {"beyond", "law"});
  refuse(0.1, 0.2, 1.0, 2.0, {.threads = -1}, {"threads"});
  test::expect_refusal([] { (void)mixture(Disk{.poisson = 0.33, .loss_time = 0.1}); }, {"loss_time", "0.1"});
  test::expect_refusal([] { (void)pair_table(mixture(Disk{.poisson = 2.0}), 0.1, 0.2, 1.0, 2.0); }, {"poisson", "2"});
  const std::string many = test::message_of<NotConverged>(
      [&] { (void)pair_table(disks, 0.01, 0.2, 1.0, 3.0, {.error = 1e-4, .most_values = 100}); });
  EXPECT_NE(many.find("100"), std::string::npos) << many;
}

}  // namespace
}  // namespace stoss
