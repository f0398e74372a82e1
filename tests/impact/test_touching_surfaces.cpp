// Where bodies touch, their displaced surfaces are in one place.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/replay.hpp"
#include "stoss/restitution/ladder.hpp"

namespace stoss {
namespace {

struct Meeting {
  std::string name;
  BodyMaker first, second;
  double cutoff;
};

void PrintTo(const Meeting& meeting, std::ostream* stream) { *stream << meeting.name; }

class TouchingSurfaces : public testing::TestWithParam<Meeting> {};

/// Displacement of the surface of a body at the contact points, towards what it meets, in its own units: by its kept
/// modes and, in their static answer to the forces as far as the material has crept, by all others.
std::vector<double> contact_displacement(const BodyFrame& seen) {
  std::vector<double> displacement = surface_displacement(seen, seen.points);
  const std::vector<double> compliance = residual_compliance(seen);
  const std::size_t count = seen.points.count;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) displacement[i] -= compliance[i * count + j] * seen.crept_force[j];
  }
  return displacement;
}

/// Places of the surface of a body at the contact points, R of the first.
std::vector<double> places(const Contact& contact, const ContactGrid& grid, const Frame& frame, int number) {
  const BodyFrame seen = seen_by(contact, grid, frame, number);
  const std::vector<double> recess = seen.body->surface(seen.points).recess;
  const std::vector<double> displaced = contact_displacement(seen);
  std::vector<double> result(recess.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double out = seen.length * (seen.body->extent - recess[i] + displaced[i]);
    result[i] = center(contact, frame.state, number) + (number == 0 ? out : -out);
  }
  return result;
}

TEST_P(TouchingSurfaces, AreInOnePlace) {
  const Meeting& who = GetParam();
  constexpr double speed = 0.05;
  const Contact meeting = contact(who.first, who.second, who.cutoff, speed);
  // Of the quasistatic tail the surfaces are known to rounding.
  const Impact hit = impact(meeting, speed, {.resolution = {.tail = Tail::quasistatic}});
  const ContactGrid grid = contact_grid(meeting, hit.resolution.half_width, hit.resolution.nodes);
  const std::vector<Frame> frames = frames_at(meeting, hit, {0.25 * hit.contact_time, 0.5 * hit.contact_time});
  for (const Frame& frame : frames) {
    const std::vector<double> one = places(meeting, grid, frame, 0), other = places(meeting, grid, frame, 1);
    const auto touches = [](double force) { return force > 0.0; };
    const auto touching = std::count_if(frame.node_force.begin(), frame.node_force.end(), touches);
    ASSERT_GT(touching, 5);
    // The edge of the contact passes a node gradually.
    for (std::size_t i = 0; i + 2 < static_cast<std::size_t>(touching); ++i) {
      EXPECT_NEAR(one[i], other[i], 1e-9 * hit.max_compression) << who.name << ", node " << i;
    }
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_LT(one[i], other[i] + 1e-9 * hit.max_compression);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Of, TouchingSurfaces,
    testing::Values(
        Meeting{"disks", disk(0.33), disk(Disk{.poisson = 0.2, .radius = 2.0, .young = 3.0}), 20.0},
        Meeting{"disk_half_plane", disk(0.33), half_plane({.poisson = 0.2, .young = 0.5, .density = 2.0}), 8.0},
        Meeting{"spheres", sphere(0.3), sphere(Sphere{.poisson = 0.2, .radius = 0.5, .density = 3.0}), 20.0},
        Meeting{"sphere_half_space", sphere(0.3), half_space({.poisson = 0.2, .young = 0.5, .density = 2.0}), 8.0},
        Meeting{"relaxing_spheres", relaxing(sphere(0.3), {{{0.3, 0.1}, {0.2, 5.0}}}),
                relaxing(sphere(Sphere{.poisson = 0.2, .radius = 0.5, .density = 3.0}), {{{0.5, 1.0}}}), 20.0},
        Meeting{"relaxing_disk_lossy_half_plane", relaxing(disk(0.33), {{{0.3, 0.1}, {0.2, 5.0}}}),
                half_plane({.poisson = 0.2, .young = 0.5, .density = 2.0, .loss_time = 0.1}), 8.0},
        Meeting{"sphere_lossy_half_space", sphere(0.3),
                half_space({.poisson = 0.2, .young = 0.5, .density = 2.0, .loss_time = 0.1}), 8.0}),
    [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace stoss
