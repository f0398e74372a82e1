// What a film shows is the field of each kind of body, at one instant after another.
#include "stoss/encounter/inside.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "stoss/bodies/disk/field.hpp"
#include "stoss/bodies/plate/field.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/impact.hpp"

namespace stoss {
namespace {

const bodies::PolarGrid around{{0.0, 0.5, 1.0}, {0.0, 1.0, 3.0}};
const bodies::half_space::PlaneGrid under{{0.0, 0.3, 0.6, 1.0}, {0.0, 0.2, 0.5}};

/// One of what meets, in the middle of its impact and long before it.
struct Seen {
  Seen(const Encounter& encounter, int number) {
    const Contact contact = contact_of(encounter, 10.0, 0.1);
    const Impact its = impact(contact, 0.1);
    const ContactGrid grid = contact_grid(contact, its.resolution.half_width, its.resolution.nodes);
    const std::vector<Frame> frames = frames_at(contact, its, {-1.0, 0.5 * its.contact_time});
    before = seen_by(contact, grid, frames[0], number);
    now = seen_by(contact, grid, frames[1], number);
    solid = number == 0 ? first_solid(encounter) : second_solid(encounter).value();
  }
  BodyFrame before, now;
  Solid solid;
};

/// So few contact points that each is a ring.
BodyFrame on_few_rings(BodyFrame seen) {
  seen.points.spacing *= static_cast<double>(seen.points.count) / 6.0;
  seen.points.count = 6;
  seen.node_force = seen.crept_force = {0.5, 1.5, 2.0, 1.0, 0.25, 0.0};
  return seen;
}

void expect_same(const Interior& ours, const bodies::half_space::Field& theirs) {
  ASSERT_EQ(ours.radial.size(), 12U);
  for (std::size_t k = 0; k < 12; ++k) {
    EXPECT_NEAR(ours.radial[k], theirs.normal[k], 1e-12);
    EXPECT_NEAR(ours.tangential[k], theirs.lateral[k], 1e-12);
  }
}

TEST(Inside, OfADiskIsItsField) {
  const Seen seen({.first = {.values = {{"poisson", 0.3}}}}, 0);
  const Interior ours = inside(seen.solid, seen.before, around, {})(seen.now);
  const bodies::disk::DiskField field(0.3, *seen.now.body, seen.now.points, around);
  const bodies::disk::Field theirs = field.at(seen.now.coordinate, seen.now.node_force);
  EXPECT_EQ(ours.radial, theirs.radial);
  EXPECT_EQ(ours.tangential, theirs.tangential);
  EXPECT_EQ(ours.von_mises, von_mises(theirs));
  EXPECT_EQ(ours.principal_difference, principal_difference(theirs));
}

TEST(Inside, OfADiskThatRelaxesHasCrept) {
  const Seen seen({.first = {.values = {{"poisson", 0.3}}, .relaxation = Relaxation{{{0.5, 0.3}}}}}, 0);
  const Interior ours = inside(seen.solid, seen.before, around, {})(seen.now);
  const bodies::disk::DiskField field(0.3, *seen.now.body, seen.now.points, around);
  const bodies::disk::Field crept = field.at(seen.now.coordinate, seen.now.crept_force);
  const bodies::disk::Field at_once = field.at(seen.now.coordinate, seen.now.node_force);
  EXPECT_EQ(ours.radial, crept.radial);
  EXPECT_EQ(ours.tangential, crept.tangential);
  EXPECT_EQ(ours.von_mises, von_mises(at_once));
  // Where it touches, half of what the modes that are not kept give way.
  EXPECT_LT(crept.radial[6], at_once.radial[6]);
}

TEST(Inside, OfARodIsTheSameAcrossIt) {
  const Seen seen({.first = {.kind = "rod"}}, 0);
  const Interior ours = inside(seen.solid, seen.before, around, {})(seen.now);
  ASSERT_EQ(ours.radial.size(), 9U);
  EXPECT_GT(ours.von_mises[0], 0.0);
  for (std::size_t k = 0; k < 9; ++k) {
    EXPECT_EQ(ours.radial[k], ours.radial[k - k % 3]);
    EXPECT_EQ(ours.von_mises[k], ours.principal_difference[k - k % 3]);
    EXPECT_EQ(ours.tangential[k], 0.0);
  }
}

TEST(Inside, OfAHalfSpaceIsTheFieldOfItsRings) {
  const Encounter drop{.first = {.kind = "sphere", .values = {{"poisson", 0.3}}},
                       .against = {.kind = "half-space", .values = {{"poisson", 0.2}}}};
  const Seen seen(drop, 1);
  const BodyFrame few = on_few_rings(seen.now);
  const Interior ours = inside(seen.solid, few, around, under)(few);
  const bodies::half_space::HalfSpaceField field(0.2, *few.body, few.points, under);
  const bodies::half_space::Field theirs = field.at(few.coordinate, few.node_force);
  expect_same(ours, theirs);
  EXPECT_GT(*std::max_element(ours.von_mises.begin(), ours.von_mises.end()), 0.0);
  const Interior still = inside(seen.solid, seen.before, around, under)(seen.before);
  for (const double each : still.radial) EXPECT_EQ(each, 0.0);
}

TEST(Inside, OfAPlateIsItsFieldDownToTheLowerFace) {
  const Encounter drop{.first = {.kind = "sphere", .values = {{"poisson", 0.3}}},
                       .against = {.kind = "plate", .values = {{"poisson", 0.2}, {"thickness", 1.0}}}};
  const Seen seen(drop, 1);
  const BodyFrame few = on_few_rings(seen.now);
  const Interior ours = inside(seen.solid, few, around, under)(few);
  const bodies::plate::PlateField field(std::get<Plate>(seen.solid), *few.body, few.points, under);
  const bodies::half_space::Field theirs = field.at(few.coordinate, few.node_force);
  expect_same(ours, theirs);
  // The lower face gives way too.
  EXPECT_GT(ours.radial[9], 0.1 * ours.radial[0]);
  const auto rounded_up = bodies::half_space::PlaneGrid{under.distance, {0.0, 0.5, 1.0 + 1e-7}};
  EXPECT_NO_THROW((void)inside(seen.solid, few, around, rounded_up)(few));
  EXPECT_THROW((void)inside(seen.solid, few, around, {under.distance, {0.0, 0.5, 1.1}}), InvalidInput);
}

TEST(ModeShape, HasTheMaximumOne) {
  const Interior breathing = mode_shape(Disk{.poisson = 0.3}, 0, 0, around);
  for (std::size_t k = 6; k < 9; ++k) EXPECT_NEAR(std::abs(breathing.radial[k]), 1.0, 1e-9);
  const Interior cosine = mode_shape(Rod{}, 0, 1, around);
  EXPECT_NEAR(cosine.radial[0], 1.0, 1e-9);
  EXPECT_NEAR(cosine.radial[3], -1.0, 1e-9);
  EXPECT_NEAR(cosine.radial[6], 1.0, 1e-9);
}

TEST(ModeShape, RefusesWhatNoBodyKeeps) {
  EXPECT_THROW((void)mode_shape(Disk{.poisson = 0.3}, 0, 100000, around), InvalidInput);
  EXPECT_THROW((void)mode_shape(Rod{}, 7, 0, around), InvalidInput);
  EXPECT_THROW((void)mode_shape(HollowSphere{.poisson = 0.3, .inner = 0.5}, 2, 0, around), InvalidInput);
}

}  // namespace
}  // namespace stoss
