// Stress from displacements: fields whose strains are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "stoss/bodies/half_space/stress.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::half_space {
namespace {

const PlaneGrid grid{{0.0, 0.1, 0.15, 0.4, 1.0}, {0.0, 0.2, 0.3, 0.9}};

using Component = std::function<double(double distance, double depth)>;

Field field(const Component& lateral, const Component& normal) {
  Field made;
  for (const double depth : grid.depth) {
    for (const double distance : grid.distance) {
      made.lateral.push_back(lateral(distance, depth));
      made.normal.push_back(normal(distance, depth));
    }
  }
  return made;
}

TEST(HalfSpaceStress, OfAnEvenCompressionIsItsModulusTimesTheStrain) {
  // One stress along z: u_z = −εz, u_r = νεr.
  constexpr double nu = 0.3, strain = 1e-3;
  const Field pressed =
      field([](double r, double) { return nu * strain * r; }, [](double, double z) { return -strain * z; });
  for (const Contour contour : {Contour::ball, Contour::cylinder}) {
    const Stress its = stress(contour, nu, grid, pressed);
    ASSERT_EQ(its.von_mises.size(), grid.depth.size() * grid.distance.size());
    for (const double each : its.von_mises) EXPECT_NEAR(each, strain, 1e-15);
    for (const double each : its.principal_difference) EXPECT_NEAR(each, strain, 1e-15);
  }
}

TEST(HalfSpaceStress, OfShearThatGrowsIsExactWhereTheFieldIsAParabola) {
  // u_z = s r²: 2ε_rz = 2 s r, and nothing else.
  constexpr double nu = 0.2, growth = 1e-2, mu = 0.5 / (1.0 + nu);
  const Stress its = stress(Contour::ball, nu, grid,
                            field([](double, double) { return 0.0; }, [](double r, double) { return growth * r * r; }));
  for (std::size_t k = 0; k < its.von_mises.size(); ++k) {
    const double shear = mu * 2.0 * growth * grid.distance[k % grid.distance.size()];
    EXPECT_NEAR(its.von_mises[k], std::sqrt(3.0) * shear, 1e-15);
    EXPECT_NEAR(its.principal_difference[k], 2.0 * shear, 1e-15);
  }
}

TEST(HalfSpaceStress, OfAnEvenPressureIsNone) {
  const Field pressed = field([](double r, double) { return -0.1 * r; }, [](double, double z) { return -0.1 * z; });
  for (const double each : stress(Contour::ball, 0.3, grid, pressed).von_mises) EXPECT_NEAR(each, 0.0, 1e-14);
}

TEST(HalfSpaceStress, OfLayersIsThatOfTheirOwnModuliAndNoDerivativeGoesAcrossAFace) {
  // The same stress along z in both layers, of which the lower one gives way ten times as much.
  constexpr double face = 0.3, strain = 1e-3, soft = 0.1;
  const PlaneGrid points{grid.distance, {0.0, 0.1, 0.2, face, 0.5, 0.9}};
  Field pressed;
  for (const double depth : points.depth) {
    for (std::size_t j = 0; j < points.distance.size(); ++j) {
      pressed.lateral.push_back(0.0);
      pressed.normal.push_back(-strain * (std::min(depth, face) + std::max(0.0, depth - face) / soft));
    }
  }
  const std::vector<ElasticLayer> layers{{face, 0.0, 1.0}, {1.0, 0.0, soft}};
  for (const double each : stress(Contour::ball, layers, points, pressed).von_mises) EXPECT_NEAR(each, strain, 1e-15);
}

TEST(HalfSpaceStress, RefusesPointsThatHaveNoParabola) {
  const Field still = field([](double, double) { return 0.0; }, [](double, double) { return 0.0; });
  EXPECT_THROW((void)stress(Contour::ball, 0.3, {grid.distance, {0.0, 0.1}}, still), InvalidInput);
  EXPECT_THROW((void)stress(Contour::ball, 0.3, {grid.distance, {0.0, 0.2, 0.2, 0.9}}, still), InvalidInput);
  EXPECT_THROW((void)stress(Contour::ball, 0.3, {{0.0, 0.1, 0.2}, grid.depth}, still), InvalidInput);
}

}  // namespace
}  // namespace stoss::bodies::half_space
