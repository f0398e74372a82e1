// Kept modes that fly freely at once are where they come to step by step, and so is what creeps.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "impact/kept_modes.hpp"
#include "relaxation/creep.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {
namespace {

/// Kicks the modes of a body for some time, then lets them fly by steps and at once.
void expect_flight(const BodyMaker& maker) {
  const Contact contact = stoss::contact(maker(12.0, {}));
  const ContactGrid grid = contact_grid(contact, 0.3, 12);
  constexpr double step = 0.04;
  constexpr int flown = 500;
  KeptModes stepped(contact, grid, step, Kicks::whole);
  std::vector<double> force(grid.recess.size());
  for (int i = 0; i < 100; ++i) {
    for (std::size_t k = 0; k < force.size(); ++k)
      force[k] = std::sin(0.03 * i) * (1.0 - 0.05 * static_cast<double>(k));
    stepped.load(force, force.size());
    if (i == 0) stepped.begin();
    stepped.advance();
  }
  stepped.load(std::vector<double>(force.size()), 0);
  const double energy = stepped.energy() + stepped.dissipated(0, contact.groups.size());
  KeptModes at_once = stepped;
  for (int i = 0; i < flown; ++i) stepped.advance();
  at_once.fly(flown * step);
  std::vector<double> one(force.size()), other(force.size());
  stepped.add_displacement(one);
  at_once.add_displacement(other);
  const double scale = std::sqrt(energy);
  for (std::size_t k = 0; k < one.size(); ++k) EXPECT_NEAR(one[k], other[k], 1e-11 * scale);
  EXPECT_NEAR(at_once.energy(), stepped.energy(), 1e-11 * energy);
  EXPECT_NEAR(at_once.energy() + at_once.dissipated(0, contact.groups.size()), energy, 1e-11 * energy);
}

TEST(Flight, OfModesAtOnceIsThatByStepsAndLosesWhatTheyLose) {
  expect_flight(sphere(0.3));
  expect_flight(disk(0.2));
  expect_flight(sphere({0.3, 1.0, 1.0, 1.0, 0.05}));
  expect_flight(relaxing(sphere(0.3), {{{0.3, 1.0}, {0.2, 10.0}}}));
}

TEST(Flight, OfModesWithALossTimeIsThatBySteps) {
  const Contact contact = stoss::contact(sphere({0.3, 1.0, 1.0, 1.0, 0.05})(12.0, {}));
  const ContactGrid grid = contact_grid(contact, 0.3, 12);
  KeptModes stepped(contact, grid, 0.04, Kicks::whole);
  std::vector<double> start(stepped.count(), 1e-3);
  stepped.set(start, start);
  KeptModes at_once = stepped;
  for (int i = 0; i < 200; ++i) stepped.advance();
  at_once.fly(8.0);
  std::vector<double> one(grid.recess.size()), other(one.size());
  stepped.add_displacement(one);
  at_once.add_displacement(other);
  for (std::size_t k = 0; k < one.size(); ++k) EXPECT_NEAR(one[k], other[k], 1e-12);
  EXPECT_NEAR(at_once.energy(), stepped.energy(), 1e-12 * stepped.energy() + 1e-18);
}

// BDF2 of what creeps back, of second order in the step.
TEST(Flight, CreepFadesAsItDoesBySteps) {
  double before = 0.0;
  for (const double step : {0.02, 0.01}) {
    CreepMemory memory({0.5, {{0.3, 0.2}, {0.1, 0.05}}}, step, 1);
    for (int i = 0; i * step < 10.0; ++i) memory.take({1.0});
    for (int i = 0; i < 20; ++i) memory.take({0.0});
    CreepMemory at_once = memory;
    for (int i = 0; i * step < 20.0 - 0.5 * step; ++i) memory.take({0.0});
    at_once.fade(20.0);
    const double apart = std::abs(memory.crept()[0] - at_once.crept()[0]);
    EXPECT_LT(apart, 1e-4 * memory.crept()[0]);
    if (before > 0.0) {
      EXPECT_LT(apart, 0.4 * before);
    }
    before = apart;
  }
}

}  // namespace
}  // namespace stoss
