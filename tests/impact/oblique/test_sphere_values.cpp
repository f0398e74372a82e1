// Oblique impacts of spheres: against Maw's theory and an independent prototype.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/impact/oblique.hpp"
#include "stoss/restitution/ladder.hpp"
#include "support/refusal.hpp"
#include "support/rings.hpp"

namespace stoss {
namespace {

using test::rings;

/// Maw's κ = 2(1−ν)/(2−ν): ψ = κ s/(μ v_n).
double kappa(double poisson) { return 2.0 * (1.0 - poisson) / (2.0 - poisson); }

/// ψ after the impact of a sphere at a wall.
double psi_after(const SharedNormalImpact& shared, double poisson, double psi) {
  const double unit = shared.normal().speed / kappa(poisson);
  constexpr double friction = 0.3;
  return shared.with({psi * unit * friction, 0.0, 0.0, friction}).sliding_after / (unit * friction);
}

/// Runs of the prototype, whose table agrees with that of another one of another author within 0.004.
TEST(ObliqueSphere, ApproachesMawsCurveLikeTheSizeOfTheContact) {
  struct Case {
    double speed, cutoff;
    std::array<double, 4> after;  // of ψ = 0.5, 1, 2, 3
  };
  for (const Case& its :
       {Case{1e-3, 8.0, {-0.0486, -0.2429, -1.0420, -1.5574}}, Case{1e-4, 8.0, {0.0039, -0.1461, -0.9342, -1.4674}},
        Case{1e-5, 6.0, {0.0282, -0.0993, -0.8818, -1.4196}}, Case{1e-7, 4.0, {0.0441, -0.0674, -0.8460, -1.3876}}}) {
    const SharedNormalImpact shared(contact(sphere(0.3, its.cutoff)), its.speed, rings(40, 0.5 / its.cutoff));
    constexpr std::array before{0.5, 1.0, 2.0, 3.0};
    for (std::size_t k = 0; k < before.size(); ++k) {
      EXPECT_NEAR(psi_after(shared, 0.3, before[k]), its.after[k], 6e-5) << its.speed << ' ' << before[k];
    }
  }
}

TEST(ObliqueSphere, FollowsMawsCurveWhereItIsSlow) {
  struct Case {
    double poisson;
    std::array<double, 6> after;  // of ψ = 0.5, 1, 2, 3, 4, 5
  };
  // ν = 0.3: Maw's equations; the others: extrapolated to contacts of no size.
  for (const Case& its : {Case{0.0, {0.1754, 0.2852, -0.3076, -1.0369, -1.4686, -1.5226}},
                          Case{0.2, {0.1092, 0.0836, -0.6521, -1.2815, -1.5101, -1.1894}},
                          Case{0.3, {0.047, -0.062, -0.838, -1.380, -1.436, -0.764}},
                          Case{0.45, {-0.0856, -0.3240, -1.1100, -1.4210, -0.9677, 0.0323}}}) {
    const SharedNormalImpact shared(contact(sphere(its.poisson, 4.0)), 1e-8, rings(24, 0.125));
    for (std::size_t k = 0; k < its.after.size(); ++k) {
      const double psi = k == 0 ? 0.5 : static_cast<double>(k);
      EXPECT_NEAR(psi_after(shared, its.poisson, psi), its.after[k], 4e-3) << its.poisson << ' ' << psi;
    }
  }
}

TEST(ObliqueSphere, HasTheTangentialRestitutionOfTheFinestRuns) {
  struct Case {
    double speed;
    std::array<double, 6> restitution;  // of ψ = 0.2, 0.5, 1, 2, 3, 4
  };
  for (const Case& its : {Case{0.1, {0.63912, 0.68350, 0.73667, 0.80724, 0.68118, 0.38546}},
                          Case{0.01, {0.22809, 0.31577, 0.43471, 0.63627, 0.58476, 0.40371}},
                          Case{1e-3, {0.00321, 0.09759, 0.24315, 0.52115, 0.51944, 0.38337}}}) {
    const SharedNormalImpact shared(contact(sphere(0.3, 16.0)), its.speed, rings(24, 0.5 / 16.0));
    constexpr std::array before{0.2, 0.5, 1.0, 2.0, 3.0, 4.0};
    for (std::size_t k = 0; k < before.size(); ++k) {
      EXPECT_NEAR(-psi_after(shared, 0.3, before[k]) / before[k], its.restitution[k], 2.5e-3) << its.speed;
    }
  }
}

TEST(ObliqueSphere, ConvergesWithTheSquareOfTheRings) {
  const Contact wall = contact(sphere(0.3, 8.0));
  const auto after = [&](int nodes) {
    return psi_after(SharedNormalImpact(wall, 1e-3, rings(nodes, 0.0625)), 0.3, 0.5);
  };
  const double coarse = after(16), middle = after(32), fine = after(64);
  EXPECT_GT(std::abs(coarse - middle), 3.0 * std::abs(middle - fine));
  EXPECT_LT(std::abs(middle - fine), 5e-4);
}

TEST(ObliqueSphere, MeetsAHalfSpaceOfItsMaterialAsThePrototypeDoes) {
  struct Case {
    double speed, cutoff;
    int nodes;
    double duration, restitution;
    std::array<double, 4> after;  // of ψ = 0.5, 1, 2, 3
  };
  for (const Case& its : {Case{1e-3, 4.0, 24, 40.0, 0.990571, {-0.0083, -0.1665, -0.9456, -1.4685}},
                          Case{0.1, 8.0, 24, 11.0, 0.834804, {-0.1666, -0.4375, -1.1920, -1.4699}}}) {
    const Body plane = half_space(HalfSpace{0.3}, its.cutoff, its.duration);
    const SharedNormalImpact shared(contact(sphere(0.3, its.cutoff), plane), its.speed,
                                    rings(its.nodes, 0.5 / its.cutoff));
    EXPECT_NEAR(shared.normal().restitution, its.restitution, 2e-6);
    constexpr std::array before{0.5, 1.0, 2.0, 3.0};
    for (std::size_t k = 0; k < before.size(); ++k) {
      EXPECT_NEAR(psi_after(shared, 0.3, before[k]), its.after[k], 6e-5) << its.speed << ' ' << before[k];
    }
    const ObliqueImpact one = shared.with({its.speed, -its.speed, 0.0, 0.2});
    EXPECT_LT(one.momentum_error, 1e-13);
    EXPECT_LT(one.angular_momentum_error, 1e-13);
    EXPECT_LT(std::abs(one.energy_error), 2e-4);
    EXPECT_EQ(one.second_spin_after, 0.0);
    EXPECT_GT(one.energy.second_vibration, 0.0);
    test::expect_refusal([&] { (void)shared.with({0.0, 0.0, 0.01, 0.2}); }, {"second_spin"});
  }
}

TEST(ObliqueSphere, MeetsTheNearSideOfAHalfSpaceRigidOrNot) {
  const BodyMaker ball = sphere(0.3), plane = half_space(HalfSpace{0.3});
  const Contact slow = contact(ball, plane, 4.0, 1e-4);  // made for contacts that last so long
  const ObliqueImpact elastic = oblique_impact(slow, 1e-4, {5e-5, 0.0, 0.0, 0.3});
  const ObliqueImpact rigid =
      oblique_impact(contact(stoss::rigid(ball), plane, 4.0, 1e-4), 1e-4, {5e-5, 0.0, 0.0, 0.3});
  EXPECT_LT(std::abs(elastic.energy_error), 1e-4);
  EXPECT_LT(std::abs(rigid.energy_error), 1e-4);
  EXPECT_LT(rigid.restitution, elastic.restitution);
  EXPECT_EQ(rigid.energy.vibration, 0.0);
  EXPECT_GT(rigid.energy.second_vibration, elastic.energy.second_vibration);
}

}  // namespace
}  // namespace stoss
