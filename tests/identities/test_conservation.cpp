// Energy and momentum, for every body and all that it can meet.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "identities/identity.hpp"

namespace stoss::test {

TEST_P(Identity, EnergyAndMomentumAreKept) {
  double impulse = 0.0, before = 0.0, last = 0.0;
  const ImpactObserver observer = [&](const Snapshot& now) {
    impulse += 0.5 * (before + now.force) * (now.time - last);
    before = now.force;
    last = now.time;
  };
  const Impact result = impact(contact, its.speed, {.resolution = {.step = step, .tail = its.tail}}, {observer});
  // The soft wall is smooth and its potential exact; a hard one makes and breaks contact between two steps.
  EXPECT_NEAR(result.energy_error, 0.0, its.soft && !is_lossy(its) ? 1e-7 : 1e-4);
  const EnergyLedger& ledger = result.energy;
  EXPECT_NEAR(ledger.translation, result.restitution * result.restitution, 1e-11);  // 1e-12 of it was in the wall
  ASSERT_EQ(ledger.modes.size(), mode_count(contact));
  double of_body[2] = {0.0, 0.0};
  for (std::size_t k = 0; k < ledger.modes.size(); ++k) {
    const ModeEnergy& mode = ledger.modes[k];
    EXPECT_EQ(mode.body, k < mode_count(*contact.first) ? 0 : 1);
    EXPECT_GE(mode.after, 0.0);
    EXPECT_GE(mode.average, 0.0);
    of_body[mode.body] += mode.after;
  }
  EXPECT_NEAR(of_body[0] + of_body[1], ledger.vibration, 1e-12);
  const double lost = ledger.vibration + ledger.dissipated + ledger.unresolved + (is_lossy(its) ? ledger.stored : 0.0);
  EXPECT_NEAR(ledger.translation + ledger.vibration + ledger.dissipated + ledger.unresolved + ledger.stored +
                  result.energy_error,
              1.0, 1e-12);
  EXPECT_NEAR(ledger.lost_to_first + ledger.lost_to_second, lost, 1e-12);
  if (is_lossy(its)) {
    EXPECT_GT(ledger.dissipated, 1e-4);
    EXPECT_LT(std::abs(ledger.stored), 1e-2);  // relaxes
  } else {
    EXPECT_EQ(ledger.dissipated, 0.0);
    EXPECT_LT(std::abs(ledger.stored), 1e-10);
  }
  if (loses_energy()) {
    EXPECT_GE(ledger.unresolved, -1e-6);
  } else {
    EXPECT_EQ(ledger.unresolved, 0.0);
    if (!is_lossy(its)) {
      EXPECT_NEAR(ledger.lost_to_first, of_body[0], 1e-12);
    }
  }
  if (!its.second) {
    EXPECT_EQ(ledger.lost_to_second, 0.0);
  }
  EXPECT_LE(result.momentum_error, 1e-12);
  // From what the observer saw: forces are those of the mass of the first body.
  const bool pair = its.second && !its.half_space;
  const double reduced = pair ? mass(*its.second) / (mass(its.first) + mass(*its.second)) : 1.0;
  EXPECT_NEAR(impulse / (reduced * its.speed), 1.0 + result.restitution, 1e-9);
  // From rest at most one.
  EXPECT_GT(result.restitution, -1.0);
  if (!its.second) {
    EXPECT_GT(result.restitution, 0.0);
  }
  EXPECT_LE(result.restitution, 1.0 + 1e-12 + (its.soft ? 1e-7 : 5e-5));
  EXPECT_NEAR(result.lost_fraction, 1.0 - result.restitution * result.restitution, 1e-14);
  EXPECT_GE(result.contacts, 1);
  EXPECT_GT(result.contact_time, 0.0);
  EXPECT_GT(result.max_force, 0.0);
}

// In the units of the case, with masses from the definitions of the bodies.
TEST_P(IdentityOfPairs, EnergyAndMomentumHoldInAnyFrame) {
  double impulse = 0.0;
  const Impact result = impact(contact, its.speed, {.resolution = {.step = step, .tail = its.tail}},
                               {[&](const Snapshot& now) { impulse += now.force * step; }});
  const double m1 = mass(its.first), m2 = mass(*its.second);
  const double wave = wave_speed(its.first), approach = its.speed * wave;
  impulse *= m1 * wave;
  const EnergyLedger& ledger = result.energy;
  const double vibration = (ledger.lost_to_first + ledger.lost_to_second + result.energy_error) * 0.5 * m1 * m2 /
                           (m1 + m2) * approach * approach;
  for (const double frame : {0.0, -approach, 3.0 * wave, -approach * m1 / (m1 + m2)}) {
    const double before1 = approach + frame, before2 = frame;
    const double after1 = before1 - impulse / m1, after2 = before2 + impulse / m2;
    EXPECT_NEAR(after2 - after1, result.restitution * approach, 1e-9 * approach);
    const double lost = 0.5 * (m1 * (before1 * before1 - after1 * after1) + m2 * (before2 * before2 - after2 * after2));
    const double scale = (m1 + m2) * (frame * frame + approach * approach);
    EXPECT_NEAR(lost, vibration, 1e-9 * scale) << frame;
  }
}

}  // namespace stoss::test
