// Plates and strips as bodies: what moves their points, by identities and by limits that are known.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "bodies/plate/plate_waves.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/plate.hpp"
#include "stoss/errors.hpp"
#include "support/plate_materials.hpp"

namespace stoss {
namespace plate_body {
namespace {

using std::numbers::pi;
using Matrix = Eigen::MatrixXd;

Matrix matrix_of(const std::vector<double>& values) {
  const auto size = static_cast<Eigen::Index>(std::lround(std::sqrt(static_cast<double>(values.size()))));
  return Matrix::Map(values.data(), size, size);
}

double smallest_over_greatest(const Matrix& matrix) {
  const auto values = Eigen::SelfAdjointEigenSolver<Matrix>(matrix).eigenvalues().eval();
  return values(0) / values(values.size() - 1);
}

/// In units of a body of size 1 that is met: thickness, cutoff, and half-width of the contact.
void expect_positive(const Body& body, double half_width, const std::string& what) {
  SCOPED_TRACE(what);
  constexpr std::size_t count = 20;
  const ContactPoints points{1.0, half_width / count, count};
  const Matrix compliance = matrix_of(body.residual_compliance(points, {}));
  const Matrix moment = matrix_of(body.residual_second_moment(points, {}));
  EXPECT_LT((compliance - compliance.transpose()).norm(), 1e-13 * compliance.norm());
  EXPECT_LT((moment - moment.transpose()).norm(), 1e-13 * moment.norm());
  EXPECT_EQ(Eigen::LLT<Matrix>(compliance).info(), Eigen::Success);
  EXPECT_GT(smallest_over_greatest(compliance), 1e-9);
  EXPECT_GT(smallest_over_greatest(moment), -1e-12);
}

TEST(PlateBody, HasPositiveResiduals) {
  for (const double thickness : {0.02, 0.1, 0.5, 2.0, 10.0, 50.0}) {
    for (const double cutoff : {0.3, 3.0, 20.0}) {
      for (const double poisson : {-0.5, 0.3, 0.4999}) {
        const Body body = plate(Plate{thickness, poisson}, cutoff, 12.0);
        validate(body);
        for (const double half_width : {1e-3, 0.3}) {
          const std::string what = body.name + ", cutoff " + std::to_string(cutoff) + ", " + std::to_string(half_width);
          expect_positive(body, half_width, what);
          if (poisson != 0.3) continue;
          expect_positive(body.along({}).front(), half_width, what + " along");
          expect_positive(body.outward({}), half_width, what + " outward");
        }
      }
    }
  }
}

TEST(StripBody, HasPositiveResiduals) {
  for (const double thickness : {0.1, 1.0, 5.0}) {
    for (const double cutoff : {0.3, 3.0, 20.0}) {
      const Body body = strip(Strip{thickness, 0.33}, cutoff, 12.0);
      validate(body);
      for (const double half_width : {1e-3, 0.3}) {
        const std::string what = body.name + ", cutoff " + std::to_string(cutoff) + ", " + std::to_string(half_width);
        expect_positive(body, half_width, what);
        for (const Body& along : body.along({})) expect_positive(along, half_width, what + " along");
      }
    }
  }
}

/// Displacement at a distance from the axis, at a time after a unit blow there, of kept modes. The blow takes a while,
/// as a branch is kept only up to the wave number where it reaches the cutoff, which no quadrature resolves.
double moved(const Body& body, double distance, double time) {
  const ContactPoints point{1.0, 2.0 * std::asin(distance), 1};
  const Surface surface = body.surface(point);
  double sum = 0.0;
  for (const ModeGroup& group : body.groups) {
    const double shape = surface.shape[group.upper_row];
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      const double blow = std::pow(1.0 - std::pow(group.omega[l] / body.cutoff, 2), 4);
      sum += blow * std::pow(shape * group.upper[l], 2) / group.omega[l] * std::sin(group.omega[l] * time);
    }
  }
  return sum;
}

TEST(PlateBody, MovesAwayAfterABlowAsZenersPlate) {
  // After a blow of momentum 1 the plate has gone by w = 1/(8√(Dρh)) for good, and by what falls as 1/t.
  for (const double poisson : {-0.5, 0.0, 0.3, 0.4999}) {
    constexpr double thickness = 0.3, young = 2.0, density = 0.5, duration = 400.0, early = 200.0, late = 350.0;
    const double rigidity = young * std::pow(thickness, 3) / (12.0 * (1.0 - poisson * poisson));
    const double wanted = density * std::sqrt(young / density) / (8.0 * std::sqrt(rigidity * density * thickness));
    const Body body = plate(Plate{thickness, poisson, young, density}, 2.0, duration);
    EXPECT_NEAR(body.scale.speed, std::sqrt(young / density), 1e-14);
    const double at_early = moved(body, 0.02, early), at_late = moved(body, 0.02, late);
    EXPECT_NEAR(at_late / wanted, 1.0, 5e-4) << poisson;
    EXPECT_NEAR((late * at_late - early * at_early) / (late - early) / wanted, 1.0, 5e-5) << poisson;
  }
}

class AtAnyThickness : public testing::TestWithParam<double> {};

// Half as many wave numbers do what is wanted for the time they are made for.
TEST_P(AtAnyThickness, MotionAfterABlowIsThatOfMoreWaves) {
  constexpr double cutoff = 8.0, duration = 12.0;
  for (const bool in_plane : {false, true}) {
    const auto made = [&](double made_for) {
      return in_plane ? strip(Strip{GetParam(), 0.33}, cutoff, made_for)
                      : plate(Plate{GetParam(), 0.3}, cutoff, made_for);
    };
    const Body body = made(duration), more = made(2.5 * duration);
    for (const double distance : {0.05, 0.4}) {
      double greatest = 0.0, worst = 0.0;
      for (double time = 0.25; time < 2.0; time += 0.25) {
        greatest = std::max(greatest, std::abs(moved(body, distance, time)));
      }
      for (double time = 0.25; time <= 0.9 * duration; time += 0.53) {
        worst = std::max(worst, std::abs(moved(body, distance, time) - moved(more, distance, time)));
      }
      EXPECT_LT(worst, 1e-7 * greatest) << in_plane << ' ' << distance;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Every, AtAnyThickness, testing::Values(0.03, 0.2, 1.0, 3.0),
                         [](const auto& its) { return "number" + std::to_string(its.index); });

/// Response to forces that fall as exp(−st), of kept modes and the others.
Matrix response(const Body& body, const ContactPoints& points, double s) {
  Matrix sum =
      matrix_of(body.residual_compliance(points, {})) - s * s * matrix_of(body.residual_second_moment(points, {}));
  const Surface surface = body.surface(points);
  const auto size = static_cast<std::size_t>(sum.rows());
  for (const ModeGroup& group : body.groups) {
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      Eigen::VectorXd move(sum.rows());
      for (std::size_t i = 0; i < size; ++i) {
        const double lower = group.lower.empty() ? 0.0 : group.lower[l];
        move(static_cast<Eigen::Index>(i)) = group.upper[l] * surface.shape[group.upper_row * size + i] +
                                             lower * surface.shape[group.lower_row * size + i];
      }
      sum += move * move.transpose() / (group.omega[l] * group.omega[l] + s * s);
    }
  }
  return sum;
}

// Forces that fall within the time of an echo meet a half-space, in all directions and between them.
TEST(PlateBody, IsAHalfSpaceToForcesThatEndBeforeTheEcho) {
  constexpr double cutoff = 16.0, duration = 16.0, thickness = 5.0, s = 3.0, poisson = 0.3;
  const ContactPoints points{1.0, 0.02, 12};
  const Body part = plate(Plate{thickness, poisson}, cutoff, duration);
  const Body whole = half_space(HalfSpace{poisson}, cutoff, duration);
  const auto expect_alike = [&](const Body& one, const Body& other, const char* what) {
    const Matrix a = response(one, points, s), b = response(other, points, s);
    EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 2e-5 * b.cwiseAbs().maxCoeff()) << what;
  };
  expect_alike(part, whole, "normal");
  expect_alike(part.along({}).front(), whole.along({}).front(), "along");
  expect_alike(part.outward({}), whole.outward({}), "outward");
  const Body strip_part = strip(Strip{thickness, 0.33}, cutoff, duration);
  const Body half_plane_whole = half_plane(HalfPlane{0.33}, cutoff, duration);
  expect_alike(strip_part, half_plane_whole, "strip");
  for (const std::size_t kind : {0U, 1U}) {
    expect_alike(strip_part.along({})[kind], half_plane_whole.along({})[kind], "strip along");
  }
}

TEST(PlateBody, RefusesWhatItCannotBe) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, inf}) {
    EXPECT_THROW((void)plate(Plate{1.0, 0.3}, bad, 10.0), InvalidInput);
    EXPECT_THROW((void)plate(Plate{1.0, 0.3}, 10.0, bad), InvalidInput);
  }
  EXPECT_THROW((void)plate(Plate{.thickness = 1.0, .poisson = 0.3, .below = {{inf}, {1.0}}}), InvalidInput);
  EXPECT_THROW((void)plate(Plate{.thickness = 1.0, .poisson = 0.3, .below = {{1.0, 0.5}}}), InvalidInput);
  EXPECT_THROW((void)plate(Plate{.thickness = 1.0, .below = std::vector<Layer>(64)}), InvalidInput);
  EXPECT_NO_THROW((void)plate(Plate{.thickness = 1.0, .poisson = 0.3, .below = {{inf}}}));
  EXPECT_THROW((void)plate(Plate{1.0, 0.3}, 1e6, 1e6), InvalidInput);
}

}  // namespace
}  // namespace plate_body
}  // namespace stoss
