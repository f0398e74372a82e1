// Frequencies and edge amplitudes of the modes against published values, mpmath and the printed equation.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <map>
#include <vector>

#include "stoss/bodies/disk/modes.hpp"
#include "support/csv.hpp"
#include "support/eigenvalue_equation.hpp"
#include "support/mode_tables.hpp"

namespace stoss {
using namespace bodies::disk;

namespace {

/// |D/D′|/ω, the relative error of ω by Newton's method, with D the paper's printed equation.
template <typename Real>
double newton_correction(double poisson, const Mode& mode, double relative_step) {
  const Real nu = poisson;
  const Real omega = mode.omega;
  const Real h = omega * Real(relative_step);
  const auto d = [&](const Real& w) { return test::eigenvalue_equation<Real>(nu, mode.order, w); };
  const Real correction = 2 * h * d(omega) / (d(Real(omega + h)) - d(Real(omega - h)));
  return std::abs(static_cast<double>(Real(correction / omega)));
}

TEST(ModeValues, CountsBelowACutoff) {
  EXPECT_EQ(bodies::disk::modes(0.33, 25.0).size(), 295U);
  EXPECT_EQ(bodies::disk::modes(0.33, 50.0).size(), 1146U);
  EXPECT_EQ(bodies::disk::modes(0.33, 100.0).size(), 4510U);
  EXPECT_EQ(bodies::disk::modes(0.0, 100.0).size(), 3829U);
}

TEST(ModeValues, AgreeWithTheReferenceToItsDigits) {
  std::map<double, std::vector<Mode>> modes;
  for (const auto& row : test::read_csv("disk_modes.csv")) {
    const double poisson = row.number("poisson");
    if (modes[poisson].empty()) modes[poisson] = bodies::disk::modes(poisson, 30.0);
    const auto found = std::find_if(modes[poisson].begin(), modes[poisson].end(), [&](const Mode& mode) {
      return mode.order == row.integer("n") && mode.index == row.integer("l");
    });
    ASSERT_NE(found, modes[poisson].end());
    EXPECT_NEAR(found->omega, row.number("omega"), 0.51e-8);
    EXPECT_NEAR(found->omega * std::sqrt(1.0 - poisson * poisson), row.number("kappa"), 0.51e-8);
    EXPECT_NEAR(found->radial, row.number("C"), 0.51e-6);
    EXPECT_NEAR(found->tangential, row.number("S"), 0.51e-6);
  }
}

TEST(ModeValues, AgreeWithMpmathInEveryWindow) {
  const auto modes_of = [](double poisson) { return bodies::disk::modes(poisson, 400.0); };
  EXPECT_GE(test::compare_with_mpmath("modes_mpmath.csv", "C", "S", modes_of, [](int) { return 1.0; }), 150U);
}

class ModeResidual : public ::testing::TestWithParam<double> {};

TEST_P(ModeResidual, OfThePaperEquationInLongDouble) {
  const double poisson = GetParam();
  const auto modes = bodies::disk::modes(poisson, 100.0);
  for (std::size_t i = 0; i < modes.size(); i += 11) {
    EXPECT_LE(newton_correction<long double>(poisson, modes[i], 1e-7), 1e-12)
        << "n = " << modes[i].order << ", omega = " << modes[i].omega;
  }
}

INSTANTIATE_TEST_SUITE_P(Poisson, ModeResidual,
                         ::testing::Values(-0.95, -0.9, -0.5, 0.0, 0.2, 0.33, 0.5, 0.9, 0.99, 0.995));

TEST(ModeValues, FamilyIsThatOfTheLargerAmplitude) {
  EXPECT_EQ(family({2, 0, 1.0, 1.0, -0.9}), ModeFamily::radial);
  EXPECT_EQ(family({2, 0, 1.0, 0.9, -1.0}), ModeFamily::tangential);
  const auto modes = bodies::disk::modes(0.33, 25.0);
  EXPECT_EQ(family(modes.front()), ModeFamily::radial);  // n = 0 is purely radial
  for (const Mode& mode : modes) {
    EXPECT_EQ(family(mode) == ModeFamily::radial, mode.radial > std::abs(mode.tangential));
    EXPECT_GE(mode.radial, 0.0);
  }
}

TEST(ModeValues, AModeTakesAtMostAHundredBytes) { EXPECT_LE(sizeof(Mode), 100U); }

}  // namespace
}  // namespace stoss
