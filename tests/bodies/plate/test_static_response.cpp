// A plate under slow forces: closed forms to 100 digits, of pressure at any wave number and of waves across.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bodies/plate/branches.hpp"
#include "support/plate_materials.hpp"
#include "support/rayleigh_lamb.hpp"

namespace stoss {
namespace plate_static_response {
namespace {

using namespace bodies::plate;
using test::Exact;
using test::Kind;

class SlowPlate : public testing::TestWithParam<test::Slab> {
 protected:
  const test::Slab its = GetParam();
  const Lamina plate = its.lamina();

  /// Wave numbers with kH from 1e-4 to 50, and what rounding of one part in 2⁵² may do at each: in bending, with the
  /// plate as two halves, Q is a difference of terms that are 1/(kH)² as great.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    for (double x = 1e-4; x < 55.0; x *= 1.21) {
      const double k = 2.0 * x / its.thickness;
      SCOPED_TRACE("kH = " + std::to_string(x));
      visit(k, 4e-12 + (plate.parts(k).size() == 2 ? 2e-15 / (x * x) : 0.0));
    }
  }
};

TEST_P(SlowPlate, AnswersPressureInClosedForm) {
  for_each([&](double k, double error) {
    Exact sum = 0;
    for (const Kind kind : {Kind::symmetric, Kind::antisymmetric}) sum += slow(its.exact<Exact>(), kind, Exact(k)) / 2;
    const double whole = plate.weight(k) * static_cast<double>(sum);
    EXPECT_NEAR(plane_compliance(plate, k).radial / whole, 1.0, error);
  });
}

TEST_P(SlowPlate, HasTheSecondMomentOfClosedForms) {
  for_each([&](double k, double error) {
    Exact sum = 0;
    for (const Kind kind : {Kind::symmetric, Kind::antisymmetric}) {
      sum += slow_moment(its.exact<Exact>(), kind, k) / 2;
    }
    const double whole = plate.weight(k) * static_cast<double>(sum);
    EXPECT_NEAR(plane_second_moment(plate, k).radial / whole, 1.0, 2.0 * error);
  });
}

// coth kh/μk, and its slope by ω² with k² − ω²/c_s² for k².
TEST_P(SlowPlate, AnswersForcesAcrossTheWaveInClosedForm) {
  const double mu = its.sheet().shear_modulus, h = its.thickness;
  for_each([&](double k, double) {
    const double kh = k * h, coth = 1.0 / std::tanh(kh), sinh = kh < 300.0 ? std::sinh(kh) : INFINITY;
    const double compliance = coth / (mu * k);
    const double moment = its.density / (2.0 * mu * mu * k * k) * (coth / k + h / (sinh * sinh));
    double sum = 0.0, moments = 0.0;
    for (const Sheets& part : plate.parts(k)) {
      sum += part.share * static_compliance<1>(part, k)(0, 0);
      moments += part.share * static_second_moment<1>(part, k)(0, 0);
    }
    EXPECT_NEAR(sum / compliance, 1.0, 1e-12);
    EXPECT_NEAR(moments / moment, 1.0, 2e-12);
  });
}

INSTANTIATE_TEST_SUITE_P(Every, SlowPlate, testing::ValuesIn(test::every_slab),
                         [](const auto& its) { return "number" + std::to_string(its.index); });

}  // namespace
}  // namespace plate_static_response
}  // namespace stoss
