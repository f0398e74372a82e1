// The field inside plates of which it is known: thin ones bend, thick ones are half-spaces until the echo.
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
#include "support/field_tools.hpp"

namespace stoss::bodies::plate {
namespace {

TEST(PlateField, OfLongWavesBendsOrStretches) {
  // A bending wave: u_z as good as uniform, u_r = −(z − h/2) ∂u_z/∂r. A stretching one: u_r uniform, and the faces move
  // against each other.
  constexpr double thickness = 0.1;
  const Plate plate{.thickness = thickness, .poisson = 0.3};
  const Body body = stoss::plate(plate, 2.0, 10.0);
  const ContactPoints contact{1.0, 0.025, 4};
  const std::vector<double> none(contact.count, 0.0);
  constexpr double across = 0.01;
  const PlateField field(plate, body, contact, {test::stencil(1.0, across), {0.0, 0.5 * thickness, thickness}});
  std::size_t k = 0, bending = 0, stretching = 0;
  for (const ModeGroup& group : body.groups) {
    const double small = group.wave_number * thickness;
    for (const double omega : group.omega) {
      std::vector<double> coordinate(mode_count(body), 0.0);
      coordinate[k++] = 1.0;
      if (small > 0.2) continue;
      const Field at = field.at(coordinate, none);
      double size = 0.0;
      for (std::size_t i = 0; i < 27; ++i) size = std::max({size, std::abs(at.lateral[i]), std::abs(at.normal[i])});
      const double slow = group.wave_number * group.wave_number * thickness / std::sqrt(12.0 * (1.0 - 0.09));
      if (std::abs(omega - slow) < 0.2 * slow) {
        ++bending;
        const double slope = test::derivative(at.normal, 0, 1, across);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(at.normal[9 * i + 4], at.normal[4], small * small * size);
        EXPECT_NEAR(at.lateral[4], 0.5 * thickness * slope, small * small * size);
        EXPECT_NEAR(at.lateral[9 + 4], 0.0, 1e-9 * size);
        EXPECT_NEAR(at.lateral[18 + 4], -at.lateral[4], 1e-9 * size);
      } else {
        ++stretching;
        EXPECT_NEAR(omega, group.wave_number / std::sqrt(1.0 - 0.09), small * group.wave_number);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(at.lateral[9 * i + 4], at.lateral[4], small * small * size);
        EXPECT_NEAR(at.normal[9 + 4], 0.0, 1e-7 * size);
        EXPECT_NEAR(at.normal[18 + 4], -at.normal[4], 1e-7 * size);
      }
    }
  }
  EXPECT_GT(bending, 5U);
  EXPECT_GT(stretching, 5U);
}

/// Displacement inside what a sphere meets, some time after it does.
template <typename Inside>
Field after(double time, double cutoff, const Body& second, const Inside& inside) {
  const Contact meeting = contact(sphere(Sphere{.poisson = 0.3}, cutoff), second);
  const Impact impact = stoss::impact(meeting, 0.1, {}, {.modes = true});
  const ContactGrid grid = contact_grid(meeting, impact.resolution.half_width, impact.resolution.nodes);
  const BodyFrame seen = seen_by(meeting, grid, motion(meeting, impact, {time}).front(), 1);
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
