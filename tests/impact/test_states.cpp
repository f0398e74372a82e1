// States of bodies: looked at again in the frames of an impact, left alone, and put into another impact.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <vector>

#include "contact/unit_ratios.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/replay.hpp"
#include "support/disk_pairs.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

constexpr double speed = 0.1, cutoff = 12.0;

/// What meets a disk: a second one, or a wall.
struct Partner {
  std::optional<Disk> second;
};

void PrintTo(const Partner& its, std::ostream* out) {
  its.second ? *out << "a disk of radius " << its.second->radius : *out << "a wall";
}

class States : public ::testing::TestWithParam<Partner> {
 protected:
  const Disk one{0.33};
  const std::optional<Disk> other = GetParam().second;
  const Contact meeting = other ? test::pair_of(one, *other, cutoff) : contact(disk(one, cutoff));
  const double initial = 0.5 * meeting.mass * speed * speed;
};

class StatesOfAPair : public States {};

State at_rest(const Contact& contact, double gap, double velocity) {
  return {-contact.extent - gap, velocity, std::vector<double>(mode_count(contact), 0.0),
          std::vector<double>(mode_count(contact), 0.0)};
}

/// Frequencies and modal masses in the order of a state.
struct Modes {
  explicit Modes(const Contact& contact) {
    for (std::size_t g = 0; g < contact.groups.size(); ++g) {
      omega.insert(omega.end(), contact.groups[g].omega.begin(), contact.groups[g].omega.end());
      mass.resize(omega.size(), modal_mass(contact, g));
    }
  }
  std::vector<double> omega, mass;
};

TEST_P(States, EnergiesOfTheModesAreThoseOfTheLedger) {
  const Impact result = impact(meeting, speed);
  const std::vector<double> energies = mode_energies(meeting, result.final_state);
  ASSERT_EQ(energies.size(), result.energy.modes.size());
  double sum = 0.0;
  for (std::size_t k = 0; k < energies.size(); ++k) {
    EXPECT_NEAR(energies[k] / initial, result.energy.modes[k].after, 1e-13);
    sum += energies[k] / initial;
  }
  EXPECT_NEAR(sum, result.energy.vibration, 1e-13);
  EXPECT_GT(sum, 1e-4);
}

TEST_P(States, AreReplayedBitByBit) {
  std::vector<Frame> seen;
  const ImpactObserver observer = [&](const Snapshot& now) {
    seen.push_back({now.time,
                    now.force,
                    now.contact_half_width,
                    {now.center,
                     now.velocity,
                     {now.coordinate.begin(), now.coordinate.end()},
                     {now.momentum.begin(), now.momentum.end()}},
                    {now.node_force.begin(), now.node_force.end()}});
  };
  const Impact result = impact(meeting, speed, {}, {.observer = observer, .every = 9, .modes = true});
  std::vector<double> times;
  for (const Frame& frame : seen) times.push_back(frame.time);
  const std::vector<Frame> again = frames_at(meeting, result, times);
  ASSERT_EQ(again.size(), seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_EQ(again[i].time, seen[i].time);
    EXPECT_EQ(again[i].force, seen[i].force);
    EXPECT_EQ(again[i].state.center, seen[i].state.center);
    EXPECT_EQ(again[i].state.velocity, seen[i].state.velocity);
    EXPECT_EQ(again[i].state.coordinate, seen[i].state.coordinate);
    EXPECT_EQ(again[i].state.momentum, seen[i].state.momentum);
    EXPECT_EQ(again[i].node_force, seen[i].node_force);
  }
}

TEST_P(States, OfAnotherContactAreRefused) {
  const Impact result = impact(meeting, speed);
  const Contact wall = contact(disk(0.3, cutoff)), finer = contact(disk(one, 1.5 * cutoff));
  test::expect_refusal([&] { (void)frames_at(wall, result, {0.0}); }, {"body"});
  test::expect_refusal([&] { (void)frames_at(finer, result, {0.0}); }, {"body"});
  test::expect_refusal([&] { (void)mode_energies(finer, result.final_state); }, {"state"});
}

TEST_P(States, LeftAloneTurnAtTheFrequenciesOfTheirBodies) {
  const State state = impact(meeting, speed).final_state;
  for (const double time : {1.7, -5.0}) {
    const State later = free_motion(meeting, state, time);
    EXPECT_NEAR(later.center, state.center + time * state.velocity, 1e-14);
    EXPECT_EQ(later.velocity, state.velocity);
    const Modes modes(meeting);
    for (std::size_t k = 0; k < modes.omega.size(); ++k) {
      const double c = std::cos(modes.omega[k] * time), s = std::sin(modes.omega[k] * time);
      const double inertia = modes.mass[k] * modes.omega[k];
      EXPECT_NEAR(later.coordinate[k], c * state.coordinate[k] + s * state.momentum[k] / inertia, 1e-15);
      EXPECT_NEAR(later.momentum[k], c * state.momentum[k] - s * inertia * state.coordinate[k], 1e-14);
    }
    const std::vector<double> before = mode_energies(meeting, state), after = mode_energies(meeting, later);
    for (std::size_t k = 0; k < before.size(); ++k) EXPECT_NEAR(after[k], before[k], 1e-14 * initial);
  }
}

TEST_P(States, OfBodiesThatVibrateAreLedFreelyToTheImpact) {
  State start = at_rest(meeting, 0.1, speed);
  const Modes modes(meeting);
  const std::size_t k = (other ? mode_count(*meeting.first) : 3) + 2;
  start.coordinate[k] = 0.004;
  const double share = mode_energies(meeting, start)[k], all = initial + share;
  EXPECT_NEAR(share, 0.5 * modes.mass[k] * std::pow(0.004 * modes.omega[k], 2), 1e-15);
  bool free = true;
  int seen = 0;
  const ImpactObserver observer = [&](const Snapshot& now) {
    free = free && now.force == 0.0;
    if (!free) return;
    ++seen;
    EXPECT_NEAR(now.center, start.center + speed * now.time, 1e-12);
    EXPECT_NEAR(now.coordinate[k], 0.004 * std::cos(modes.omega[k] * now.time), 1e-13);
    EXPECT_NEAR(now.momentum[k], -0.004 * modes.mass[k] * modes.omega[k] * std::sin(modes.omega[k] * now.time), 1e-12);
    EXPECT_NEAR(now.vibration, share / all, 1e-12);
    EXPECT_NEAR(now.translation, 1.0 - share / all, 1e-12);
  };
  const Impact result = impact(meeting, speed, {.start = start}, {.observer = observer, .modes = true});
  EXPECT_GT(seen, 10);
  EXPECT_NEAR(result.energy_error, 0.0, 2e-4);
  EXPECT_LE(result.momentum_error, 1e-12);
  EXPECT_GT(std::abs(result.restitution - impact(meeting, speed).restitution), 1e-4);
}

TEST_P(StatesOfAPair, MayBeToldFromTheOtherBody) {
  const Contact swapped = test::swapped_pair(one, *other, cutoff);
  const UnitRatios units(*meeting.second, *meeting.first);
  const std::size_t of_first = mode_count(*meeting.first);
  State here = at_rest(meeting, 0.02, speed);
  here.coordinate[2] = 0.003;
  here.coordinate[of_first + 3] = -0.002;
  here.momentum[of_first + 1] = 0.004;
  const double momentum = units.mass * units.length / units.time, wave = units.length / units.time;
  State there = at_rest(swapped, 0.02 / units.length, speed / wave);
  const std::size_t of_second = mode_count(*meeting.second);
  there.coordinate[of_second + 2] = here.coordinate[2] / units.length;
  there.coordinate[3] = here.coordinate[of_first + 3] / units.length;
  there.momentum[1] = here.momentum[of_first + 1] / momentum;
  const double step = fixed_resolution(meeting, speed).step;
  const Impact a = impact(meeting, speed, {.resolution = {.step = step}, .start = here});
  const Impact b = impact(swapped, speed / wave, {.resolution = {.step = step / units.time}, .start = there});
  EXPECT_NEAR(b.restitution, a.restitution, 1e-10);
  EXPECT_NEAR(b.energy.lost_to_second, a.energy.lost_to_first, 1e-10);
  EXPECT_NEAR(b.final_state.coordinate[0] * units.length, a.final_state.coordinate[of_first], 1e-10);
  EXPECT_NEAR(b.final_state.momentum[0] * momentum, a.final_state.momentum[of_first], 1e-10);
}

TEST_P(States, AfterOneImpactMayBeginTheNext) {
  // Something turns the bodies round once they have parted: they meet again, still vibrating.
  const Impact first = impact(meeting, speed);
  State again = free_motion(meeting, first.final_state, 3.0);
  again.velocity = -again.velocity;
  const Impact second = impact(meeting, again.velocity, {.start = again});
  const double vibration = first.energy.vibration / (first.energy.vibration + first.energy.translation);
  const EnergyLedger& ledger = second.energy;
  EXPECT_NEAR(ledger.translation + ledger.lost_to_first + ledger.lost_to_second + second.energy_error, 1.0, 1e-12);
  EXPECT_NEAR(ledger.translation, second.restitution * second.restitution * (1.0 - vibration), 1e-12);
  EXPECT_NEAR(second.energy_error, 0.0, 2e-4);
}

std::vector<Partner> partners(bool with_wall) {
  std::vector<Partner> all;
  if (with_wall) all.push_back({});
  for (const Disk& second : test::other_disks) all.push_back({second});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Every, States, ::testing::ValuesIn(partners(true)));
INSTANTIATE_TEST_SUITE_P(Every, StatesOfAPair, ::testing::ValuesIn(partners(false)));

TEST(StatesOfRods, AreReplayedWithOneNode) {
  for (const Contact& each : {contact(rod(160.0)), contact(rod(), rod(Rod{2.5, 1.0, 1.0, 1.0}), 160.0)}) {
    const Impact result = impact(each, speed);
    const double end = static_cast<double>(result.steps) * result.resolution.step;
    const std::vector<Frame> frames = frames_at(each, result, {-1.0, 1.0, end + 2.0});
    ASSERT_EQ(frames[1].node_force.size(), 1U);
    EXPECT_NEAR(frames[1].node_force[0], frames[1].force, 1e-15);
    const double share = each.second == nullptr ? 1.0 : 0.5;  // v Z₁Z₂/(Z₁ + Z₂)
    EXPECT_NEAR(frames[1].force, share * speed, 0.04 * share * speed);
    EXPECT_EQ(frames[2].node_force, std::vector<double>{0.0});
    EXPECT_EQ(frames[2].state.coordinate, free_motion(each, result.final_state, frames[2].time - end).coordinate);
  }
}

TEST(Motion, GoesToTheNearestStep) {
  const Body body = disk(0.33, 12.5);
  const Impact result = impact(body, HardWall{}, 0.1);
  const std::vector<Frame> frames =
      frames_at(contact(body), result,
                {10.4 * result.resolution.step, 10.6 * result.resolution.step, 10.6 * result.resolution.step});
  EXPECT_DOUBLE_EQ(frames[0].time, 10.0 * result.resolution.step);
  EXPECT_DOUBLE_EQ(frames[1].time, 11.0 * result.resolution.step);
  EXPECT_DOUBLE_EQ(frames[2].time, 11.0 * result.resolution.step);
}

TEST(Motion, IsFreeBeforeAndAfter) {
  const Body body = disk(0.33, 12.5);
  const Impact result = impact(body, HardWall{}, 0.1);
  const double end = static_cast<double>(result.steps) * result.resolution.step;
  const std::vector<Frame> frames = frames_at(contact(body), result, {-2.0, 0.0, end, end + 3.0});
  EXPECT_NEAR(frames[0].state.center, frames[1].state.center - 0.2, 1e-12);
  for (const double coordinate : frames[0].state.coordinate) EXPECT_EQ(coordinate, 0.0);
  EXPECT_EQ(frames[2].state.coordinate, result.final_state.coordinate);
  EXPECT_NEAR(frames[3].state.center, frames[2].state.center + 3.0 * result.final_state.velocity, 1e-12);
  EXPECT_EQ(frames[3].force, 0.0);
}

TEST(Motion, RefusesTimesThatAreNone) {
  const Body body = disk(0.33, 12.5);
  const Impact result = impact(body, HardWall{}, 0.1);
  test::expect_refusal([&] { (void)frames_at(contact(body), result, {1.0, 0.5}); }, {"time", "ascend"});
  test::expect_refusal([&] { (void)frames_at(contact(body), result, {std::nan("")}); }, {"time", "nan"});
  test::expect_refusal([&] { (void)frames_at(contact(body), result, {1e300}); }, {"time"});
  EXPECT_TRUE(frames_at(contact(body), result, {}).empty());
}

}  // namespace
}  // namespace stoss
