// Bodies by their modes at a point against friction: a sphere that is given in this way rubs as the sphere.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/modal_body.hpp"
#include "stoss/bodies/plate.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/quasistatic/oblique/maw.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/restitution/oblique.hpp"
#include "support/modal_sphere.hpp"

namespace stoss {
namespace modal_along {
namespace {

struct Meeting {
  const char* what;
  std::function<RefinableContact(const BodyMaker&)> with;
};

const std::vector<Meeting>& meetings() {
  static const std::vector<Meeting> all{
      {"a wall", [](const BodyMaker& body) { return RefinableContact(body); }},
      {"a half-space",
       [](const BodyMaker& body) {
         return RefinableContact(body, half_space(HalfSpace{0.2, 0.5, 0.8}));
       }},
      {"a plate",
       [](const BodyMaker& body) {
         return RefinableContact(body, plate(Plate{1.0, 0.3}));
       }},
      {"its like", [](const BodyMaker& body) { return RefinableContact(body, body); }},
      {"a smaller sphere",
       [](const BodyMaker& body) {
         return RefinableContact(sphere(Sphere{0.2, 0.5}), body);
       }},
  };
  return all;
}

/// Several angles and frictions, and a spin in place of a velocity. @param kappa softness along over that across
std::vector<Obliquity> obliquities(double speed, double kappa) {
  std::vector<Obliquity> all;
  for (const double friction : {0.1, 0.5}) {
    for (const double psi : {0.3, 1.0, 2.0, 4.0}) all.push_back({psi * friction * speed / kappa, 0.0, 0.0, friction});
  }
  all.push_back({0.0, 0.5 * speed, 0.0, 0.3});
  return all;
}

double kappa_of(double poisson) { return 2.0 * (1.0 - poisson) / (2.0 - poisson); }

void expect_near(const Estimate& found, const Estimate& expected) {
  EXPECT_NEAR(found.value, expected.value, found.error + expected.error);
}

void expect_rubs_as_the_sphere(const std::vector<double>& ratios, const std::vector<double>& speeds) {
  for (const Meeting& meeting : meetings()) {
    for (const double poisson : ratios) {
      for (const double speed : speeds) {
        const std::vector<Obliquity> all = obliquities(speed, kappa_of(poisson));
        const auto exact = oblique_restitution(meeting.with(sphere(poisson)), speed, all);
        for (const double complete_to : {6.0, 16.0}) {
          for (const bool bends : {true, false}) {
            const BodyMaker body = modal_body(test::modal_sphere_along(poisson, complete_to, bends));
            const auto found = oblique_restitution(meeting.with(body), speed, all);
            for (std::size_t i = 0; i < all.size(); ++i) {
              SCOPED_TRACE(std::string(meeting.what) + ", nu " + std::to_string(poisson) + ", v " +
                           std::to_string(speed) + ", up to " + std::to_string(complete_to) +
                           (bends ? ", " : ", pistons, ") + std::to_string(i));
              ASSERT_GE(found[i].runs.size(), 2U) << found[i].reason;
              expect_near(found[i].restitution, exact[i].restitution);
              expect_near(found[i].tangential_restitution, exact[i].tangential_restitution);
              expect_near(found[i].sliding_after, exact[i].sliding_after);
              expect_near(found[i].tangential_after, exact[i].tangential_after);
              expect_near(found[i].spin_after, exact[i].spin_after);
              expect_near(found[i].second_spin_after, exact[i].second_spin_after);
              expect_near(found[i].friction_loss, exact[i].friction_loss);
              // The bars hold what is not known of other bodies; of a sphere it is much closer.
              const double scale = std::max(all[i].friction * speed, exact[i].sliding);
              const double off = std::abs(found[i].sliding_after.value - exact[i].sliding_after.value);
              EXPECT_LT(off, (speed < 2e-3 && bends ? 2e-3 : 1e-2) * scale);
            }
          }
        }
      }
    }
  }
}

TEST(ModalBodyAlong, OfASphereRubsAsTheSphereWithinBothErrors_long) { expect_rubs_as_the_sphere({0.3}, {1e-3}); }

TEST(ModalBodyAlong, OfAnySphereRubsAsTheSphereWithinBothErrors_long) {
  expect_rubs_as_the_sphere({0.0, 0.3, 0.45}, {1e-5, 1e-4, 1e-3, 1e-2});
}

// Slow spheres tend to the curve of Maw, Barber and Fawcett as (a/R) ln(R/a).
TEST(ModalBodyAlong, TendsToMawsCurve) {
  constexpr double poisson = 0.3, friction = 0.2;
  const RefinableContact wall(modal_body(test::modal_sphere_along(poisson, 5.0)));
  const auto sliding_after = [&](double speed, double psi) {
    const double unit = friction * speed / kappa_of(poisson);
    return oblique_restitution(wall, speed, {psi * unit, 0.0, 0.0, friction}).sliding_after.value / unit;
  };
  const double chi = 0.5 * kappa_of(poisson) * 3.5;
  for (const double psi : {0.5, 1.0, 2.0, 3.0}) {
    const double limit = quasistatic::maw(psi, chi).psi2;
    const double slow = std::abs(sliding_after(1e-7, psi) - limit), fast = std::abs(sliding_after(1e-5, psi) - limit);
    EXPECT_LT(slow, 0.012) << psi;
    EXPECT_LT(slow, 0.4 * fast) << psi;
  }
}

TEST(ModalBodyAlong, IsItsMirrorImage) {
  const RefinableContact wall(modal_body(test::modal_sphere_along(0.3, 8.0)));
  const auto both = oblique_restitution(wall, 1e-3, {{4e-4, 3e-4, 0.0, 0.3}, {-4e-4, -3e-4, 0.0, 0.3}});
  EXPECT_EQ(both[0].sliding_after.value, -both[1].sliding_after.value);
  EXPECT_EQ(both[0].spin_after.value, -both[1].spin_after.value);
  EXPECT_EQ(both[0].tangential_after.value, -both[1].tangential_after.value);
  EXPECT_EQ(both[0].sliding_after.error, both[1].sliding_after.error);
  EXPECT_EQ(both[0].tangential_restitution.value, both[1].tangential_restitution.value);
}

// Its normal motion is that of the central impact, whatever is known of the other direction, at other cutoffs.
TEST(ModalBodyAlong, HasTheNormalRestitutionOfTheCentralImpact) {
  const RefinableContact wall(modal_body(test::modal_sphere_along(0.3, 12.0)));
  const ObliqueRestitution oblique = oblique_restitution(wall, 1e-3, {4e-4, 0.0, 0.0, 0.3});
  const Restitution central = best_restitution(wall, 1e-3, {});
  EXPECT_NEAR(oblique.restitution.value, central.restitution.value,
              oblique.restitution.error + central.restitution.error);
  EXPECT_LT(oblique.restitution.error, 10.0 * central.restitution.error);
}

}  // namespace
}  // namespace modal_along
}  // namespace stoss
