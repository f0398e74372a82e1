// A disk that follows the wall's force statically: its impact against quadratures in 50 digits and an integration in
// time.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "stoss/quasistatic/slow_impact.hpp"
#include "support/refusal.hpp"
#include "support/runge_kutta.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

using Digits50 = boost::multiprecision::cpp_bin_float_50;

constexpr std::array all_laws{CompressionLaw::center, CompressionLaw::diameter};
constexpr std::array some_poissons{-0.9, 0.0, 0.33, 0.9};

/// δ = F (ln(s/F) − b), as the documentation has it.
struct Law {
  Digits50 s, b;
};

Law law_of(CompressionLaw law, double poisson) {
  const Digits50 poisson50 = poisson;
  if (law == CompressionLaw::center) return {1, (1 + poisson50) / 4};
  return {4, 1};
}

Digits50 energy(const Law& law, const Digits50& force) {
  return force * force * (log(law.s / force) / 2 - law.b / 2 - Digits50(0.25));
}

/// F_max, by bisection of ½v² = U(F) below the limit of the law.
Digits50 max_force(const Law& law, double speed) {
  const Digits50 kinetic = Digits50(speed) * speed / 2;
  Digits50 low = 0;
  Digits50 high = law.s * exp(-1 - law.b);
  if (energy(law, high) < kinetic) return high;
  for (int i = 0; i < 250; ++i) {
    const Digits50 middle = (low + high) / 2;
    (energy(law, middle) < kinetic ? low : high) = middle;
  }
  return high;
}

/// 2 ∫ dδ/δ̇ with F = F_max (1 − x²), straight from the law. The last halving of the rule's step, which changes the sum
/// by less than 1e-10, squares its error.
Digits50 contact_time(const Law& law, double speed) {
  const Digits50 greatest = max_force(law, speed);
  const Digits50 turn = energy(law, greatest);
  const auto integrand = [&](const Digits50& x) -> Digits50 {
    const Digits50 force = greatest * (1 - x) * (1 + x);
    if (force <= 0) return 0;
    const Digits50 kinetic = turn - energy(law, force);
    if (kinetic <= 0) return 0;
    return (log(law.s / force) - law.b - 1) * 2 * greatest * x / sqrt(2 * kinetic);
  };
  static boost::math::quadrature::tanh_sinh<Digits50> quadrature;
  return 2 * quadrature.integrate(integrand, Digits50(0), Digits50(1), Digits50(1e-10));
}

double relative(double value, const Digits50& reference) { return static_cast<double>(value / reference - 1); }

TEST(SlowImpact, AgreesWithQuadratureInFiftyDigits) {
  double worst = 0.0;
  for (const CompressionLaw law : all_laws) {
    for (const double poisson : some_poissons) {
      const double limit = limit_speed(law, poisson);
      for (const double speed : {1e-12, 1e-6, 1e-3, 0.05, 0.99 * limit}) {
        const Law exact = law_of(law, poisson);
        const Digits50 force = max_force(exact, speed);
        const SlowImpact impact = slow_impact(law, poisson, speed);
        EXPECT_EQ(impact.law, StaticLaw(law));
        EXPECT_EQ(impact.poisson, poisson);
        EXPECT_EQ(impact.speed, speed);
        for (const double error :
             {relative(impact.max_force, force), relative(impact.contact_time, contact_time(exact, speed)),
              relative(impact.max_compression, force * (log(exact.s / force) - exact.b))}) {
          worst = std::max(worst, std::abs(error));
        }
      }
    }
  }
  EXPECT_LT(worst, 1e-14);
}

TEST(SlowImpact, EndsWhereTheLawDoes) {
  for (const CompressionLaw law : all_laws) {
    for (const double poisson : some_poissons) {
      const double limit = limit_speed(law, poisson);
      EXPECT_NEAR(0.5 * limit * limit / compression_energy(law, poisson, limit_force(law, poisson)), 1.0, 1e-14);
      const SlowImpact last = slow_impact(law, poisson, limit);
      EXPECT_LE(last.max_force, limit_force(law, poisson));
      EXPECT_NEAR(last.max_force / limit_force(law, poisson), 1.0, 1e-8);
      // The time is a property of F_max/F* alone, and so at the limit the same for all.
      EXPECT_NEAR(last.contact_time, 3.8996523205143, 1e-9);
      EXPECT_NEAR(relative(slow_impact(law, poisson, limit * (1.0 - 1e-9)).contact_time,
                           contact_time(law_of(law, poisson), limit * (1.0 - 1e-9))),
                  0.0, 1e-12);
      test::expect_refusal([&] { (void)slow_impact(law, poisson, std::nextafter(limit, 1.0)); }, {"speed", "limit"});
    }
  }
  test::expect_refusal([] { (void)slow_impact(CompressionLaw::center, 0.33, 0.5); },
                       {"speed: got 0.5", "1e-100 to 0.1865", "no force"});
}

TEST(SlowImpact, AgreesWithTheEquationOfMotion) {
  for (const CompressionLaw law : all_laws) {
    for (const double poisson : some_poissons) {
      for (const double speed : {1e-12, 1e-6, 1e-3, 0.05}) {
        const SlowImpact impact = slow_impact(law, poisson, speed);
        constexpr int steps = 2000;  // short at both ends, where the force has an infinite second derivative
        std::vector<double> phases;
        for (int i = 0; i <= steps; ++i) {
          phases.push_back(0.5 * std::numbers::pi * (1.0 - std::cos(std::numbers::pi * i / steps)));
        }
        const std::vector<ContactInstant> history = contact_history(impact, phases);
        const auto slope = [&](const std::array<double, 2>& motion) {  // of δ/v and δ̇/v
          const double force = compression_force(law, poisson, std::max(0.0, motion[0] * speed));
          return std::array{motion[1], -force / speed};
        };
        std::array motion{0.0, 1.0};
        double worst = 0.0;
        for (std::size_t i = 1; i < history.size(); ++i) {
          motion = test::runge_kutta_step(motion, history[i].time - history[i - 1].time, slope);
          worst = std::max({worst, std::abs(motion[0] - history[i].compression / speed),
                            std::abs(motion[1] - history[i].velocity / speed)});
        }
        // It covers δ_max, the time of the turn (δ̇ = 0) and that of the end (δ = 0).
        EXPECT_LT(worst, 1e-11) << poisson << " " << speed;
        EXPECT_NEAR(history[steps / 2].time / impact.contact_time, 0.5, 1e-14);
        EXPECT_EQ(history.back().time, impact.contact_time);
      }
    }
  }
}

TEST(SlowImpact, HistoryObeysLawEnergyAndMomentum) {
  for (const CompressionLaw law : all_laws) {
    for (const double speed : {1e-12, 1e-3, 0.1}) {
      const double poisson = 0.33;
      const SlowImpact impact = slow_impact(law, poisson, speed);
      constexpr int count = 4000;
      std::vector<double> phases;
      for (int i = 0; i <= count; ++i) phases.push_back(std::numbers::pi * i / count);
      const std::vector<ContactInstant> history = contact_history(impact, phases);
      EXPECT_EQ(history.front().time, 0.0);
      EXPECT_EQ(history.front().force, 0.0);
      EXPECT_EQ(history.front().velocity, speed);
      EXPECT_EQ(history.back().compression, 0.0);
      EXPECT_EQ(history[count / 2].force, impact.max_force);
      EXPECT_EQ(history[count / 2].compression, impact.max_compression);
      double impulse = 0.0;
      for (std::size_t i = 0; i < history.size(); ++i) {
        const ContactInstant& now = history[i];
        const ContactInstant& mirrored = history[history.size() - 1 - i];
        EXPECT_NEAR(now.time, impact.contact_time - mirrored.time, 1e-13 * impact.contact_time);
        EXPECT_NEAR(now.force, mirrored.force, 1e-12 * impact.max_force);
        if (now.force > 0.0) {
          EXPECT_NEAR(now.compression / compression(law, poisson, now.force), 1.0, 1e-13);
        }
        EXPECT_NEAR((0.5 * now.velocity * now.velocity + compression_energy(law, poisson, now.force)) / (speed * speed),
                    0.5, 1e-13);
        if (i == 0) continue;
        EXPECT_GT(now.time, history[i - 1].time);
        impulse += 0.5 * (now.force + history[i - 1].force) * (now.time - history[i - 1].time);
      }
      EXPECT_NEAR(impulse / (2.0 * speed), 1.0, 1e-6);  // by the trapezium rule
    }
  }
}

TEST(SlowImpact, ApproachesItsAsymptotics) {
  const double log2 = std::numbers::ln2;
  const double third = (2.0 * log2 - log2 * log2 - std::numbers::pi * std::numbers::pi / 12.0) / 8.0;
  EXPECT_NEAR(third, 0.0104, 1e-4);
  for (const CompressionLaw law : all_laws) {
    double last_compression = 1.0;
    double last_time = 1.0;
    for (const double speed : {1e-3, 1e-6, 1e-12, 1e-25, 1e-50, 1e-100}) {
      const double poisson = 0.33;
      const SlowImpact impact = slow_impact(law, poisson, speed);
      const double factor = std::pow(speed / impact.max_force, 2);  // A
      const double constant = law == CompressionLaw::center ? -0.25 * (3.0 + poisson) : std::log(4.0) - 1.5;
      const double lambda = constant - std::log(speed);
      EXPECT_NEAR(factor - 0.5 * std::log(factor), lambda, 1e-13 * lambda);
      EXPECT_NEAR(impact.max_compression / (speed * (std::sqrt(factor) + 0.5 / std::sqrt(factor))), 1.0, 1e-13);
      const double time = impact.contact_time / (std::numbers::pi * std::sqrt(factor));
      EXPECT_LT(std::abs(time - 1.0 - 0.5 * log2 / factor - third / (factor * factor)), 0.2 / std::pow(factor, 3));
      // In powers of 1/Λ, the rate at which both ratios tend to 1, and what is left over.
      const double log_lambda = std::log(lambda);
      const double rest = 0.2 * std::pow(log_lambda / lambda, 2) + 0.2 / (lambda * lambda);
      const double compression_ratio = impact.max_compression / (speed * std::sqrt(lambda)) - 1.0;
      const double time_ratio = impact.contact_time / (std::numbers::pi * std::sqrt(lambda)) - 1.0;
      EXPECT_NEAR(compression_ratio, (log_lambda + 2.0) / (4.0 * lambda), rest) << speed;
      EXPECT_NEAR(time_ratio, (log_lambda + 2.0 * log2) / (4.0 * lambda), rest) << speed;
      EXPECT_GT(compression_ratio, 0.0);
      EXPECT_LT(compression_ratio, last_compression);
      EXPECT_LT(time_ratio, last_time);
      last_compression = compression_ratio;
      last_time = time_ratio;
    }
  }
}

TEST(SlowImpact, RepeatsItselfAndRefusesNonsense) {
  const auto law = CompressionLaw::center;
  const SlowImpact impact = slow_impact(law, 0.33, 0.01);
  EXPECT_EQ(impact.contact_time, slow_impact(law, 0.33, 0.01).contact_time);
  EXPECT_EQ(impact.max_force, slow_impact(law, 0.33, 0.01).max_force);
  for (const double speed : {0.0, -0.1, 1e-101, std::numeric_limits<double>::quiet_NaN()}) {
    test::expect_refusal([&] { (void)slow_impact(law, 0.33, speed); }, {"speed"});
  }
  test::expect_refusal([&] { (void)slow_impact(law, 1.0, 0.01); }, {"poisson"});
  test::expect_refusal([&] { (void)contact_history(impact, {0.0, 3.2}); }, {"phase: got 3.2", "0 to pi"});
  test::expect_refusal([&] { (void)contact_history({.law = law, .poisson = 0.33}, {1.0}); }, {"speed"});
  EXPECT_TRUE(contact_history(impact, {}).empty());
}

}  // namespace
}  // namespace stoss
