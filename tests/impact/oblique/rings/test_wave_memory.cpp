// What a half-space remembers of past forces, against its waves one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "contact/along.hpp"
#include "impact/kept_modes.hpp"
#include "impact/oblique/rings/wave_memory.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {
namespace {

Contact rigid_ball_along(const HalfSpace& medium) {
  constexpr double cutoff = 6.0, duration = 12.0;
  return contacts_along(contact(rigid(sphere(0.3))(cutoff, {}), half_space(medium, cutoff, duration)), {}).front();
}

TEST(WaveMemory, IsWhatTheWavesDo) {
  const Contact along = rigid_ball_along(HalfSpace{0.3});
  ASSERT_TRUE(remembers_waves(along));
  constexpr double step = 0.5 / 6.0;
  constexpr std::size_t nodes = 16, steps = 100;
  for (const double half_width : {0.02, 0.5}) {
    const ContactGrid grid = contact_grid(along, half_width, nodes);
    KeptModes waves(along, grid, step);
    WaveMemory memory(along, grid, step, steps, {});
    std::vector<double> force(nodes);
    for (std::size_t k = 0; k < steps; ++k) {
      waves.advance();
      memory.advance();
      std::vector<double> moved(nodes), remembered(nodes);
      waves.add_displacement(moved);
      memory.add_displacement(remembered);
      double most = 0.0;
      for (const double each : moved) most = std::max(most, std::abs(each));
      for (std::size_t i = 0; i < nodes; ++i) EXPECT_NEAR(remembered[i], moved[i], 1e-6 * most) << k << ' ' << i;
      const double energy = waves.energy();
      EXPECT_NEAR(memory.energy(), energy, 1e-6 * energy);
      for (std::size_t i = 0; i < nodes; ++i) force[i] = std::sin(0.1 * static_cast<double>(k * (i + 3)));
      waves.load(force, nodes);
      memory.load(force);
    }
    EXPECT_NEAR(memory.energy(), waves.energy(), 1e-6 * waves.energy());  // in the middle of a kick
  }
}

TEST(WaveMemory, IsOfHalfSpacesWithoutLoss) {
  const Contact lossy = rigid_ball_along(HalfSpace{.poisson = 0.3, .loss_time = 0.1});
  EXPECT_FALSE(remembers_waves(lossy));
  const Contact balls = contacts_along(contact(sphere(0.3, 6.0), sphere(0.3, 6.0)), {}).front();
  EXPECT_FALSE(remembers_waves(balls));
}

}  // namespace
}  // namespace stoss
