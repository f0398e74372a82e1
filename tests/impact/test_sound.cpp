// What is heard of an impact is how the struck point of the replay moves.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/replay.hpp"
#include "stoss/impact/sound.hpp"

namespace stoss {
namespace {

constexpr double interval = 0.05, change = 1e-4;
constexpr std::size_t samples = 8;

/// Velocity of the point on the axis, by differences of where the replay has it.
std::vector<double> replayed(const Contact& contact, const Impact& impact, int number) {
  const double end = static_cast<double>(impact.steps) * impact.resolution.step;
  const ContactGrid grid = contact_grid(contact, impact.resolution.half_width, impact.resolution.nodes);
  std::vector<double> times;
  for (std::size_t i = 0; i < samples; ++i) {
    times.push_back(end + 1.0 + static_cast<double>(i) * interval);
    times.push_back(times.back() + change);
  }
  std::vector<double> place;
  for (const Frame& frame : frames_at(contact, impact, times)) {
    const BodyFrame seen = seen_by(contact, grid, frame, number);
    place.push_back(seen.length * surface_displacement(seen, {.radius = 1.0, .spacing = 1e-6, .count = 1})[0]);
  }
  std::vector<double> velocity;
  for (std::size_t i = 0; i < samples; ++i) velocity.push_back((place[2 * i + 1] - place[2 * i]) / change);
  return velocity;
}

TEST(Sound, IsTheMotionOfTheStruckPoint) {
  const double cutoff = 12.0, time = 1.5 / std::sqrt(0.7 / 1.2);  // R/c of the second, in that of the first
  const Contact pair = contact(sphere(0.3, cutoff), sphere({0.2, 1.5, 0.7, 1.2})(cutoff * time, {}));
  const Impact impact = stoss::impact(pair, 0.1);
  for (const int number : {0, 1}) {
    const SoundOptions options{.body = number, .interval = interval, .count = samples + 20, .quality = 1e12};
    const std::vector<double> heard = sound(pair, impact, options), seen = replayed(pair, impact, number);
    double greatest = 0.0;
    for (const double each : heard) greatest = std::max(greatest, std::abs(each));
    for (std::size_t i = 0; i < samples; ++i) {
      EXPECT_NEAR(heard[i + 20], seen[i], 5e-3 * greatest) << number << ' ' << i;
    }
  }
}

TEST(Sound, DecaysAndLeavesOutWhatSamplesCannotTell) {
  const Contact at_wall = contact(sphere(0.3, 12.0));
  const Impact impact = stoss::impact(at_wall, 0.1);
  const std::vector<double> whole = sound(at_wall, impact, {.interval = interval, .count = 400, .quality = 20.0});
  double early = 0.0, late = 0.0;
  for (std::size_t i = 0; i < 100; ++i) {
    early = std::max(early, std::abs(whole[i]));
    late = std::max(late, std::abs(whole[300 + i]));
  }
  EXPECT_LT(late, 0.6 * early);
  for (const double each : sound(at_wall, impact, {.interval = 3.0, .count = 9})) EXPECT_EQ(each, 0.0);
}

TEST(Sound, RefusesWhatDoesNotRing) {
  const Contact block = contact(sphere(0.3, 12.0), half_space({0.3}, 12.0, 12.0));
  const Impact impact = stoss::impact(block, 0.1);
  EXPECT_THROW((void)sound(block, impact, {.body = 1, .interval = 0.1, .count = 2}), InvalidInput);
  EXPECT_THROW((void)sound(block, impact, {.body = 2, .interval = 0.1, .count = 2}), InvalidInput);
  EXPECT_THROW((void)sound(block, impact, {.interval = 0.0, .count = 2}), InvalidInput);
  EXPECT_THROW((void)sound(block, impact, {.interval = 0.1, .count = 2, .quality = 0.1}), InvalidInput);
}

}  // namespace
}  // namespace stoss
