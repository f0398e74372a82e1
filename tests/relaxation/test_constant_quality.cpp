// One quality over a band: flat to what is stated, the power law between, and few terms.
#include "stoss/relaxation/constant_quality.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "support/refusal.hpp"

namespace stoss {
namespace {

TEST(ConstantQualityTerms, KeepOneQualityOverTheBand) {
  for (const double quality : {3.0, 10.0, 100.0, 1e4, 1e9}) {
    const Relaxation its = constant_quality(quality, lowest_of_body, highest_of_body);
    EXPECT_NO_THROW(validate(its));
    EXPECT_LE(its.terms.size(), quality < 10.0 ? 15U : 10U) << quality;
    for (double frequency = lowest_of_body; frequency <= highest_of_body; frequency *= 1.01) {
      const std::complex<double> modulus = stoss::modulus(its, {0.0, frequency});
      EXPECT_NEAR(quality * modulus.imag() / modulus.real(), 1.0, 0.0101) << quality << " at " << frequency;
    }
  }
  EXPECT_EQ(constant_quality(100.0, 1.0, 1e3).terms.size(), 7U);
}

TEST(ConstantQualityTerms, HaveTheModulusOfThePowerLaw) {
  // |E| ∝ ω^{2γ/π}, γ = atan(1/Q).
  for (const double quality : {3.0, 10.0, 1e3}) {
    const Relaxation its = constant_quality(quality, 1e-2, 1e2);
    const double power = 2.0 / std::numbers::pi * std::atan(1.0 / quality);
    for (const double frequency : {0.02, 1.0, 50.0}) {
      const double ratio = 1.0 / std::abs(modulus(its, {0.0, frequency}));
      EXPECT_NEAR(instantaneous(its, quality, frequency) / ratio, 1.0, 0.02 / quality) << quality << " " << frequency;
    }
    EXPECT_NEAR(instantaneous(its, quality, 1e-6) / instantaneous(its, quality, 1e-2), std::pow(1e4, power), 1e-9);
  }
}

TEST(ConstantQualityTerms, AreRefusedBeyondTheirRange) {
  test::expect_refusal([] { (void)constant_quality(1.0, 1.0, 10.0); }, {"quality", "got 1", "3 to 1e9"});
  test::expect_refusal([] { (void)constant_quality(10.0, 1.0, 1.0); }, {"highest", "above the lowest"});
  test::expect_refusal([] { (void)constant_quality(10.0, 1e-20, 1e20); }, {"highest", "20 terms"});
}

}  // namespace
}  // namespace stoss
