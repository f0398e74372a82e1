// Lossy bodies of which pressure waves are much faster than all others: nearly incompressible spheres, disks of ν near
// 1 and of ν near −1. A kick moves their kept modes further than the others follow within a step.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss {
namespace {

/// A sphere or a disk in its own units, and its 1 − ε² from a single impact at the cutoff 226 (160 in the second last
/// digits agree), steps of 0.3/226 and 1.6 times the nodes of `restitution` there.
struct Lossy {
  std::string name;
  BodyMaker body;
  double speed;
  double lost_fraction;
  long most_steps;  // of all runs
};

BodyMaker lossy_sphere(double poisson, double loss_time) {
  return sphere(Sphere{.poisson = poisson, .loss_time = loss_time});
}

BodyMaker lossy_disk(double poisson, double loss_time) {
  return disk(Disk{.poisson = poisson, .loss_time = loss_time});
}

// Rubber of E = 2 MPa, ν = 0.49, ρ = 1100 kg/m³, Q = 10 at 500 Hz: η = 3.183e-5 s, c = 42.64 m/s.
const std::vector<Lossy> cases{
    {"rubber of 5 cm at 0.3 m/s", lossy_sphere(0.49, 0.0271443), 0.00703561, 0.02861883, 6500},
    {"rubber of 2 cm at 0.3 m/s", lossy_sphere(0.49, 0.0678607), 0.00703561, 0.06605718, 4000},
    {"rubber of 2 cm at 0.8 m/s", lossy_sphere(0.49, 0.0678607), 0.0187616, 0.08716251, 3000},
    {"rubber of 2 cm at 2 m/s", lossy_sphere(0.49, 0.0678607), 0.0469041, 0.11868599, 1500},
    {"a sphere that loses little", lossy_sphere(0.49, 0.01), 0.001, 0.00669760, 18000},
    {"a slow disk", lossy_disk(0.99, 0.0271), 0.01, 0.08767609, 2500},
    {"a fast disk", lossy_disk(0.99, 0.0271), 0.1, 0.29902320, 1500},
};

TEST(LossyIncompressible, ConvergesToWhatFinerRunsGive) {
  for (const auto& [name, body, speed, lost, most_steps] : cases) {
    SCOPED_TRACE(name);
    const Restitution result = restitution(body, speed);
    EXPECT_TRUE(result.converged);
    EXPECT_NEAR(result.lost_fraction.value, lost, result.lost_fraction.error);
    EXPECT_LE(result.lost_fraction.error, 1e-3 * lost);
    EXPECT_LE(result.steps, most_steps);
    for (const auto& run : result.runs) {
      EXPECT_GT(run.dissipated, 0.0);
      EXPECT_LT(std::abs(run.energy_error), 0.015 * lost);
    }
  }
}

TEST(LossyIncompressible, BallMeetsStifferLossyHalfSpace) {
  const RefinableContact contact(
      sphere(Sphere{.poisson = 0.4999}),
      half_space(HalfSpace{.poisson = 0.3, .young = 30.0, .density = 0.02, .loss_time = 10.0}));
  // The same with 1.6 times the nodes and half the step, at cutoffs of 64 and 90: 0.03098149, 0.03098166.
  const Restitution result = restitution(contact, 0.01);
  EXPECT_TRUE(result.converged);
  EXPECT_NEAR(result.lost_fraction.value, 0.03098166, result.lost_fraction.error);
  EXPECT_LE(result.steps, 13000);
}

TEST(LossyIncompressible, AnyStepIsStable) {
  constexpr double cutoff = 53.8, speed = 0.00703561, lost = 0.0286110, force = 2.23582e-3;  // with 0.1/cutoff
  const Body body = lossy_sphere(0.49, 0.0271443)(cutoff, {});
  for (const double step : {0.25, 0.5, 1.0}) {
    const Resolution resolution{.step = step / cutoff, .nodes = 120, .half_width = 0.1857};
    const Impact result = impact(body, HardWall{}, speed, {.resolution = resolution});
    EXPECT_NEAR(result.lost_fraction, lost, 2e-4 * step * lost) << step;
    EXPECT_NEAR(result.max_force, force, 1e-4 * step * force) << step;
    EXPECT_EQ(result.contacts, 1) << step;
  }
}

TEST(LossyIncompressible, ContactInManyPiecesIsSolved) {
  // Its edge is faster than all waves but those of pressure, and the surface wavy at the scale of the cutoff.
  const Body body = lossy_sphere(0.4995, 0.001)(32.0, {});
  for (const double step : {0.08, 0.15}) {
    const Resolution resolution{.step = step / 32.0, .nodes = 80, .half_width = 0.8};
    const Impact result = impact(body, HardWall{}, 0.2, {.resolution = resolution});
    EXPECT_NEAR(result.lost_fraction, 0.114287, 1e-5) << step;
  }
}

}  // namespace
}  // namespace stoss
