// Isotropic hardening in the finite elements of studies/yield.
#include <gtest/gtest.h>

#include "yield/indentation.hpp"

namespace {

using namespace yield_study;

TEST(YieldHardening, ReturnsToTheSurfaceThatHasGrown) {
  const Material material{200.0, 0.3, 1.0, 5.0};
  const Stress trial(3.0, -1.0, 0.5, 1.2);
  constexpr double before = 0.02;
  const Returned returned = radial_return(material, trial, before);
  EXPECT_GT(returned.slip, 0.0);
  EXPECT_NEAR(mises(returned.stress), 1.0 + 5.0 * (before + returned.slip), 1e-12);
  EXPECT_NEAR(mises(trial) - mises(returned.stress), 3.0 * material.shear() * returned.slip, 1e-12);
  EXPECT_NEAR(returned.stress.head<3>().sum(), trial.head<3>().sum(), 1e-12);
  EXPECT_EQ(radial_return(material, trial, 1.0).slip, 0.0);
}

TEST(YieldHardening, HasTheTangentOfItsStress) {
  const Material material{200.0, 0.3, 1.0, 20.0};
  const Stress strain(0.012, -0.004, 0.001, 0.009);
  const auto returned = [&](const Stress& of) { return radial_return(material, material.stiffness() * of, 0.01); };
  const Stiffness tangent = returned(strain).tangent;
  EXPECT_LT((tangent - tangent.transpose()).norm(), 1e-10);
  for (int k = 0; k < 4; ++k) {
    Stress step = Stress::Zero();
    step[k] = 1e-7;
    const Stress slope = (returned(strain + step).stress - returned(strain - step).stress) / 2e-7;
    EXPECT_LT((slope - tangent.col(k)).norm(), 1e-5 * material.young) << k;
  }
}

/// A bar of one element follows E H/(E + H) beyond Y. What is done is stored and dissipated.
TEST(YieldHardening, FollowsABarInTension) {
  constexpr double strength = 0.01, hardening = 0.25;
  const Mesh mesh{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, {{0, 1, 2, 3}}};
  Body body(mesh, {1.0, 0.3, strength, hardening}, {{-1}, {-1}, {0}, {-1}, {0}, {1}, {-1}, {1}});
  Newton newton(body);
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(2), values = unknowns;
  double work = 0.0, before = 0.0;
  constexpr double step = 0.001;
  for (int k = 1; k <= 40; ++k) {
    values[1] = step * k;
    solve(body, newton, unknowns, {0, 1}, values, Eigen::VectorXd::Zero(2));
    work += 0.5 * (before + body.forces()[1]) * step;
    before = body.forces()[1];
    const double stress = values[1] <= strength ? values[1] : strength + 0.2 * (values[1] - strength);
    EXPECT_LT((body.stress(0, 0) - Stress(0.0, stress, 0.0, 0.0)).norm(), 1e-9) << k;
  }
  const Energies energies = body.energies();
  EXPECT_NEAR(energies.stored + energies.dissipated, work, 1e-9 * work);
}

/// At small strain nothing but H/E, ν and the depth over that at the onset matters: a tenth of Y is a hundredth of the
/// depth, a tenth of the radius, a thousandth of the force.
TEST(YieldHardening, HasOneGroupMore) {
  const auto force = [](double scale) {
    constexpr int elements = 8, steps = 10;
    constexpr double poisson = 0.3, depth = 5.0, young = 1.0 - poisson * poisson;
    const double element = scale * 2.5 / elements;
    const Grid grid{10.0 * element, element, 1.4, scale * 40.0};
    Indentation indentation(half_space({young, poisson, 0.4 * scale, 0.03 * young}, grid), 1.0);
    double last = 0.0;
    for (int k = 1; k <= steps; ++k) last = indentation.go(scale * scale * depth * k / steps).force;
    return last / (scale * scale * scale);
  };
  EXPECT_NEAR(force(0.1) / force(1.0), 1.0, 1e-7);
}

}  // namespace
