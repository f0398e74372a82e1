// Detailed balance of impacts without losses. A point of phase space with approaching bodies passes the distance of the
// start at a rate v: the flux of states there is v dp Π dQ_k dP_k = dE Π dE_k dφ_k, with E = ½μv² and mode energies
// E_k. Motion keeps the measure of phase space (Liouville), so an impact maps the flux of approaching states to an
// equal one of parting states, at the same total energy. Hence E and E_k that are exponential with one mean kT before
// are so after; and at fixed total energy they are uniform on the simplex, where a share of N + 1 has the cdf 1 − (1 −
// x)^N.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "numeric/random.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/vibration.hpp"
#include "support/disk_pairs.hpp"

namespace stoss {
namespace {

constexpr int samples = 1200;
constexpr double hot = 0.2;                  // c: ½μ hot² = kT
constexpr double in_standard_errors = 3.29;  // two-sided, 99.9 %
constexpr double kolmogorov = 1.95;          // 99.9 % of √n D

struct Ensemble {
  std::string name;
  std::function<Contact()> contact;
};

void PrintTo(const Ensemble& its, std::ostream* out) { *out << its.name; }

/// Energies, in any one unit, of the translation before and after an impact, and of all.
struct Exchange {
  double before, after, all;
};

class DetailedBalance : public ::testing::TestWithParam<Ensemble> {
 protected:
  const Contact contact = GetParam().contact();
  const int modes = static_cast<int>(mode_count(contact));
  // One resolution for all samples: only then they share one map.
  const ImpactOptions lossless{.resolution = {.step = 0.08 / contact.cutoff,
                                              .nodes = 24,
                                              .half_width = 0.9 * greatest_half_width(contact),
                                              .tail = Tail::quasistatic}};

  /// All modes, of the order of the contact; energies relative to the translation.
  [[nodiscard]] Vibration all_modes(const std::vector<double>& energies, const std::vector<double>& phases) const {
    Vibration vibration;
    std::size_t k = 0;
    for (std::size_t g = 0; g < contact.groups.size(); ++g) {
      const ModeGroup& group = contact.groups[g];
      for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
        const int index = group.index.empty() ? static_cast<int>(l) : group.index[l];
        vibration.push_back({g < contact.first_groups ? 0 : 1, group.order, index, energies[k], phases[k]});
      }
    }
    return vibration;
  }

  /// Sample of an ensemble with modes at a temperature, that of the translation being 1: at a fixed mean or, where
  /// `total` is above 0, at a fixed sum of all energies.
  [[nodiscard]] Exchange exchange(int sample, double temperature, double total) const {
    std::vector<double> energies, phases;
    double sum = 0.0;
    for (int k = 0; k <= modes; ++k) {
      const auto [u, phase] =
          numeric::uniform(16, {static_cast<std::uint32_t>(sample), static_cast<std::uint32_t>(k), 0, 0});
      energies.push_back(-(k < modes ? temperature : 1.0) * std::log(u));
      phases.push_back(2.0 * std::numbers::pi * phase);
      sum += energies.back();
    }
    const double translation = total > 0.0 ? energies.back() * total / sum : energies.back();
    const double all = total > 0.0 ? total : sum;
    const double speed = hot * std::sqrt(translation);
    for (double& energy : energies) energy /= energies.back();
    ImpactOptions options = lossless;
    options.start = approach(contact, speed, all_modes(energies, phases));
    const Impact result = impact(contact, speed, options);
    EXPECT_NEAR(result.energy_error, 0.0, 2e-3);
    return {translation, translation * result.restitution * result.restitution, all};
  }

  [[nodiscard]] std::vector<Exchange> exchanges(double temperature, double total) const {
    std::vector<Exchange> all;
    for (int k = 0; k < samples; ++k) all.push_back(exchange(k, temperature, total));
    return all;
  }
};

/// Mean gain of the translation, in its standard errors.
double mean_gain(const std::vector<Exchange>& exchanges) {
  double mean = 0.0, squares = 0.0;
  const auto count = static_cast<double>(exchanges.size());
  for (const Exchange& each : exchanges) mean += (each.after - each.before) / count;
  for (const Exchange& each : exchanges) squares += std::pow(each.after - each.before - mean, 2);
  return mean / std::sqrt(squares / (count - 1.0) / count);
}

/// √n times the maximum distance of the empirical distribution from a cdf.
double distance(std::vector<double> values, const std::function<double(double)>& cdf) {
  std::sort(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  double greatest = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double expected = cdf(values[i]), below = static_cast<double>(i) / count;
    greatest = std::max({greatest, expected - below, below + 1.0 / count - expected});
  }
  return greatest * std::sqrt(count);
}

/// The same of two independent samples.
double distance(std::vector<double> one, std::vector<double> other) {
  std::sort(one.begin(), one.end());
  std::sort(other.begin(), other.end());
  const auto n = static_cast<double>(one.size()), m = static_cast<double>(other.size());
  double greatest = 0.0;
  for (const double value : one) {
    const auto below = std::upper_bound(one.begin(), one.end(), value) - one.begin();
    const auto others = std::upper_bound(other.begin(), other.end(), value) - other.begin();
    greatest = std::max(greatest, std::abs(static_cast<double>(below) / n - static_cast<double>(others) / m));
  }
  return greatest * std::sqrt(n * m / (n + m));
}

TEST_P(DetailedBalance, EveryImpactCanBeReversed) {
  for (int k = 0; k < 20; ++k) {
    std::vector<double> energies, phases;
    for (int mode = 0; mode < modes; ++mode) {
      const auto [u, phase] =
          numeric::uniform(1, {static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(mode), 0, 0});
      energies.push_back(-std::log(u));
      phases.push_back(2.0 * std::numbers::pi * phase);
    }
    ImpactOptions options = lossless;
    options.start = approach(contact, hot, all_modes(energies, phases));
    const Impact forth = impact(contact, hot, options);
    State reversed = forth.final_state;
    reversed.velocity = -reversed.velocity;
    for (double& momentum : reversed.momentum) momentum = -momentum;
    options.start = reversed;
    const Impact back = impact(contact, reversed.velocity, options);
    // To what a contact is solved to, enlarged by the motion.
    EXPECT_NEAR(back.restitution * forth.restitution, 1.0, 1e-6);
    const double translation = 0.5 * contact.mass * hot * hot;
    const std::vector<double> returned = mode_energies(contact, back.final_state);
    for (std::size_t mode = 0; mode < returned.size(); ++mode) {
      EXPECT_NEAR(returned[mode] / translation, energies[mode], 1e-6);
    }
  }
}

TEST_P(DetailedBalance, NoEnergyFlowsBetweenTranslationAndVibrationOfOneTemperature) {
  EXPECT_LT(std::abs(mean_gain(exchanges(1.0, 0.0))), in_standard_errors);
  // The same test sees a difference in temperature, of either sign.
  EXPECT_LT(mean_gain(exchanges(0.5, 0.0)), -in_standard_errors);
  EXPECT_GT(mean_gain(exchanges(2.0, 0.0)), in_standard_errors);
}

TEST_P(DetailedBalance, KeepsTheMicrocanonicalDistributionAndItsReversal) {
  const auto all = exchanges(1.0, 0.5 * (modes + 1.0));
  const auto uniform = [this](double share) { return 1.0 - std::pow(1.0 - share, modes); };
  std::vector<double> before, after;
  for (const Exchange& each : all) {
    before.push_back(each.before / each.all);
    after.push_back(each.after / each.all);
  }
  EXPECT_LT(distance(before, uniform), kolmogorov);
  EXPECT_LT(distance(after, uniform), kolmogorov);

  // From little to anything is as frequent as from anything to little: each half of the samples for one of them.
  const double little = 1.0 - std::pow(0.5, 1.0 / modes);
  std::vector<double> forth, back;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % 2 == 0 && before[i] < little) forth.push_back(after[i]);
    if (i % 2 == 1 && after[i] < little) back.push_back(before[i]);
  }
  EXPECT_LT(distance(forth, back), kolmogorov);
  // Those that began with little are not those that ended with anything.
  EXPECT_GT(distance(forth, after), kolmogorov);

  // A translation twice as hot is seen, before and after.
  std::vector<double> too_fast;
  for (const Exchange& each : exchanges(0.5, 0.5 * (modes + 1.0))) too_fast.push_back(each.after / each.all);
  EXPECT_GT(distance(too_fast, uniform), kolmogorov);
}

INSTANTIATE_TEST_SUITE_P(
    All, DetailedBalance,
    ::testing::Values(Ensemble{"disk", [] { return contact(disk(0.33, 4.0)); }},
                      Ensemble{"soft_disk", [] { return contact(disk(0.8, 3.0)); }},
                      Ensemble{"sphere", [] { return contact(sphere(0.3, 4.0)); }},
                      Ensemble{"pair",
                               [] { return test::pair_of(Disk{0.33}, Disk{.poisson = 0.5, .radius = 0.7}, 3.5); }}),
    [](const auto& ensemble) { return ensemble.param.name; });

}  // namespace
}  // namespace stoss
