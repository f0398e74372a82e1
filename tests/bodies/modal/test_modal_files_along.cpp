// Shipped files with a tangent, in documents: a sphere of a mesh rubs as the sphere, and laws that hold of any body.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "stoss/encounter/document.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/restitution/oblique.hpp"
#include "support/body_files.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace modal_files_along {
namespace {

using test::body_of_file;
using test::steel_ball;

Encounter meeting(const std::string& first, const std::string& against) {
  return encounter_from_json(test::meeting_of(first, against));
}

const std::vector<std::string>& partners() {
  static const std::vector<std::string> all{R"("same")", R"({"kind": "half-space", "material": "structural steel"})",
                                            steel_ball("0.02")};
  return all;
}

constexpr double degree = 3.14159265358979323846 / 180.0;

/// Angles from grazing along the normal to along the surface, a spin alone, and frictions from none to that of rubber.
std::vector<Obliquity> obliquities(double speed) {
  std::vector<Obliquity> all;
  for (const double friction : {1e-9, 0.05, 0.3, 1.0}) {
    for (const double angle : {2.0, 20.0, 45.0, 80.0}) {
      all.push_back({speed * std::tan(angle * degree), 0.0, 0.0, friction});
    }
    all.push_back({0.0, speed, 0.0, friction});
  }
  return all;
}

// The mesh lies inside the sphere: its inertia, and the arm of the point, are less by some 1e-5 of themselves.
constexpr double of_shape = 5e-5;

void expect_near(const Estimate& found, const Estimate& exact, double scale, const std::string& what) {
  EXPECT_NEAR(found.value, exact.value, found.error + exact.error + of_shape * scale) << what;
}

void expect_rubs_as_the_sphere(const std::vector<std::string>& all_partners) {
  for (const std::string& against : all_partners) {
    const Encounter of_file = meeting(body_of_file("sphere"), against), itself = meeting(steel_ball("0.01"), against);
    for (const double metres : {0.05, 1.0, 10.0}) {
      const double speed = speed_in_c(itself, metres);
      const std::vector<Obliquity> all = obliquities(speed);
      const auto found = oblique_restitution(refinable(of_file), speed, all);
      const auto exact = oblique_restitution(refinable(itself), speed, all);
      for (std::size_t i = 0; i < all.size(); ++i) {
        const double scale = std::max(std::abs(exact[i].sliding), all[i].friction * speed);
        const std::string what = against + ", " + std::to_string(metres) + " m/s, " + std::to_string(i);
        expect_near(found[i].restitution, exact[i].restitution, 0.0, what);
        expect_near(found[i].sliding_after, exact[i].sliding_after, scale, what);
        expect_near(found[i].tangential_after, exact[i].tangential_after, scale, what);
        expect_near(found[i].spin_after, exact[i].spin_after, scale, what);
        expect_near(found[i].second_spin_after, exact[i].second_spin_after, scale, what);
        expect_near(found[i].friction_loss, exact[i].friction_loss, 1.0, what);
        EXPECT_LT(found[i].sliding_after.error, 0.02 * scale) << what;
      }
    }
  }
}

TEST(ModalFileAlong, SphereOfAMeshRubsAsTheSphereAtAnyAngle) { expect_rubs_as_the_sphere({R"("wall")"}); }

TEST(ModalFileAlong, SphereOfAMeshRubsAsTheSphereOnAnyPartner_long) { expect_rubs_as_the_sphere(partners()); }

/// Two bodies with friction, and by how much a unit of μ, with a normal impulse of 1 + ε, changes what slides.
struct Rubbing {
  std::string name;
  Encounter encounter;
  double sliding_per_friction;  ///< m_r (1/m_t + Σ R²/I), with m_r of the motion along the normal
};

std::vector<Rubbing> rubbing() {
  // A beam of 0.314 kg that is struck in the middle by a ball, and friction along it turns it about its middle.
  const double ball = 7850.0 * 4.0 / 3.0 * 180.0 * degree * 1.25e-7, beam = 0.314;
  const double turning = 0.005 * 0.005 / (beam * (0.04 + 1e-4) / 12.0);
  return {{"sphere", meeting(body_of_file("sphere"), R"("wall")"), 3.5},
          {"spheres", meeting(body_of_file("sphere"), R"("same")"), 3.5},
          {"ball on beam", meeting(steel_ball("0.005"), body_of_file("beam_0")),
           (3.5 / ball + 1.0 / beam + turning) / (1.0 / ball + 1.0 / beam)}};
}

TEST(ModalFileAlong, HoldsCoulombsLawAndKeepsMomentaAndEnergy) {
  for (const Rubbing& its : rubbing()) {
    const double speed = speed_in_c(its.encounter, 0.5);
    for (const ObliqueRestitution& each : oblique_restitution(refinable(its.encounter), speed, obliquities(speed))) {
      const ObliqueImpact& finest = each.finest;
      const double most = each.before.friction * (1.0 + finest.restitution) * speed;
      EXPECT_LE(std::abs(each.finest.impulse), most * (1.0 + 1e-4)) << its.name;
      // With few modes steps are long, and what they gain or lose is in the error of ε.
      EXPECT_LT(std::abs(finest.energy_error), 1e-5 + 2.0 * each.restitution.error) << its.name;
      EXPECT_LT(finest.momentum_error, 1e-12) << its.name;
      EXPECT_LT(finest.angular_momentum_error, 1e-12) << its.name;
      EXPECT_GE(each.friction_loss.value, 0.0) << its.name;
      EXPECT_LE(std::abs(each.sliding_after.value), std::abs(each.sliding)) << its.name;
    }
  }
}

TEST(ModalFileAlong, IsItsMirrorImage) {
  for (const Rubbing& its : rubbing()) {
    const double speed = speed_in_c(its.encounter, 0.5);
    std::vector<Obliquity> all = obliquities(speed);
    const std::size_t half = all.size();
    for (std::size_t i = 0; i < half; ++i) {
      Obliquity other = all[i];
      other.tangential = -other.tangential, other.spin = -other.spin;
      all.push_back(other);
    }
    const auto found = oblique_restitution(refinable(its.encounter), speed, all);
    for (std::size_t i = 0; i < half; ++i) {
      const ObliqueRestitution &one = found[i], &other = found[half + i];
      EXPECT_EQ(one.sliding_after.value, -other.sliding_after.value) << its.name;
      EXPECT_EQ(one.tangential_after.value, -other.tangential_after.value) << its.name;
      EXPECT_EQ(one.spin_after.value, -other.spin_after.value) << its.name;
      EXPECT_EQ(one.sliding_after.error, other.sliding_after.error) << its.name;
      EXPECT_EQ(one.restitution.value, other.restitution.value) << its.name;
      EXPECT_EQ(one.friction_loss.value, other.friction_loss.value) << its.name;
    }
  }
}

// Without friction nothing changes along the surface; with hardly any all slides, and so it does with much at a large
// angle: then s falls by μ (1 + ε) v_n m_r (1/m_t + Σ R²/I), whatever the modes do.
TEST(ModalFileAlong, SlidesAsARigidBodyWhereAllSlides) {
  for (const Rubbing& its : rubbing()) {
    const double speed = speed_in_c(its.encounter, 0.5);
    const auto found = oblique_restitution(refinable(its.encounter), speed,
                                           {{speed, 0.0, 0.0, 0.0},
                                            {speed, 0.0, 0.0, 1e-9},
                                            {20.0 * speed, 0.0, 0.0, 0.3},
                                            {0.0, 20.0 * speed, 0.0, 0.3}});
    EXPECT_EQ(found[0].sliding_after.value, found[0].sliding) << its.name;
    EXPECT_EQ(found[0].friction_loss.value, 0.0) << its.name;
    for (std::size_t i = 1; i < found.size(); ++i) {
      const double unit = found[i].before.friction * speed * (1.0 + found[i].finest.restitution);
      const double rounding = 1e-15 * std::abs(found[i].sliding) / unit;
      const double a = found[i].finest.normal.max_half_width;  // rings lie behind the foremost point
      EXPECT_NEAR((found[i].sliding - found[i].sliding_after.value) / unit, its.sliding_per_friction,
                  (of_shape + a * a) * its.sliding_per_friction + rounding)
          << its.name << i;
    }
  }
}

// Where all sticks, more friction changes nothing.
TEST(ModalFileAlong, DoesNotFeelFrictionThatHoldsAlready) {
  for (const Rubbing& its : rubbing()) {
    const double speed = speed_in_c(its.encounter, 0.5);
    const auto found = oblique_restitution(refinable(its.encounter), speed,
                                           {{0.02 * speed, 0.0, 0.0, 1.0}, {0.02 * speed, 0.0, 0.0, 2.0}});
    const double both = found[0].sliding_after.error + found[1].sliding_after.error;
    EXPECT_NEAR(found[0].sliding_after.value, found[1].sliding_after.value, both) << its.name;
    EXPECT_LT(found[1].friction_loss.value, found[0].friction_loss.value + 1e-6) << its.name;
  }
}

TEST(ModalFileAlong, WithoutATangentIsRefusedButWithoutFriction) {
  const Encounter bell = meeting(steel_ball("0.005"), body_of_file("bell"));
  const double speed = speed_in_c(bell, 0.5);
  test::expect_refusal(
      [&] {
        (void)oblique_restitution(refinable(bell), speed, Obliquity{speed, 0.0, 0.0, 0.1});
      },
      {"friction", "bell", "tangent", "allowed"});
  const ObliqueRestitution smooth = oblique_restitution(refinable(bell), speed, Obliquity{speed, 0.0, 0.0, 0.0});
  EXPECT_EQ(smooth.tangential_after.value, speed);
}

}  // namespace
}  // namespace modal_files_along
}  // namespace stoss
