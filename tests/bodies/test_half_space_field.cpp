// The field below the surface of a half-space: each wave obeys Newton and leaves the surface free, and
// nothing runs ahead of the pressure wave.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include "bodies/half_space/medium.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/half_space/field.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/replay.hpp"
#include "support/field_tools.hpp"

namespace stoss::bodies::half_space {
namespace {

ContactPoints rings(std::size_t count, double half_width) {
  return {1.0, std::asin(half_width) / static_cast<double>(count), count};
}

struct FieldSolid {
  Contour contour;
  double poisson;
};

void PrintTo(const FieldSolid& its, std::ostream* out) {
  *out << (its.contour == Contour::ball ? "space" : "plane") << ", poisson " << its.poisson;
}

Body body_of(const FieldSolid& solid, double cutoff, double duration) {
  return solid.contour == Contour::ball ? stoss::half_space(HalfSpace{.poisson = solid.poisson}, cutoff, duration)
                                        : stoss::half_plane(HalfPlane{.poisson = solid.poisson}, cutoff, duration);
}

class FieldBelow : public testing::TestWithParam<FieldSolid> {
 protected:
  const FieldSolid solid = GetParam();
  const Medium its = medium(solid.contour, solid.poisson);
  const Body body = body_of(solid, 5.0, 4.0);
  const ContactPoints contact = rings(24, 0.3);
  const std::vector<double> no_force = std::vector<double>(contact.count, 0.0);
};

TEST_P(FieldBelow, EachWaveObeysNewton) {
  // c_p² grad div u − c_s² rot rot u = −ω² u
  constexpr double h = 0.01, r = 0.7, z = 0.4;
  const double round = solid.contour == Contour::ball ? 1.0 / r : 0.0;
  const HalfSpaceField field(solid.poisson, body, contact, {test::stencil(r, h), test::stencil(z, h)});
  const double fast = its.pressure_speed * its.pressure_speed, slow = its.shear_speed * its.shear_speed;
  std::size_t k = 0;
  for (const ModeGroup& group : body.groups) {
    for (const double omega : group.omega) {
      if (k++ % 7 != 0) continue;
      const Field at = field.at(test::only(body, k - 1), no_force);
      const test::Derivatives u(at.lateral, h, h), w(at.normal, h, h);
      const double gradient_r = u.rr + (u.r - u.value * round) * round + w.rz;
      const double gradient_z = u.rz + u.z * round + w.zz;
      const double rotation_r = w.rz - u.zz, rotation_z = u.rz - w.rr + (u.z - w.r) * round;
      double size = 0.0;
      for (std::size_t i = 0; i < 81; ++i) size = std::max({size, std::abs(at.lateral[i]), std::abs(at.normal[i])});
      size *= omega * omega + fast * group.wave_number * group.wave_number;
      EXPECT_NEAR(fast * gradient_r - slow * rotation_r + omega * omega * u.value, 0.0, 1e-7 * size) << omega;
      EXPECT_NEAR(fast * gradient_z - slow * rotation_z + omega * omega * w.value, 0.0, 1e-7 * size) << omega;
    }
  }
}

TEST_P(FieldBelow, EachWaveLeavesTheSurfaceFreeOfShearAndMovesItAsTheModes) {
  constexpr double h = 0.002;
  std::vector<double> below;  // Taylor's series from one side
  for (int i = 0; i < 7; ++i) below.push_back(i * h);
  const std::vector<double> across = test::stencil(0.6, h);
  const HalfSpaceField field(solid.poisson, body, contact, {across, below});
  std::size_t k = 0;
  for (const ModeGroup& group : body.groups) {
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      if (k++ % 5 != 0) continue;
      const Field at = field.at(test::only(body, k - 1), no_force);
      double slope = 0.0;
      for (std::size_t i = 0; i < 7; ++i) slope += test::one_sided_weights[i] * at.lateral[9 * i + 4] / h;
      const double turn = test::derivative(at.normal, 0, 1, h);
      EXPECT_NEAR(slope + turn, 0.0, 1e-7 * group.upper[l] * (1.0 + group.wave_number)) << group.omega[l];
      const double surface = -group.upper[l] * its.shape(group.wave_number * 0.6);
      EXPECT_NEAR(at.normal[4], surface, 1e-12 * group.upper[l]);
    }
  }
}

TEST_P(FieldBelow, SurfaceGivesWayAsTheBodySays) {
  test::expect_surface_gives_way(body, contact, [&](const auto& distance, const auto& coordinate, const auto& force) {
    return HalfSpaceField(solid.poisson, body, contact, {distance, {0.0}}).at(coordinate, force);
  });
}

INSTANTIATE_TEST_SUITE_P(HalfSpace, FieldBelow,
                         testing::Values(FieldSolid{Contour::ball, -0.5}, FieldSolid{Contour::ball, 0.3},
                                         FieldSolid{Contour::ball, 0.49}, FieldSolid{Contour::cylinder, -0.8},
                                         FieldSolid{Contour::cylinder, 0.33}),
                         [](const auto& its) {
                           const long hundredths = std::lround(100.0 * its.param.poisson);
                           return std::string(its.param.contour == Contour::ball ? "space" : "plane") +
                                  (hundredths < 0 ? "m" : "") + std::to_string(std::abs(hundredths));
                         });

TEST(HalfSpaceField, LacksNoWaveOfALossyBody) {
  // It keeps fewer waves than its cutoff says: those of an elastic one of a lower cutoff, and so has the same field.
  constexpr double loss_time = 0.1, duration = 4.0;
  const Body lossy = stoss::half_space(HalfSpace{.poisson = 0.25, .loss_time = loss_time}, 12.0, duration);
  const Body elastic = stoss::half_space(HalfSpace{.poisson = 0.25}, kept_cutoff(lossy), duration);
  ASSERT_LT(kept_cutoff(lossy), 0.95 * lossy.cutoff);
  ASSERT_EQ(mode_count(lossy), mode_count(elastic));
  const ContactPoints contact = rings(24, 0.1);
  const std::vector<double> still(mode_count(lossy)), force(contact.count, 1.0);
  const auto field = [&](const Body& body) {
    return HalfSpaceField(0.25, body, contact, {{0.0, 0.3, 1.0}, {0.0, 0.2}}).at(still, force);
  };
  const Field one = field(lossy), other = field(elastic);
  for (std::size_t i = 0; i < one.normal.size(); ++i) {
    EXPECT_NEAR(one.normal[i], other.normal[i], 1e-12 * std::abs(other.normal[0])) << i;
    EXPECT_NEAR(one.lateral[i], other.lateral[i], 1e-12 * std::abs(other.normal[0])) << i;
  }
}

TEST(HalfSpaceField, NothingRunsAheadOfThePressureWave) {
  constexpr double poisson = 0.3, cutoff = 8.0, duration = 100.0;
  const Contact meeting = stoss::contact(sphere(Sphere{.poisson = poisson}, cutoff),
                                         stoss::half_space(HalfSpace{.poisson = poisson}, cutoff, duration));
  const Impact impact = stoss::impact(meeting, 0.1, {}, {.modes = true});
  const ContactGrid grid = contact_grid(meeting, impact.resolution.half_width, impact.resolution.nodes);
  const Medium its = medium(Contour::ball, poisson);
  for (const double time : {5.0, 12.0}) {
    const Frame frame = frames_at(meeting, impact, {time}).front();
    const BodyFrame seen = seen_by(meeting, grid, frame, 1);
    const double front = its.pressure_speed * time;
    const std::vector<double> distance{0.0, 0.5 * front, front, 1.5 * front};
    const std::vector<double> depth{0.0, 0.3 * front, 0.5 * front, 1.1 * front, 1.3 * front};
    const Field at =
        HalfSpaceField(poisson, *seen.body, seen.points, {distance, depth}).at(seen.coordinate, seen.node_force);
    double greatest = 0.0;
    for (const double u : at.normal) greatest = std::max(greatest, std::abs(u));
    for (std::size_t i = 0; i < depth.size(); ++i) {
      for (std::size_t j = 0; j < distance.size(); ++j) {
        if (std::hypot(depth[i], distance[j]) < 1.05 * front) continue;
        EXPECT_NEAR(at.normal[i * distance.size() + j] / greatest, 0.0, 1e-3)
            << time << ' ' << depth[i] << ' ' << distance[j];
        EXPECT_NEAR(at.lateral[i * distance.size() + j] / greatest, 0.0, 1e-3)
            << time << ' ' << depth[i] << ' ' << distance[j];
      }
    }
  }
}

TEST(HalfSpaceField, RefusesWhatItCannotBe) {
  const Body body = stoss::half_space(HalfSpace{.poisson = 0.3}, 4.0, 2.0);
  const ContactPoints contact = rings(4, 0.1);
  EXPECT_THROW(HalfSpaceField(0.31, body, contact, {{0.0}, {0.0}}), InvalidInput);
  EXPECT_THROW(HalfSpaceField(0.3, sphere(Sphere{.poisson = 0.3}, 8.0), contact, {{0.0}, {0.0}}), InvalidInput);
  EXPECT_THROW(HalfSpaceField(0.3, body, contact, {{}, {0.0}}), InvalidInput);
  EXPECT_THROW(HalfSpaceField(0.3, body, contact, {{-1.0}, {0.0}}), InvalidInput);
  EXPECT_THROW(HalfSpaceField(0.3, body, contact, {{0.0}, {std::nan("")}}), InvalidInput);
  const HalfSpaceField field(0.3, body, contact, {{0.0}, {0.0}});
  EXPECT_THROW((void)field.at(std::vector<double>(mode_count(body) - 1), std::vector<double>(4)), InvalidInput);
  EXPECT_THROW((void)field.at(std::vector<double>(mode_count(body)), std::vector<double>(3)), InvalidInput);
}

}  // namespace
}  // namespace stoss::bodies::half_space
