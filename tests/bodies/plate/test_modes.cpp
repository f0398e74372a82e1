// The modes of a plate of one material at any wave number: roots and residues of the equations of Rayleigh and Lamb to
// 100 digits, as many as their changes of sign, and what the others add.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bodies/plate/branches.hpp"
#include "support/plate_materials.hpp"
#include "support/rayleigh_lamb.hpp"

namespace stoss {
namespace plate_modes {
namespace {

using namespace bodies::plate;
using test::Exact;
using test::Kind;

constexpr Kind kinds[] = {Kind::symmetric, Kind::antisymmetric};
constexpr double halves_of_waves[] = {0.012, 0.05, 0.3, 1.0, 2.6, 7.0, 20.0, 50.0};  // kH

class AtAnyWaveNumber : public testing::TestWithParam<test::Slab> {
 protected:
  const test::Slab its = GetParam();
  const std::vector<Sheets> parts = parts_of({its.sheet()});

  /// Sheets of each kind, at each wave number, with some modes below a cutoff.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    for (const double x : halves_of_waves) {
      const double k = 2.0 * x / its.thickness, cutoff = its.shear_speed() * (1.02 * k + 19.0 / its.thickness);
      for (std::size_t part = 0; part < 2; ++part) {
        SCOPED_TRACE("kH = " + std::to_string(x) + (part == 0 ? ", symmetric" : ", antisymmetric"));
        visit(parts[part], kinds[part], k, cutoff);
      }
    }
  }
};

TEST_P(AtAnyWaveNumber, ModesAreRootsAndResiduesOfRayleighAndLamb) {
  const auto exact = its.exact<Exact>();
  int modes = 0, inexact = 0;
  for_each([&](const Sheets& sheets, Kind kind, double k, double cutoff) {
    const Branches<2> found = branches<2>(sheets, k, cutoff, {});
    // In bending at long waves digits of the frequency are lost, as Q is a small difference.
    const double x = 0.5 * k * its.thickness, rounding = 1e-15 / (x * x);
    const double usual = 2.0 / (its.density * its.thickness);
    ASSERT_FALSE(found.omega.empty());
    for (std::size_t m = 0; m < found.omega.size(); ++m) {
      const test::ExactMode mode = exact_mode(exact, kind, k, found.omega[m]);
      const auto omega = static_cast<double>(mode.omega), strength = static_cast<double>(mode.strength);
      EXPECT_NEAR(found.omega[m] / omega, 1.0, 1e-12 + (m == 0 ? rounding : 0.0)) << m;
      const double error = std::abs(std::pow(found.amplitude[m](1), 2) - strength) / usual;
      EXPECT_LT(error, 1e-7) << m;
      ++modes, inexact += error > 1e-9 ? 1 : 0;
    }
  });
  // Near a vibration of one of the slabs of which a layer is made digits are lost.
  EXPECT_LE(inexact, 0.02 * modes);
}

TEST_P(AtAnyWaveNumber, NumberOfModesIsThatOfChangesOfSign) {
  constexpr int samples = 20000;
  const auto closed = its.exact<double>();
  for_each([&](const Sheets& sheets, Kind kind, double k, double cutoff) {
    const Branches<2> found = branches<2>(sheets, k, cutoff, {});
    const int counted = count_of_signs(closed, kind, k, cutoff, samples);
    EXPECT_EQ(static_cast<int>(found.omega.size()), counted);
    EXPECT_EQ(count_below<2>(sheets, k, cutoff), counted);
    EXPECT_TRUE(std::is_sorted(found.omega.begin(), found.omega.end()));
    EXPECT_LE(found.omega.back(), cutoff);
  });
}

TEST_P(AtAnyWaveNumber, OthersAddWhatClosedFormsLeave) {
  const auto exact = its.exact<Exact>();
  for_each([&](const Sheets& sheets, Kind kind, double k, double cutoff) {
    const double x = 0.5 * k * its.thickness, rounding = 2e-15 / (x * x);
    for (const double limit : {0.4 * cutoff, cutoff}) {
      const Branches<2> found = branches<2>(sheets, k, limit, {});
      const Exact all = test::slow<Exact>(exact, kind, Exact(k));
      const Exact moment_of_all = test::slow_moment(exact, kind, k);
      Exact rest = all, moment = moment_of_all;
      double sum = found.compliance(1, 1), moments = found.second_moment(1, 1);
      for (std::size_t m = 0; m < found.omega.size(); ++m) {
        const test::ExactMode mode = exact_mode(exact, kind, k, found.omega[m]);
        const Exact square = mode.omega * mode.omega;
        rest -= mode.strength / square, moment -= mode.strength / (square * square);
        const double z = found.omega[m] * found.omega[m], strength = std::pow(found.amplitude[m](1), 2);
        sum += strength / z, moments += strength / (z * z);
      }
      const auto whole = static_cast<double>(all), whole_moment = static_cast<double>(moment_of_all);
      EXPECT_NEAR(sum / whole, 1.0, 4e-12 + rounding);
      EXPECT_NEAR(moments / whole_moment, 1.0, 8e-12 + 2.0 * rounding);
      EXPECT_NEAR(found.compliance(1, 1) / static_cast<double>(rest), 1.0, 1e-8) << found.omega.size();
      EXPECT_NEAR(found.second_moment(1, 1) / static_cast<double>(moment), 1.0, 1e-5) << found.omega.size();
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Every, AtAnyWaveNumber, testing::ValuesIn(test::every_slab),
                         [](const auto& its) { return "number" + std::to_string(its.index); });

}  // namespace
}  // namespace plate_modes
}  // namespace stoss
