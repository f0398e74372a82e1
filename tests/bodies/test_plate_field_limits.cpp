// The field inside plates of which it is known: thick ones are half-spaces until the echo.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/plate/field.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/replay.hpp"

namespace stoss::bodies::plate {
namespace {

/// Displacement inside what a sphere meets, some time after it does.
template <typename Inside>
Field after(double time, double cutoff, const Body& second, const Inside& inside) {
  const Contact meeting = contact(sphere(Sphere{.poisson = 0.3}, cutoff), second);
  const Impact impact = stoss::impact(meeting, 0.1, {}, {.modes = true});
  const ContactGrid grid = contact_grid(meeting, impact.resolution.half_width, impact.resolution.nodes);
  const BodyFrame seen = seen_by(meeting, grid, frames_at(meeting, impact, {time}).front(), 1);
  return inside(seen.points).at(seen.coordinate, seen.node_force);
}

TEST(PlateField, OfAThickPlateIsThatOfAHalfSpaceUntilTheEcho) {
  constexpr double cutoff = 10.0, duration = 12.0, thickness = 3.0;
  const Plate plate{.thickness = thickness, .poisson = 0.3};
  const PlaneGrid points{{0.0, 0.3, 0.8, 1.5}, {0.0, 0.1, 0.3, 0.7, 1.2}};
  const Body whole = stoss::plate(plate, cutoff, duration),
             half = stoss::half_space(HalfSpace{.poisson = 0.3}, cutoff, duration);
  ASSERT_NE(whole.groups.front().omega.size(), half.groups.front().omega.size());
  const double time = (2.0 * thickness - 1.3) / half_space::wave_speeds(Contour::ball, 0.3).pressure;
  const Field one =
      after(time, cutoff, whole, [&](const ContactPoints& at) { return PlateField(plate, whole, at, points); });
  const Field other = after(time, cutoff, half,
                            [&](const ContactPoints& at) { return half_space::HalfSpaceField(0.3, half, at, points); });
  const double greatest = *std::max_element(other.normal.begin(), other.normal.end());
  for (std::size_t i = 0; i < other.normal.size(); ++i) {
    EXPECT_NEAR(one.normal[i], other.normal[i], 3e-3 * greatest) << i;
    EXPECT_NEAR(one.lateral[i], other.lateral[i], 3e-3 * greatest) << i;
  }
}

TEST(PlateField, NothingRunsAheadOfThePressureWave) {
  constexpr double cutoff = 8.0, time = 6.0;
  const Plate plate{.thickness = 1.0, .poisson = 0.3};
  const double front = half_space::wave_speeds(Contour::ball, 0.3).pressure * time;
  const PlaneGrid points{{0.0, 0.3 * front, 1.05 * front, 1.5 * front}, {0.0, 0.5, 1.0}};
  const Body body = stoss::plate(plate, cutoff, 60.0);
  const Field at =
      after(time, cutoff, body, [&](const ContactPoints& its) { return PlateField(plate, body, its, points); });
  const double greatest = *std::max_element(at.normal.begin(), at.normal.end());
  for (std::size_t i = 0; i < points.depth.size(); ++i) {
    EXPECT_GT(std::abs(at.normal[4 * i]), 0.1 * greatest);
    for (const std::size_t j : {4 * i + 2, 4 * i + 3}) {
      EXPECT_NEAR(at.normal[j] / greatest, 0.0, 1e-3) << i;
      EXPECT_NEAR(at.lateral[j] / greatest, 0.0, 1e-3) << i;
    }
  }
}

}  // namespace
}  // namespace stoss::bodies::plate
