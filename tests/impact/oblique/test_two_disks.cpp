// Oblique impacts of two disks, and of a disk on a half-plane.
#include <gtest/gtest.h>

#include <cmath>

#include "impact/oblique/resolved.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/oblique.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace two_oblique_disks {
namespace {

using test::resolved;

// Equal bodies press each other as a wall does at half the speed, whatever they do along their surfaces.
TEST(ObliqueDisks, OfOneKindDoNotMixDirections) {
  const Contact pair = contact(disk(0.33, 16.0), disk(0.33, 16.0));
  ImpactOptions options = resolved(pair, 32);
  options.resolution.half_width = 0.58229;
  const double alone = impact(pair, 0.2, options).restitution;
  const ObliqueImpact rough = oblique_impact(pair, 0.2, {0.1, 0.0, 0.0, 1.0}, options);
  const ObliqueImpact smooth = oblique_impact(pair, 0.2, {0.2, 0.0, 0.0, 0.3}, options);
  EXPECT_NEAR(rough.restitution, alone, 1e-12);
  EXPECT_NEAR(smooth.restitution, alone, 1e-12);
  // Of an independent program.
  EXPECT_NEAR(rough.tangential_restitution, 0.38502970, 1e-7);
  EXPECT_NEAR(smooth.tangential_restitution, 0.51709884, 1e-7);
  EXPECT_NEAR(rough.energy.friction, 0.029566, 1e-5);
  EXPECT_NEAR(rough.spin_after, rough.second_spin_after, 1e-14);
  EXPECT_NEAR(rough.spin_after, -0.046033, 1e-6);
  EXPECT_NEAR(rough.tangential_after, 0.053562, 1e-6);
}

// Until waves are back a great disk is a half-plane, but for its curvature: both are computed in quite different ways.
TEST(ObliqueDisks, MeetAHalfPlaneAsAGreatDisk) {
  constexpr double cutoff = 6.0, poisson = 0.1, young = 2.0;
  const double unit = std::sqrt(young);
  struct Outcome {
    double normal, along;  // impulses
  };
  const auto outcome = [&](const Body& second) {
    const Contact pair = contact(disk(0.33, cutoff), second);
    ImpactOptions options = resolved(pair, 24, 0.25);
    options.resolution.half_width = 0.36;
    const ObliqueImpact impact = oblique_impact(pair, 0.05, {0.003, 0.0, 0.0, 0.1}, options);
    EXPECT_LT(std::abs(impact.energy_error), 1e-4);
    EXPECT_LT(impact.angular_momentum_error, 1e-13);
    return Outcome{(1.0 + impact.restitution) * pair.mass, impact.impulse * pair.mass};
  };
  const Outcome plane = outcome(half_plane(HalfPlane{poisson, young}, cutoff / unit, 14.0 * unit));
  double last_normal = 1.0, last_along = 1.0;
  for (const double radius : {6.0, 12.0, 24.0}) {
    const Outcome great = outcome(disk(Disk{poisson, radius, young}, cutoff / unit * radius));
    const double normal = std::abs(great.normal / plane.normal - 1.0),
                 along = std::abs(great.along / plane.along - 1.0);
    EXPECT_LT(normal, 0.5 * last_normal);
    EXPECT_LT(along, 0.5 * last_along);
    last_normal = normal;
    last_along = along;
  }
  EXPECT_LT(last_normal, 5e-4);
  EXPECT_LT(last_along, 1e-2);
}

// The near side of a greater disk answers as the whole, but for its curvature, 1/size − 1: along the surface that
// matters more than along the normal.
TEST(ObliqueDisks, MeetTheNearSideOfAGreatOneAsTheWhole) {
  constexpr double cutoff = 8.0, radius = 12.0;
  const double unit = std::sqrt(2.0) / radius;
  const Body great = disk(Disk{0.1, radius, 2.0}, cutoff / unit);
  const auto outcome = [&](const Body& second) {
    const Contact pair = contact(disk(0.33, cutoff), second);
    ImpactOptions options = resolved(pair, 24, 0.25);
    options.resolution.half_width = 0.36;
    return oblique_impact(pair, 0.05, {0.01, 0.01, 0.002, 0.3}, options);
  };
  const ObliqueImpact whole = outcome(great);
  const auto part = [&](double size) { return outcome(great.near_side(size, cutoff / unit, {})); };
  EXPECT_NEAR(part(1.0).tangential_restitution, whole.tangential_restitution, 1e-12);
  for (const double size : {0.8, 0.4}) {
    const ObliqueImpact near = part(size);
    const double bent = 1.0 / size - 1.0;
    EXPECT_NEAR(near.restitution, whole.restitution, 2e-3 * bent);
    EXPECT_NEAR(near.tangential_restitution, whole.tangential_restitution, 2.5e-2 * bent);
    EXPECT_NEAR(near.second_spin_after, whole.second_spin_after, 1e-5 * bent);
    EXPECT_NEAR(near.energy.second_vibration, whole.energy.second_vibration, 1e-3 * bent);
    EXPECT_NEAR(near.normal.max_force, whole.normal.max_force, 1e-2 * whole.normal.max_force * bent);
    EXPECT_LT(std::abs(near.energy_error), 2e-5);
  }
  EXPECT_THROW((void)part(0.1), NotConverged);  // its echo is back before the end
}

TEST(ObliqueDisks, DoNotOutlastAHalfPlane) {
  const Contact pair = contact(disk(0.33, 8.0), half_plane(HalfPlane{0.33}, 8.0, 5.0));
  EXPECT_THROW((void)oblique_impact(pair, 0.05, {0.01, 0.0, 0.0, 0.3}, resolved(pair, 16)), NotConverged);
  test::expect_refusal([&] { (void)oblique_impact(pair, 0.05, {0.01, 0.0, 0.01, 0.3}); }, {"second_spin"});
}

// Of an independent program, which lets plane waves of one direction carry motion of the other, too.
TEST(ObliqueDisks, OfTwoKindsAreThoseOfAnotherProgram) {
  const Contact pair = contact(disk(0.33, 16.0), disk(Disk{0.1, 1.0, 3.0, 2.0}, 16.0 / std::sqrt(1.5)));
  const ObliqueImpact impact = oblique_impact(pair, 0.1, {0.1, 0.0, 0.0, 0.3}, resolved(pair, 32));
  EXPECT_NEAR(impact.restitution, 0.963607, 1e-5);
  EXPECT_NEAR(impact.tangential_restitution, 0.495509, 1e-4);
  EXPECT_NEAR(impact.tangential_after, 0.049836, 1e-5);
  EXPECT_NEAR(impact.spin_after, -0.066258, 1e-5);
  EXPECT_NEAR(impact.second_spin_after, -0.033129, 1e-5);
}

TEST(ObliqueDisks, OfOneLossyKindDoNotMixDirections) {
  Disk lossy{0.33};
  lossy.loss_time = 0.05;
  const Contact pair = contact(disk(lossy, 16.0), disk(lossy, 16.0));
  const auto restitution = [&](double friction, double tangential) {
    return oblique_impact(pair, 0.2, {tangential, 0.0, 0.0, friction}, resolved(pair, 24)).restitution;
  };
  EXPECT_NEAR(restitution(1.0, 0.1), restitution(0.2, 0.2), 1e-11);
  EXPECT_NEAR(restitution(1.0, 0.1), impact(pair, 0.2, resolved(pair, 24)).restitution, 1e-5);
}

}  // namespace
}  // namespace two_oblique_disks
}  // namespace stoss
