// The static response of bodies by their modes at a point, across and along their surface: the local formula, and what
// is left of it for a sphere.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "bodies/modal/point_modes.hpp"
#include "bodies/sphere/degree_sums.hpp"
#include "stoss/bodies/modal_body.hpp"
#include "stoss/bodies/sphere.hpp"

namespace stoss {
namespace modal_response {
namespace {

using std::numbers::pi;

// Of so many rings W is that of the continuum at these two, which lie far from each other, to 1e-3.
constexpr std::size_t rings = 256, near = 32, far = 224;

/// Whether bodies are pressed or rubbed: G = A [1/r − g ln r] + a constant.
class PointResponse : public ::testing::TestWithParam<bool> {
 protected:
  const bool along = GetParam();

  [[nodiscard]] double plain(double poisson) const {
    return (along ? bodies::sphere::softness_along(poisson) : 1.0 - poisson * poisson) / pi;
  }
  [[nodiscard]] double logarithm(double poisson) const {
    return along ? bodies::modal::logarithm_share_along(poisson) : bodies::modal::logarithm_share(poisson);
  }
  [[nodiscard]] double of_sphere(double poisson) const {
    return along ? bodies::modal::sphere_constant_along(poisson) : bodies::modal::sphere_constant(poisson);
  }

  /// What W of two rings has beyond the mean over both of A [1/r − g ln r].
  [[nodiscard]] double constant_of(const Body& body, double poisson, double width, double share) const {
    const ContactPoints points{1.0, width / rings, rings};
    const Body pressed = along ? body.along({}).front() : body;
    const std::vector<double> w = pressed.residual_compliance(points, {});
    const double one = std::sin(points.angle(near)), other = std::sin(points.angle(far));
    const double sum = one + other, modulus = 2.0 * std::sqrt(one * other) / sum;
    const double inverse = 2.0 / (pi * sum) * boost::math::ellint_1(modulus);
    return w[near * rings + far] - plain(poisson) * (inverse - share * std::log(std::max(one, other)));
  }

  [[nodiscard]] static Body without_modes(double poisson, double constant, double curvature) {
    ModalBody body;
    body.mass = 2.0;
    body.curvature = curvature;
    body.poisson = poisson;
    body.compliance = constant;
    body.complete_to = 1.0;
    body.tangent = PointTangent{.mass = 2.0, .compliance = constant};
    return modal_body(body)(0.5, {});
  }
};

// Rings err by about 4e-4 of their response, and G by the order of their size.
TEST_P(PointResponse, OfASphereIsTheFormulaAndItsConstant) {
  if (!along) {  // of docs/theory/any_body.md, from an independent summation with rings of 0.005 R
    EXPECT_NEAR(of_sphere(0.3), -0.5048, 2e-3);
    EXPECT_NEAR(of_sphere(0.0), -0.663, 1e-3);
    return;
  }
  for (const double poisson : {-0.3, 0.0, 0.3, 0.45}) {
    const Body sphere = stoss::sphere(Sphere{poisson}, 0.5);
    const auto at = [&](double width) { return constant_of(sphere, poisson, width, logarithm(poisson)); };
    // c + a w + b/w through three of them
    const double wide = at(0.16), middle = at(0.08), narrow = at(0.04);
    const double b = (wide - middle - 2.0 * (middle - narrow)) / (25.0 - 6.25);
    const double a = (wide - middle + 6.25 * b) / 0.08;
    EXPECT_NEAR(wide - 0.16 * a - 6.25 * b, of_sphere(poisson), 3e-3) << poisson;
  }
}

// Rings at a distance move each other by G(r) and a remainder of the order of their size.
TEST_P(PointResponse, IsTheLocalFormulaAndTheConstantThatIsGiven) {
  for (const double poisson : {0.0, 0.3, 0.45}) {
    for (const double constant : {-0.5, 0.0, 3.0}) {
      const Body body = without_modes(poisson, constant, 1.0);
      for (const double width : {0.08, 0.02}) {
        const double found = constant_of(body, poisson, width, logarithm(poisson));
        EXPECT_LT(std::abs(found - constant), (along ? 0.5 : 0.1) * width + 5e-4 / width) << poisson << " " << width;
      }
    }
  }
}

TEST_P(PointResponse, OfAPlaneSurfaceHasNoLogarithm) {
  const double found = constant_of(without_modes(0.3, 0.7, 0.0), 0.3, 0.02, 0.0);
  EXPECT_NEAR(found, 0.7 * std::cbrt(2.0), 0.03);  // in units of its cube
}

INSTANTIATE_TEST_SUITE_P(Every, PointResponse, ::testing::Bool(),
                         [](const auto& its) { return std::string(its.param ? "along" : "across"); });

}  // namespace
}  // namespace modal_response
}  // namespace stoss
