// Moduli that relax, and their inverse, creep.
#include "stoss/relaxation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>

#include "relaxation/creep.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

const Relaxation two{{{0.4, 0.3}, {0.4, 5.0}}};

std::complex<double> compliance(const Creep& creep, std::complex<double> s) {
  std::complex<double> sum = creep.glass;
  for (const auto [fluidity, rate] : creep.terms) sum += fluidity / (s + rate);
  return sum;
}

}  // namespace

TEST(Relaxation, GoesFromTheInstantaneousToTheRelaxedModulus) {
  EXPECT_NEAR(two.relaxed(), 0.2, 1e-15);
  EXPECT_NEAR(modulus_after(two, 0.0), 1.0, 1e-15);
  EXPECT_NEAR(modulus_after(two, 1e3), 0.2, 1e-15);
  EXPECT_NEAR(std::abs(modulus(two, {0.0, 1e9}) - 1.0), 0.0, 1e-8);
  EXPECT_NEAR(std::abs(modulus(two, 0.0) - 0.2), 0.0, 1e-15);
  EXPECT_EQ(in_time(two, 2.0).terms.back().time, 10.0);
  // Loss and storage of one term: E′ and E″ of a Maxwell branch beside a spring.
  const Relaxation one{{{0.5, 2.0}}};
  const std::complex<double> its = modulus(one, {0.0, 0.5});
  EXPECT_NEAR(its.real(), 0.75, 1e-15);
  EXPECT_NEAR(its.imag(), 0.25, 1e-15);
}

TEST(Relaxation, RefusesWhatNoMaterialIs) {
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    EXPECT_THROW(validate(Relaxation{{{0.5, bad}}}), InvalidInput) << bad;
    EXPECT_THROW(validate(Relaxation{{{bad, 0.5}}}), InvalidInput) << bad;
  }
  EXPECT_THROW(validate(Relaxation{{{0.6, 1.0}, {0.6, 2.0}}}), InvalidInput);
  EXPECT_THROW(validate(Relaxation{std::vector<RelaxationTerm>(21, {0.01, 1.0})}), InvalidInput);
  EXPECT_NO_THROW(validate(Relaxation{{{0.5, 1.0}, {0.5, 2.0}}}));
}

TEST(Creep, IsTheInverseOfRelaxation) {
  for (const Relaxation& each :
       {two, Relaxation{{{0.5, 1.0}}}, Relaxation{{{1e-9, 1.0}, {0.9, 2.0}, {0.05, 1e4}, {0.04, 1e-4}}}}) {
    const Creep its = creep(Rates(each));
    for (const double omega : {1e-5, 1e-2, 0.3, 1.0, 7.0, 1e3, 1e6}) {
      const std::complex<double> s(0.0, omega);
      EXPECT_NEAR(std::abs(compliance(its, s) * modulus(each, s) - 1.0), 0.0, 1e-10) << omega;
    }
  }
}

// Of a constant stress the strain in steps tends to J(t), to the second order of the step.
TEST(CreepMemory, FollowsAStressToTheSecondOrder) {
  const Creep its = creep(Rates(two));
  const auto error = [&](int steps) {
    const double step = 3.0 / steps;
    CreepMemory memory(its, step, 1);
    double strain = 0.0;
    for (int i = 1; i <= steps; ++i) {
      const double elastic = std::sin(0.5 * i * step);
      strain = memory.share() * elastic + memory.predict().front();
      memory.follow({strain});
    }
    double exact = its.glass * std::sin(1.5);  // ∫ e^(−r(t − t′)) sin ½t′ dt′
    for (const auto [fluidity, rate] : its.terms) {
      exact +=
          fluidity * (rate * std::sin(1.5) - 0.5 * std::cos(1.5) + 0.5 * std::exp(-rate * 3.0)) / (rate * rate + 0.25);
    }
    return std::abs(strain - exact);
  };
  EXPECT_LT(error(400), 1e-4);
  EXPECT_NEAR(std::log2(error(200) / error(400)), 2.0, 0.2);
}

}  // namespace stoss
