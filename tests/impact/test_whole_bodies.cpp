// Impacts in which the near side of one disk stands for it: the motion and the energies are those of the whole.
#include "impact/ending.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "impact/recommended.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

const Disk large{0.33, 20.0, 1.0, 1.0};
constexpr double approach_speed = 0.1, cutoff_of_both = 10.0;

Contact with_part(double size) {
  const Body whole = disk(large, 1.0);
  return contact(disk(0.33, cutoff_of_both), whole.near_side(size, cutoff_of_both * large.radius, {}));
}

/// The part called the first; its units are those of the large disk.
Contact part_first(double size) {
  const Body whole = disk(large, 1.0);
  return contact(whole.near_side(size, cutoff_of_both * large.radius, {}), disk(0.33, cutoff_of_both));
}

Impact impact_of(const Contact& contact) {
  return impact(contact, approach_speed, {.resolution = refined_resolution(contact, approach_speed, 0.0)});
}

// What the small disk feels cannot depend on what no wave has told it of.
TEST(WholeBodies, DoNotDependOnThePartThatStandsForOne) {
  const Impact whole = impact_of(contact(disk(0.33, cutoff_of_both), disk(large, cutoff_of_both * large.radius)));
  for (const double size : {0.3, 0.5, 0.8}) {
    const Impact part = impact_of(with_part(size));
    // The edge of the part is more curved for waves.
    const double curvature = 1.0 / size - 1.0;
    EXPECT_NEAR(part.restitution, whole.restitution, 2e-3 * curvature) << size;
    EXPECT_NEAR(part.max_force / whole.max_force, 1.0, 2e-3 * curvature) << size;
    EXPECT_NEAR(part.energy.lost_to_first, whole.energy.lost_to_first, 1e-3 * curvature) << size;
    EXPECT_NEAR(part.energy.lost_to_second, whole.energy.lost_to_second, 2e-3 * curvature) << size;
    EXPECT_NEAR(part.contact_time, whole.contact_time, 0.05) << size;
  }
}

TEST(WholeBodies, KeepAccountOfTheEnergy) {
  for (const Contact& contact : {with_part(0.4), part_first(0.4)}) {
    const Impact impact = impact_of(contact);
    const EnergyLedger& ledger = impact.energy;
    EXPECT_NEAR(ledger.translation, impact.restitution * impact.restitution, 1e-13);
    EXPECT_NEAR(ledger.translation + ledger.vibration + ledger.unresolved + impact.energy_error, 1.0, 1e-12);
    EXPECT_NEAR(ledger.lost_to_first + ledger.lost_to_second, ledger.vibration + ledger.unresolved, 1e-12);
    EXPECT_LT(std::abs(impact.energy_error), 1e-3);
  }
}

// μ(v₀ − v) = ∫F dt with the reduced mass of the whole bodies, and the energies of each instant add up.
TEST(WholeBodies, MoveByTheForce) {
  const Contact contact = with_part(0.4);
  EXPECT_NEAR(contact.whole_mass, std::numbers::pi * 400.0 / 401.0, 1e-12);
  double impulse = 0.0, center = 0.0;
  Snapshot before{}, last{};
  const Resolution resolution = refined_resolution(contact, approach_speed, 0.0);
  const ImpactObserver observer = [&](const Snapshot& now) {
    if (now.time > 0.0) {
      impulse += 0.5 * (before.force + now.force) * *resolution.step;
      const double step = *resolution.step;
      center += before.velocity * step - 0.5 * std::numbers::pi * before.force / contact.whole_mass * step * step;
    } else {
      center = now.center;
    }
    EXPECT_NEAR(contact.whole_mass * (approach_speed - now.velocity), std::numbers::pi * impulse, 1e-12);
    EXPECT_NEAR(now.center, center, 1e-12);
    EXPECT_NEAR(now.translation + now.vibration + now.stored + now.unresolved, 1.0, 0.03);
    before = last = now;
  };
  const Impact impact = stoss::impact(contact, approach_speed, {.resolution = resolution}, {observer});
  EXPECT_NEAR(-last.velocity / approach_speed, impact.restitution, 1e-13);
  EXPECT_NEAR(last.translation, impact.energy.translation, 1e-13);
  EXPECT_NEAR(last.vibration, impact.energy.vibration, 1e-12);
}

TEST(WholeBodies, AreTheSameWhoeverIsFirst) {
  const Impact here = impact_of(with_part(0.4)), there = impact_of(part_first(0.4));
  EXPECT_NEAR(there.restitution, here.restitution, 1e-12);
  EXPECT_NEAR(there.energy.lost_to_first, here.energy.lost_to_second, 1e-12);
  EXPECT_NEAR(there.contact_time * large.radius, here.contact_time, 1e-10);
  EXPECT_NEAR(there.max_force * large.radius, here.max_force, 1e-12);  // in mc²/R of the first
  EXPECT_NEAR(there.max_half_width * large.radius, here.max_half_width, 1e-12);
}

TEST(WholeBodies, CannotBeToldFromAPartThatAnEchoHasCrossed) {
  const std::string message = test::message_of<NotConverged>([] { (void)impact_of(with_part(0.1)); });
  EXPECT_NE(message.find("echo"), std::string::npos) << message;
}

TEST(WholeBodies, ShowTheInsideOfTheSmallerOneOnly) {
  const Contact contact = with_part(0.4);
  const Impact impact = impact_of(contact);
  const ContactGrid grid = contact_grid(contact, impact.resolution.half_width, impact.resolution.nodes);
  const Frame frame = frames_at(contact, impact, {4.0}).front();
  EXPECT_EQ(seen_by(contact, grid, frame, 0).length, 1.0);
  test::expect_refusal([&] { (void)seen_by(contact, grid, frame, 1); }, {"body", "allowed 0", "near side"});
}

}  // namespace
}  // namespace stoss
