// A half-plane against forces along its surface: sum rules of its waves, and its static response.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "bodies/half_space/plane/waves.hpp"
#include "stoss/bodies/half_space.hpp"

namespace stoss {
namespace half_plane_along {
namespace {

using bodies::Flexibility;

constexpr double pi = std::numbers::pi;
constexpr double cutoff = 10.0, duration = 10.0;
constexpr double poissons[] = {-0.5, 0.0, 0.33, 0.9};

class HalfPlaneAlong : public ::testing::TestWithParam<double> {
 protected:
  const bodies::half_space::Medium medium = bodies::half_space::medium(Contour::cylinder, GetParam());
  const Body plane = half_plane(HalfPlane{GetParam()}, cutoff, duration);
  const std::vector<Body> along = plane.along({});
};

// What all waves of a wave number make of slow forces is known in closed form, in both directions and between them.
TEST_P(HalfPlaneAlong, HasTheWavesOfItsStaticResponse) {
  using namespace bodies::half_space;
  for (const bodies::PlaneWaves& waves : plane_waves(medium, cutoff, duration, {})) {
    Flexibility slow = waves.residual_compliance, moment = waves.residual_second_moment;
    for (std::size_t l = 0; l < waves.omega.size(); ++l) {
      const double share = 1.0 / (waves.omega[l] * waves.omega[l]);
      const double normal = waves.normal[l], other = waves.along[l];
      const Flexibility its{share * normal * normal, share * normal * other, share * other * other};
      slow = {slow.radial + its.radial, slow.mixed + its.mixed, slow.tangential + its.tangential};
      moment = {moment.radial + share * its.radial, moment.mixed + share * its.mixed,
                moment.tangential + share * its.tangential};
    }
    const Flexibility all = plane_compliance(medium, waves.wave_number);
    const Flexibility second = plane_second_moment(medium, waves.wave_number);
    const double weight = slow.radial / all.radial;
    EXPECT_NEAR(slow.tangential, weight * all.tangential, 1e-3 * slow.radial);
    EXPECT_NEAR(slow.mixed, weight * all.mixed, 1e-3 * slow.radial);
    EXPECT_NEAR(moment.radial, weight * second.radial, 1e-3 * moment.radial);
    EXPECT_NEAR(moment.tangential, weight * second.tangential, 1e-3 * moment.radial);
    EXPECT_NEAR(moment.mixed, weight * second.mixed, 1e-3 * moment.radial);
  }
}

TEST_P(HalfPlaneAlong, AnswersNormalForcesAsByItself) {
  const ContactPoints points{1.0, 0.02, 9};
  const std::vector<double> alone = plane.residual_compliance(points, {});
  const std::vector<double> both = along[0].residual_compliance(points, {});
  const std::vector<double> moment = plane.residual_second_moment(points, {});
  const std::vector<double> moments = along[0].residual_second_moment(points, {});
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t j = 0; j < 9; ++j) {
      EXPECT_NEAR(both[i * 18 + j], alone[i * 9 + j], 1e-12 * alone[0]);
      EXPECT_NEAR(moments[i * 18 + j], moment[i * 9 + j], 1e-12 * moment[0]);
    }
  }
}

// A force along y moves y by −(2/π) ln r, and a normal one moves it to the side by (1 − ν)/2: of a pair of lines on
// both sides of the axis, each with half of the force, what is between them.
TEST_P(HalfPlaneAlong, AnswersSlowForcesAsAStaticSurface) {
  const ContactPoints points{1.0, 0.004, 12};
  const std::size_t n = points.count;
  for (std::size_t kind = 0; kind < 2; ++kind) {
    const Body& each = along[kind];
    validate(each);
    const Surface surface = each.surface(points);
    std::vector<double> slow = each.residual_compliance(points, {});
    for (const ModeGroup& group : each.groups) {
      for (std::size_t l = 0; l < group.omega.size(); ++l) {
        std::vector<double> moved(2 * n);
        for (std::size_t i = 0; i < 2 * n; ++i) {
          moved[i] = group.upper[l] * surface.shape[group.upper_row * 2 * n + i] +
                     group.lower[l] * surface.shape[group.lower_row * 2 * n + i];
        }
        const double share = 1.0 / (group.omega[l] * group.omega[l]);
        for (std::size_t i = 0; i < 2 * n; ++i) {
          for (std::size_t j = 0; j < 2 * n; ++j) slow[i * 2 * n + j] += share * moved[i] * moved[j];
        }
      }
    }
    const auto y = [&](std::size_t i) { return std::sin(points.angle(i)); };
    const auto line = [&](std::size_t i, std::size_t j, double sign) {
      return -std::log(std::abs(y(i) - y(j))) - sign * std::log(y(i) + y(j));
    };
    const std::size_t i = 2, j = 9, k = 6, at = 2 * n;
    // Differences, as the whole has no end: of even components.
    EXPECT_NEAR(slow[i * at + j] - slow[i * at + k], (line(i, j, 1.0) - line(i, k, 1.0)) / pi, 3e-3);
    // Odd ones have one.
    EXPECT_NEAR(slow[(n + i) * at + n + j], line(i, j, -1.0) / pi, 3e-3);
    // The mixed response is a step: a point between the loads is moved by them, one beyond is not.
    const double step = (kind == 0 ? 1.0 : -1.0) * 0.5 * (1.0 - GetParam());
    EXPECT_NEAR(slow[i * at + n + j], step, 0.05);
    EXPECT_NEAR(slow[j * at + n + i], 0.0, 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, HalfPlaneAlong, ::testing::ValuesIn(poissons),
                         [](const auto& its) { return "number" + std::to_string(its.index); });

}  // namespace
}  // namespace half_plane_along
}  // namespace stoss
