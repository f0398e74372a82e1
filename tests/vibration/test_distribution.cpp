// Distributions: one answer for any threads and parts, honest means and errors.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/vibration/distribution.hpp"
#include "stoss/vibration/quantities.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

const RefinableContact& ball() {
  static const RefinableContact contact(sphere(0.3));
  return contact;
}

const Spectrum& warm() {
  static const Spectrum spectrum = thermal(ball(), 0.01, 6.0);
  return spectrum;
}

void expect_same(const Sample& a, const Sample& b) {
  EXPECT_EQ(a.number, b.number);
  EXPECT_EQ(a.vibration, b.vibration);
  EXPECT_EQ(a.restitution.value, b.restitution.value);
  EXPECT_EQ(a.lost_fraction.error, b.lost_fraction.error);
  EXPECT_EQ(a.steps, b.steps);
}

TEST(Distribution, HasTheSameBitsForAnyThreadsAndParts) {
  DistributionOptions options{.samples = 24, .seed = 7, .error = 1e-2, .threads = 1};
  const auto one = restitution_distribution(ball(), 0.05, warm(), options);
  ASSERT_EQ(one.size(), 24U);
  for (const int threads : {2, 5}) {
    options.threads = threads;
    const auto many = restitution_distribution(ball(), 0.05, warm(), options);
    ASSERT_EQ(many.size(), one.size());
    for (std::size_t k = 0; k < one.size(); ++k) expect_same(many[k], one[k]);
  }
  options.first = 9;
  options.samples = 10;
  const auto part = restitution_distribution(ball(), 0.05, warm(), options);
  ASSERT_EQ(part.size(), 10U);
  for (std::size_t k = 0; k < part.size(); ++k) expect_same(part[k], one[k + 9]);
  options.seed = 8;
  EXPECT_NE(restitution_distribution(ball(), 0.05, warm(), options)[0].vibration, part[0].vibration);
}

TEST(Distribution, IsTheRestitutionOfEachSample) {
  const DistributionOptions options{.first = 3, .samples = 2, .seed = 5, .error = 1e-2};
  for (const Sample& sample : restitution_distribution(ball(), 0.05, warm(), options)) {
    const Vibration vibration = draw(warm(), 5, static_cast<std::uint64_t>(sample.number));
    const Restitution alone = restitution(ball(), 0.05, {.tolerance = 1e-15, .absolute = 1e-2, .vibration = vibration});
    EXPECT_EQ(sample.restitution.value, alone.restitution.value);
    EXPECT_EQ(sample.contact_time.error, alone.contact_time.error);
    EXPECT_TRUE(sample.converged);
    EXPECT_LE(sample.lost_fraction.error, 1e-2);
  }
}

TEST(Distribution, OfBodiesAtRestIsThatOfOneImpact) {
  const auto samples = restitution_distribution(ball(), 0.05, thermal(ball(), 0.0, 6.0), {.samples = 3});
  const Restitution at_rest = restitution(ball(), 0.05, {.tolerance = 1e-15, .absolute = 1e-3});
  for (const Sample& sample : samples) {
    EXPECT_EQ(sample.restitution.value, at_rest.restitution.value);
    EXPECT_EQ(sample.vibration, 0.0);
  }
  EXPECT_EQ(summary(samples).standard_deviation, 0.0);
}

TEST(Distribution, EndsWhenTheObserverThrowsAndIsObservedInOrder) {
  struct Enough {};
  long expected = 0;
  const auto here = std::this_thread::get_id();
  const auto observer = [&](const Sample& sample) {
    EXPECT_EQ(sample.number, expected++);
    EXPECT_EQ(std::this_thread::get_id(), here);
    if (sample.number == 4) throw Enough{};
  };
  EXPECT_THROW(restitution_distribution(ball(), 0.05, warm(), {.samples = 1000, .error = 1e-2}, observer), Enough);
  EXPECT_EQ(expected, 5);
  const auto poll = [] { throw Enough{}; };
  EXPECT_THROW((void)restitution_distribution(ball(), 0.05, warm(), {.samples = 1000, .poll = poll}), Enough);
}

TEST(Distribution, GoesOnBeyondSamplesThatDoNotConverge) {
  const RefinableContact bar{rod()};  // its errors fall with the first power of the cutoff
  const auto samples = restitution_distribution(bar, 0.1, thermal(bar, 0.1, 10.0), {.samples = 3, .error = 1e-6});
  ASSERT_EQ(samples.size(), 3U);
  for (const Sample& sample : samples) {
    EXPECT_FALSE(sample.converged);
    EXPECT_FALSE(sample.reason.empty());
    EXPECT_TRUE(std::isfinite(sample.restitution.value));
  }
  EXPECT_EQ(summary(samples).not_converged, 3);
}

TEST(Distribution, RefusesWhatItCannotMean) {
  const auto run = [](double speed, const Spectrum& spectrum, const DistributionOptions& options) {
    return [=] { (void)restitution_distribution(ball(), speed, spectrum, options); };
  };
  test::expect_refusal(run(0.0, warm(), {}), {"speed: got 0"});
  test::expect_refusal(run(std::nan(""), warm(), {}), {"speed: got nan"});
  test::expect_refusal(run(0.1, warm(), {.first = -1}), {"first: got -1"});
  test::expect_refusal(run(0.1, warm(), {.samples = 0}), {"samples: got 0", "1 to 1000000"});
  for (const double bad : {0.0, -1.0, 0.6, std::nan("")}) {
    test::expect_refusal(run(0.1, warm(), {.error = bad}), {"error: got", "1e-9 to 0.5"});
  }
  test::expect_refusal(run(0.1, warm(), {.threads = -1}), {"threads: got -1"});
  test::expect_refusal(run(0.1, {{1, 2, 0, 0.1}}, {}), {"body 1", "a wall has no modes"});
  test::expect_refusal(run(0.1, {{0, 2, 0, 0.1}, {0, 2, 0, 0.2}}, {}), {"mode (2, 0)", "twice"});
  test::expect_refusal(run(0.1, {{0, 2, 999, 0.1}}, {}), {"mode (2, 999)"});
  test::expect_refusal(run(0.1, {{0, 2, 0, 2e6}}, {}), {"energy", "0 to 1e6"});
}

TEST(Distribution, HasTheStatisticalErrorOfItsScatter) {
  // The means of 20 batches of 30 scatter by the error that each of them states, whatever the seed.
  constexpr int batches = 20, each = 30;
  double squares = 0.0, stated = 0.0;
  std::vector<double> means;
  for (int k = 0; k < batches; ++k) {
    const DistributionOptions options{.first = 1000L * k, .samples = each, .seed = k % 2 == 0 ? 3U : 4U, .error = 1e-2};
    const DistributionSummary batch = summary(restitution_distribution(ball(), 0.05, warm(), options));
    means.push_back(batch.restitution.value);
    stated += std::pow(batch.restitution.statistical_error, 2) / batches;
  }
  double mean = 0.0;
  for (const double value : means) mean += value / batches;
  for (const double value : means) squares += std::pow(value - mean, 2);
  // χ² of 19 degrees of freedom is within 5.4 … 43.8 in 99.8 %; the stated errors themselves scatter far less.
  EXPECT_GT(squares / stated, 5.4);
  EXPECT_LT(squares / stated, 43.8);
}

TEST(Distribution, HasTheNumericalErrorOfItsSamples_long) {
  DistributionOptions options{.samples = 40, .seed = 21, .error = 1e-2};
  const auto coarse = restitution_distribution(ball(), 0.05, warm(), options);
  options.error = 1e-5;
  const auto fine = restitution_distribution(ball(), 0.05, warm(), options);
  int within = 0;
  for (std::size_t k = 0; k < coarse.size(); ++k) {
    ASSERT_EQ(coarse[k].vibration, fine[k].vibration);
    ASSERT_TRUE(fine[k].converged);
    const double off = std::abs(coarse[k].lost_fraction.value - fine[k].lost_fraction.value);
    within += off <= coarse[k].lost_fraction.error + fine[k].lost_fraction.error ? 1 : 0;
    EXPECT_LE(off, 3.0 * coarse[k].lost_fraction.error);
  }
  EXPECT_GE(within, 38);  // 95 %
  const Mean rough = summary(coarse).lost_fraction, exact = summary(fine).lost_fraction;
  EXPECT_LE(std::abs(rough.value - exact.value), rough.numerical_error);
  EXPECT_GT(rough.numerical_error, 10.0 * exact.numerical_error);
  EXPECT_NEAR(rough.statistical_error, exact.statistical_error, 0.05 * exact.statistical_error);
}

TEST(DistributionSummary, CountsAndAveragesWhatHasAValue) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<Sample> samples(4);
  const double values[] = {0.9, 1.1, none, 1.0};
  for (std::size_t k = 0; k < 4; ++k) {
    const double e = values[k];
    samples[k].restitution = {e, 0.01 * static_cast<double>(k)};
    samples[k].lost_fraction = {1.0 - e * e, 0.02 * static_cast<double>(k)};
    samples[k].converged = k != 3;
  }
  const DistributionSummary all = summary(samples);
  EXPECT_EQ(all.samples, 3);
  EXPECT_EQ(all.missing, 1);
  EXPECT_EQ(all.not_converged, 1);
  EXPECT_DOUBLE_EQ(all.restitution.value, 1.0);
  EXPECT_DOUBLE_EQ(all.standard_deviation, 0.1);
  EXPECT_DOUBLE_EQ(all.restitution.statistical_error, 0.1 / std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(all.restitution.numerical_error, 0.04 / 3.0);
  EXPECT_NEAR(all.lost_fraction.value, (0.19 - 0.21) / 3.0, 1e-15);
  EXPECT_DOUBLE_EQ(all.lost_fraction.numerical_error, 0.08 / 3.0);
  EXPECT_EQ(all.least, 0.9);
  EXPECT_EQ(all.greatest, 1.1);
  EXPECT_DOUBLE_EQ(all.share_above_one, 1.0 / 3.0);
  EXPECT_TRUE(std::isinf(summary(std::span(samples).first(1)).standard_deviation));
  test::expect_refusal([&] { (void)summary(std::span(samples).subspan(2, 1)); }, {"samples"});
  test::expect_refusal([] { (void)summary({}); }, {"samples"});
  EXPECT_EQ(distribution_quantities()[3].name, "restitution");
  EXPECT_EQ(std::get<double>(distribution_quantities()[3].value(all)), all.restitution.value);
  EXPECT_EQ(sample_quantities()[2].error(samples[1]), 0.01);
}

}  // namespace
}  // namespace stoss
