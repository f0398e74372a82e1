// What is seen of a repeated impact: fields inside of bodies, energies of modes, surfaces of what is met.
#include "stoss/encounter/inner_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "stoss/bodies/disk/field.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/encounter/inside.hpp"
#include "stoss/encounter/waves.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace seen_inside {
namespace {

constexpr double cutoff = 10.0, speed = 0.1;
const bodies::PolarGrid points{{0.0, 0.5, 1.0}, {0.0, 1.0, 3.0}};

/// An impact, and what is seen in the middle of it.
struct Repeated {
  explicit Repeated(const Encounter& of, Vibration vibration = {}) : encounter(of) {
    ImpactOptions options;
    if (!vibration.empty()) options.start = approach(contact, speed, vibration);
    its = impact(contact, speed, options);
    frames = frames_at(contact, its, {0.3 * its.contact_time, 0.5 * its.contact_time});
  }

  [[nodiscard]] BodyFrame seen(std::size_t frame, int number) const {
    return seen_by(contact, contact_grid(contact, its.resolution.half_width, its.resolution.nodes), frames[frame],
                   number);
  }
  [[nodiscard]] InnerFields fields(int number) const {
    return inner_fields(encounter, number, contact, its, frames, points.radius, points.angle);
  }

  Encounter encounter;
  Contact contact = contact_of(encounter, cutoff, speed);
  Impact its;
  std::vector<Frame> frames;
};

/// One instant of a field, in a unit.
void expect_instant(const InnerFields& all, const std::string& name, std::size_t instant,
                    const std::vector<double>& theirs, double unit = 1.0) {
  const auto named = [&](const NamedField& each) { return each.first == name; };
  const auto found = std::find_if(all.fields.begin(), all.fields.end(), named);
  ASSERT_NE(found, all.fields.end()) << name;
  ASSERT_EQ(found->second.size(), 2 * theirs.size());
  for (std::size_t k = 0; k < theirs.size(); ++k) {
    EXPECT_DOUBLE_EQ(found->second[instant * theirs.size() + k], theirs[k] * unit) << name << k;
  }
}

TEST(InnerFields, OfADiskAreItsOwn) {
  const Repeated disk({.first = {.values = {{"poisson", 0.3}}}});
  const InnerFields all = disk.fields(0);
  EXPECT_EQ(all.size, 1.0);
  for (const std::size_t i : {0U, 1U}) {
    const BodyFrame seen = disk.seen(i, 0);
    const bodies::disk::DiskField field(0.3, *seen.body, seen.points, points);
    const bodies::disk::Field theirs = field.at(seen.coordinate, seen.node_force);
    expect_instant(all, "radial", i, theirs.radial);
    expect_instant(all, "tangential", i, theirs.tangential);
    expect_instant(all, "stress_rr", i, theirs.stress_rr);
    expect_instant(all, "stress_pp", i, theirs.stress_pp);
    expect_instant(all, "stress_rp", i, theirs.stress_rp);
    EXPECT_EQ(all.center[i], seen.center);
  }
}

TEST(InnerFields, OfTheSecondBallAreInUnitsOfTheFirst) {
  const Values second{{"poisson", 0.2}, {"radius", 2.0}, {"young", 0.5}};
  const Repeated balls(
      {.first = {.kind = "sphere", .values = {{"poisson", 0.3}}}, .against = {.kind = "sphere", .values = second}});
  const InnerFields all = balls.fields(1);
  EXPECT_EQ(all.size, 2.0);
  const Solid solid = second_solid(balls.encounter).value();
  for (const std::size_t i : {0U, 1U}) {
    const BodyFrame seen = balls.seen(i, 1);
    const Interior theirs = inside(solid, seen, points, {})(seen);
    expect_instant(all, "radial", i, theirs.radial, 2.0);
    expect_instant(all, "tangential", i, theirs.tangential, 2.0);
    expect_instant(all, "von_mises", i, theirs.von_mises, seen.stress);
    expect_instant(all, "principal_difference", i, theirs.principal_difference, seen.stress);
    EXPECT_EQ(all.center[i], seen.center);
  }
  EXPECT_GT(all.center[1], 1.9);
}

TEST(InnerFields, AreOfDisksAndSpheresAlone) {
  test::expect_refusal([] { (void)Repeated({.first = of_kind("rod")}).fields(0); }, {"body", "only disks and spheres"});
  test::expect_refusal([] { (void)Repeated({.first = {.values = {{"poisson", 0.3}}}}).fields(1); }, {"body"});
}

TEST(ModeShares, AreThoseOfTheImpactBeforeAndAfterIt) {
  const Repeated disk({.first = {.values = {{"poisson", 0.3}}}}, {{.order = 2, .index = 0, .energy = 0.25}});
  const std::vector<ModeShare> all = mode_shares(disk.contact, disk.its, {-1.0, disk.its.contact_time + 1.0});
  const std::vector<ModeEnergy>& modes = disk.its.energy.modes;
  ASSERT_EQ(all.size(), 2 * modes.size());
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const ModeShare &before = all[k], &after = all[modes.size() + k];
    EXPECT_EQ(before.order, modes[k].order);
    EXPECT_EQ(after.omega, modes[k].omega);
    // The mode has a quarter of the energy of translation, a fifth of all.
    EXPECT_NEAR(before.energy, before.order == 2 && before.index == 0 ? 0.2 : 0.0, 1e-12);
    EXPECT_NEAR(after.energy, modes[k].after, 1e-9);
  }
}

// Off the contact nothing but the modes moves a surface, and so its waves are where it is; so is the other face.
TEST(Surfaces, AreWhereTheirWavesAre) {
  const Encounter encounter{.first = {.kind = "sphere", .values = {{"poisson", 0.3}}},
                            .against = {.kind = "plate", .values = {{"thickness", 1.0}, {"poisson", 0.3}}}};
  constexpr double latest = 15.0, time = 5.0, reach = 3.0, thickness = 1.0;
  const std::vector<double> lateral{0.375, 1.125, 1.875, 2.625};
  const bodies::half_space::PlaneGrid faces{lateral, {0.0, thickness}};
  const Contact contact = lasting(encounter, cutoff, latest, faces);
  const Impact its = impact(contact, speed);
  ASSERT_LT(its.contact_time, latest);
  const std::vector<Frame> frames = frames_at(contact, its, {time});
  const Surfaces here = surfaces(encounter, contact, its, frames, reach, lateral.size());
  const Waves below = waves(encounter, its, {}, {time, latest}, faces);
  ASSERT_EQ(here.place.size(), lateral.size());
  ASSERT_EQ(here.lower.size(), lateral.size());
  const ContactGrid grid = contact_grid(contact, its.resolution.half_width, its.resolution.nodes);
  const double center = seen_by(contact, grid, frames[0], 1).center;
  for (std::size_t i = 0; i < lateral.size(); ++i) {
    EXPECT_NEAR(here.lateral[i], lateral[i], 1e-6);
    EXPECT_NEAR(here.lower[i], center + thickness + below.normal[lateral.size() + i], 1e-3 * here.place[0]) << i;
  }
  for (std::size_t i = 1; i < lateral.size(); ++i) {
    EXPECT_NEAR(here.place[i], center + below.normal[i], 1e-3 * here.place[0]) << i;
  }
  EXPECT_GT(here.place[0], 0.01);
}

}  // namespace
}  // namespace seen_inside
}  // namespace stoss
