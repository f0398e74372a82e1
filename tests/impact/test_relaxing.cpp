// What may break an impact of bodies that relax.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/state.hpp"

namespace stoss {
namespace {

Contact ball(const Relaxation& relaxation, double cutoff = 16.0, double poisson = 0.3) {
  return contact(relaxing(sphere(poisson, cutoff), relaxation));
}

void expect_sound(const Impact& impact, const char* what) {
  EXPECT_GE(impact.restitution, 0.0) << what;
  EXPECT_LE(impact.restitution, 1.0) << what;
  EXPECT_GE(impact.energy.dissipated, -1e-6) << what;
  EXPECT_GE(impact.energy.lost_to_first, 0.0) << what;
  EXPECT_GE(impact.energy.unresolved, -1e-6) << what;
  EXPECT_GE(impact.energy.stored, -1e-9) << what;
  EXPECT_NEAR(impact.energy_error, 0.0, 1e-3) << what;
}

}  // namespace

TEST(RelaxingImpact, IsSoundForAnyTime) {
  for (double time = 1e-6; time < 1e7; time *= 10.0) {
    for (const double share : {1e-4, 0.3, 0.9}) {
      const Impact its = impact(ball({{{share, time}}}), 0.05);
      expect_sound(its, (std::to_string(share) + ":" + std::to_string(time)).c_str());
    }
  }
}

TEST(RelaxingImpact, IsSoundAtTheLimits) {
  Relaxation twenty;
  for (int j = 0; j < 20; ++j) twenty.terms.push_back({0.04, 1e-4 * std::pow(3.0, j)});
  expect_sound(impact(ball(twenty), 0.1), "twenty terms");
  expect_sound(impact(ball({{{0.3, 1.0}, {0.3, 1.0 + 1e-13}, {0.3, 1.0 + 1e-7}}}), 0.1), "terms that coincide");
  expect_sound(impact(ball({{{0.5, 2.0}}}, 16.0, 0.4999), 0.1), "incompressible");
  expect_sound(impact(ball({{{0.999, 0.5}}}), 0.05), "tan δ of 16");
  expect_sound(impact(ball({{{0.5, 1.0}, {0.5, 4.0}}}), 0.05), "a fluid in the end");
  expect_sound(impact(ball({{{0.97, 3.0}}}), 0.4), "overdamped and fast");
  expect_sound(
      impact(contact(relaxing(disk(0.33, 16.0), {{{0.8, 1.0}}})), 0.1, {.resolution = {.tail = Tail::quasistatic}}),
      "a disk without radiation");
}

// A unit of time of the body measures all: in another size, with times in its R/c, nothing is different.
TEST(RelaxingImpact, DependsOnTimesInItsOwnUnit) {
  const Relaxation its{{{0.4, 0.7}}};
  const Impact small = impact(contact(relaxing(sphere(Sphere{.poisson = 0.3, .radius = 0.01}, 16.0), its)), 0.1);
  const Impact unit = impact(ball(its), 0.1);
  EXPECT_EQ(small.restitution, unit.restitution);
  // Of a pair the times of the second are in R/c of the second.
  const auto pair = [&](double radius) {
    return impact(contact(relaxing(sphere(Sphere{.poisson = 0.3, .radius = 0.5 * radius}, 16.0), its),
                          relaxing(sphere(Sphere{.poisson = 0.3, .radius = radius}, 32.0), its)),
                  0.1);
  };
  EXPECT_EQ(pair(1.0).restitution, pair(3.0).restitution);
}

TEST(RelaxingImpact, DissipatesMoreTheMoreRelaxes) {
  double before = 0.0;
  for (const double share : {0.001, 0.01, 0.1, 0.3, 0.6, 0.9}) {
    const double lost = impact(ball({{{share, 2.0}}}), 0.02).lost_fraction;
    EXPECT_GT(lost, before);
    before = lost;
  }
}

TEST(RelaxingImpact, LetsModesFadeAfterIt) {
  const Contact its = ball({{{0.2, 1.0}}});
  const Impact after = impact(its, 0.1);
  double now = 0.0, later = 0.0;
  for (const double each : mode_energies(its, after.final_state)) now += each;
  for (const double each : mode_energies(its, free_motion(its, after.final_state, 20.0))) later += each;
  EXPECT_GT(now, 0.0);
  EXPECT_LT(later, 0.2 * now);
}

TEST(RelaxingImpact, RefusesTwoLaws) {
  const Body viscous = sphere(Sphere{.poisson = 0.3, .loss_time = 0.1}, 8.0);
  EXPECT_THROW((void)relaxing(viscous, {{{0.5, 1.0}}}), InvalidInput);
  EXPECT_THROW((void)relaxing(rigid(sphere(0.3, 8.0)), {{{0.5, 1.0}}}), InvalidInput);
  EXPECT_THROW((void)relaxing(sphere(0.3, 8.0), {{{1.5, 1.0}}}), InvalidInput);
}

}  // namespace stoss
