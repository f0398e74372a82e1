#pragma once

#include <gtest/gtest.h>

#include "identities/cases.hpp"
#include "stoss/impact/impact.hpp"

namespace stoss::test {

/// An identity that holds for every case of the table, but for the known limits that it names.
class Identity : public ::testing::TestWithParam<Case> {
 protected:
  const Case& its = GetParam();
  const Contact contact = contact_of(its);
  // All of a rod's end touches and leaves at once, which a static tail without mass answers with a rattle: fewer, but
  // finer steps. With the radiating tail nothing is gained from them.
  const double step = fixed_resolution(contact, its.speed, {.tail = its.tail}).step * (is_rod(its) ? 0.125 : 1.0);

  [[nodiscard]] bool has_static_tail() const { return !its.soft && its.tail == Tail::quasistatic; }
  [[nodiscard]] bool loses_energy() const { return !its.soft && its.tail == Tail::radiating; }

  [[nodiscard]] Impact run() const {
    return impact(contact, its.speed, {.resolution = {.step = step, .tail = its.tail}});
  }

  /// The same impact described otherwise: its time step is that of this one, in units of which `unit` are R/c here.
  [[nodiscard]] Impact run(const Case& otherwise, double unit = 1.0) const {
    return impact(contact_of(otherwise), otherwise.speed, {.resolution = {.step = step / unit, .tail = its.tail}});
  }
};

class IdentityOfPairs : public Identity {};
class IdentityOfEqualBodies : public Identity {};
class IdentityOfSoftWalls : public Identity {};

}  // namespace stoss::test
