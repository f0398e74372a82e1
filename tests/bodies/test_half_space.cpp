// The half-space as a body: its waves as modes, by identities that hold for every wave number.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <numbers>
#include <ostream>
#include <string>

#include "bodies/half_space/surface_waves.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/half_space/field.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::half_space {
namespace {

using std::numbers::pi;

struct Solid {
  Contour contour;
  double poisson;
  Direction direction = Direction::normal;
};

void PrintTo(const Solid& solid, std::ostream* out) {
  *out << (solid.contour == Contour::ball ? "half-space " : "half-plane ") << solid.poisson;
  if (solid.direction == Direction::along) *out << " along its surface";
}

class AtAnyPoisson : public testing::TestWithParam<Solid> {
 protected:
  const Medium its = medium(GetParam().contour, GetParam().poisson, GetParam().direction);
};

TEST_P(AtAnyPoisson, StaticResponseAndItsSecondMomentAreThoseOfAllWaves) {
  // As ν → ½ the spectrum extends to x = c_p/c_s = 71 before it is smooth.
  // Along the surface more of it lies there, and few wave numbers, of the longest waves, have so much of it kept.
  const double usual = GetParam().direction == Direction::along ? 7e-4 : 1.5e-4;
  const double error = its.kernel.poisson > 0.49 ? 2e-3 : usual;
  for (const double cutoff : {4.0, 32.0}) {
    for (const SurfaceWaves& waves : surface_waves(its, cutoff, 10.0, {})) {
      double compliance = waves.residual_compliance, moment = waves.residual_second_moment;
      for (std::size_t j = 0; j < waves.omega.size(); ++j) {
        const double square = waves.omega[j] * waves.omega[j];
        compliance += waves.strength[j] / square;
        moment += waves.strength[j] / (square * square);
      }
      const double whole = its.compliance(waves.wave_number) * waves.weight;
      const double whole_moment = its.second_moment(waves.wave_number) * waves.weight;
      EXPECT_NEAR(compliance / whole, 1.0, error) << waves.wave_number;
      EXPECT_NEAR(moment / whole_moment, 1.0, error) << waves.wave_number;
    }
  }
}

TEST_P(AtAnyPoisson, MotionAfterABlowIsThatOfMoreWaves) {
  // Half as many wave numbers and frequencies do what is wanted for the time they are made for.
  constexpr double cutoff = 8.0, duration = 12.0, distance = 0.2;
  const auto moved = [&](double made_for, double time) {
    double sum = 0.0;
    for (const SurfaceWaves& waves : surface_waves(its, cutoff, made_for, {})) {
      const double shape = its.shape(waves.wave_number * distance);
      for (std::size_t j = 0; j < waves.omega.size(); ++j) {
        sum += shape * waves.strength[j] / waves.omega[j] * std::sin(waves.omega[j] * time);
      }
    }
    return sum;
  };
  double greatest = 0.0;
  for (double time = 0.25; time < 2.0; time += 0.25) greatest = std::max(greatest, std::abs(moved(duration, time)));
  for (double time = 0.25; time <= 0.9 * duration; time += 0.53) {
    EXPECT_NEAR(moved(duration, time), moved(2.5 * duration, time), 2e-5 * greatest) << time;
  }
}

std::string name_of(const testing::TestParamInfo<Solid>& its) {
  const long of_10000 = std::lround(10000.0 * its.param.poisson);
  return (of_10000 < 0 ? "m" : "") + std::to_string(std::abs(of_10000));
}

constexpr Solid half_spaces[] = {{Contour::ball, -0.95}, {Contour::ball, -0.5}, {Contour::ball, 0.0},
                                 {Contour::ball, 0.05},  {Contour::ball, 0.25}, {Contour::ball, 0.3},
                                 {Contour::ball, 0.45},  {Contour::ball, 0.49}, {Contour::ball, 0.4999}};
constexpr Solid half_planes[] = {{Contour::cylinder, -0.95},
                                 {Contour::cylinder, -0.8},
                                 {Contour::cylinder, -0.5},
                                 {Contour::cylinder, 0.33},
                                 {Contour::cylinder, 0.9}};
constexpr Solid along[] = {{Contour::ball, -0.95, Direction::along}, {Contour::ball, -0.5, Direction::along},
                           {Contour::ball, 0.0, Direction::along},   {Contour::ball, 0.3, Direction::along},
                           {Contour::ball, 0.45, Direction::along},  {Contour::ball, 0.4999, Direction::along}};
INSTANTIATE_TEST_SUITE_P(AlongAHalfSpace, AtAnyPoisson, testing::ValuesIn(along), name_of);
INSTANTIATE_TEST_SUITE_P(HalfSpace, AtAnyPoisson, testing::ValuesIn(half_spaces), name_of);
INSTANTIATE_TEST_SUITE_P(HalfPlane, AtAnyPoisson, testing::ValuesIn(half_planes), name_of);

TEST(HalfSpace, WaveSpeedsOfAHalfPlaneAreThoseOfADisk) {
  const Medium plane = medium(Contour::cylinder, 0.33);
  EXPECT_NEAR(plane.pressure_speed, 1.0 / std::sqrt(1.0 - 0.33 * 0.33), 1e-14);
  EXPECT_NEAR(plane.shear_speed, 1.0 / std::sqrt(2.0 * 1.33), 1e-14);
  EXPECT_EQ(plane.softness, 1.0);
}

/// Flexibility between two rings of the waves up to a wave number under static loads, ∫ softness/π J₀(kr) J₀(ks) dk.
double rings(double softness, double highest, double r, double s) {
  constexpr int steps = 40000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double k = highest * (i + 0.5) / steps;
    sum += ::j0(k * r) * ::j0(k * s);
  }
  return softness / pi * highest * sum / steps;
}

void expect_static_response(const Body& body, double softness) {
  EXPECT_NEAR(body.softness, softness, 1e-15);
  const ContactPoints points{1.0, pi / 5000.0, 40};
  const std::vector<double> residual = body.residual_compliance(points, {});
  const Surface surface = body.surface(points);
  const auto all = [&](std::size_t i, std::size_t j) {
    double sum = residual[i * points.count + j];
    for (const ModeGroup& group : body.groups) {
      const double shapes =
          surface.shape[group.upper_row * points.count + i] * surface.shape[group.upper_row * points.count + j];
      for (std::size_t l = 0; l < group.omega.size(); ++l) {
        sum += shapes * group.upper[l] * group.upper[l] / (group.omega[l] * group.omega[l]);
      }
    }
    return sum;
  };
  const auto distance = [&](std::size_t i) { return std::sin(points.angle(i)); };
  // Further out the points lie closer, and resolve more waves.
  for (const std::size_t i : {0U, 2U, 10U}) {
    for (const std::size_t j : {0U, 3U, 30U, 39U}) {
      EXPECT_NEAR(all(i, j) / rings(softness, 5000.0, distance(i), distance(j)), 1.0, 4e-4) << i << ", " << j;
    }
  }
}

TEST(HalfSpace, ResponseBetweenRingsIsThatOfStaticLoads) {
  constexpr double poisson = 0.3;
  const Body body = stoss::half_space(HalfSpace{poisson}, 6.0, 12.0);
  expect_static_response(body, 1.0 - poisson * poisson);
  // Cerruti's, on average over rings.
  expect_static_response(body.along({}).front(), 0.5 * (1.0 + poisson) * (2.0 - poisson));
}

TEST(HalfSpace, ResidualsArePositiveDefinite) {
  for (const double poisson : {-0.5, 0.0, 0.3, 0.4999}) {
    for (const double width : {1e-4, 0.02, 0.5, 1.3}) {
      for (const bool sideways : {false, true}) {
        Body body = stoss::half_space(HalfSpace{poisson}, 8.0, 12.0);
        if (sideways) body = body.along({}).front();
        const ContactPoints points{1.0, width / 48.0, 48};
        const std::vector<double> w = body.residual_compliance(points, {}), v = body.residual_second_moment(points, {});
        using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        const Eigen::Map<const Matrix> compliance(w.data(), 48, 48), moment(v.data(), 48, 48);
        EXPECT_EQ(Eigen::LLT<Matrix>(compliance).info(), Eigen::Success) << poisson << ", " << width;
        EXPECT_LT((compliance - compliance.transpose()).cwiseAbs().maxCoeff(),
                  1e-14 * compliance.cwiseAbs().maxCoeff());
        const Matrix lifted = moment + 1e-12 * moment.trace() * Matrix::Identity(48, 48);
        EXPECT_EQ(Eigen::LLT<Matrix>(lifted).info(), Eigen::Success) << poisson << ", " << width;
      }
    }
  }
}

TEST(HalfSpace, RefusesWhatItCannotBe) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double poisson : {0.5, -1.0, nan, inf}) {
    EXPECT_THROW((void)wave_speeds(Contour::ball, poisson), InvalidInput);
  }
  for (const double poisson : {0.996, -0.96, nan, inf}) {
    EXPECT_THROW((void)wave_speeds(Contour::cylinder, poisson), InvalidInput);
  }
  for (const double bad : {0.0, -1.0, nan, inf}) {
    EXPECT_THROW((void)stoss::half_space(HalfSpace{0.3}, bad, 10.0), InvalidInput);
    EXPECT_THROW((void)stoss::half_space(HalfSpace{0.3}, 10.0, bad), InvalidInput);
  }
  EXPECT_THROW((void)stoss::half_space(HalfSpace{0.3}, 1e6, 1e6), InvalidInput);
}

}  // namespace
}  // namespace stoss::bodies::half_space
