// Converged oblique impacts of slow spheres: Maw's curve is their limit, reached like the size of the contact.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

#include "stoss/bodies/sphere.hpp"
#include "stoss/quasistatic.hpp"
#include "stoss/restitution/oblique.hpp"

namespace stoss {
namespace oblique_slow_limit {
namespace {

constexpr double friction = 0.3;

/// ψ₂ = κ s′/μv, with its error, of each ψ₁ = κ s/μv.
template <std::size_t count>
std::vector<Estimate> after(double poisson, double speed, const std::array<double, count>& before, double tolerance) {
  const double unit = friction * speed / quasistatic::mindlin_ratio(poisson);
  std::vector<Obliquity> obliquities;
  for (const double psi : before) obliquities.push_back({psi * unit, 0.0, 0.0, friction});
  std::vector<Estimate> result;
  for (const ObliqueRestitution& each :
       oblique_restitution(RefinableContact(sphere(poisson)), speed, obliquities, {.tolerance = tolerance})) {
    EXPECT_TRUE(each.converged);
    result.push_back({each.sliding_after.value / unit, each.sliding_after.error / unit});
  }
  return result;
}

TEST(ObliqueSlowLimit, IsMawsCurve) {
  constexpr double slow = 1e-8, turning = 3.5;  // 1 + mR²/I
  constexpr std::array before{0.2, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0};
  for (const double poisson : {0.0, 0.2, 0.3, 0.45}) {
    const std::vector<Estimate> found = after(poisson, slow, before, 2e-3);
    const double chi = 0.5 * quasistatic::mindlin_ratio(poisson) * turning;
    for (std::size_t k = 0; k < before.size(); ++k) {
      EXPECT_NEAR(found[k].value, quasistatic::maw(before[k], chi).psi2, 0.01) << poisson << ' ' << before[k];
    }
  }
}

// Of an independent program, without the edge law along the surface.
TEST(ObliqueSlowLimit, IsApproachedAsIndependentRunsDo) {
  struct Case {
    double speed;
    std::array<double, 4> after;
  };
  constexpr std::array before{0.5, 1.0, 2.0, 3.0};
  for (const Case& its : {Case{1e-3, {-0.048, -0.243, -1.043, -1.559}}, Case{1e-4, {0.004, -0.146, -0.934, -1.468}},
                          Case{1e-5, {0.028, -0.099, -0.882, -1.420}}, Case{1e-7, {0.044, -0.068, -0.846, -1.388}}}) {
    const std::vector<Estimate> found = after(0.3, its.speed, before, 1e-3);
    for (std::size_t k = 0; k < before.size(); ++k) {
      EXPECT_NEAR(found[k].value, its.after[k], 0.004) << its.speed << ' ' << before[k];
    }
  }
}

}  // namespace
}  // namespace oblique_slow_limit
}  // namespace stoss
