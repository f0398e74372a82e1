// The table of kinds: its ranges are those of the makers, and every kind is reached by its name.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "stoss/encounter/encounter.hpp"
#include "stoss/errors.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

/// An encounter whose first body, or what a fitting first meets, is of the kind with one number changed.
Encounter with(const Kind& its, const std::string& name, double value) {
  Participant changed{.kind = std::string(its.name)};
  for (const Parameter& each : its.parameters) {
    if (!each.default_value) changed.values[std::string(each.name)] = 0.25;
  }
  changed.values[name] = value;
  if (its.bounded) return {.first = changed};
  Participant first{.kind = its.contour == Contour::ball ? "sphere" : "disk", .values = {{"poisson", 0.25}}};
  return {.first = first, .against = changed};
}

bool accepted(const Encounter& encounter) {
  try {
    validate(encounter);
    return true;
  } catch (const InvalidInput&) {
    return false;
  }
}

TEST(Kinds, HaveTheRangesOfTheirMakers) {
  for (const Kind& its : kinds()) {
    if (its.from_file) continue;  // without one there is no body
    for (const Parameter& each : its.parameters) {
      const std::string name(each.name);
      if (name.starts_with("coat") || name == "yield_rate") continue;  // they go with others (test_coats.cpp)
      const double beyond = each.low - (each.low == 0.0 ? 1e-9 : 1e-9 * std::abs(each.low));
      EXPECT_FALSE(accepted(with(its, name, beyond))) << its.name << " " << name;
      EXPECT_EQ(accepted(with(its, name, each.low)), each.low_included) << its.name << " " << name;
      if (!std::isfinite(each.high)) continue;
      EXPECT_TRUE(accepted(with(its, name, each.high))) << its.name << " " << name;
      EXPECT_FALSE(accepted(with(its, name, each.high * (1.0 + 1e-9)))) << its.name << " " << name;
    }
  }
}

// By themselves too, without the table: whoever makes a body by hand has no other.
TEST(Kinds, HaveMakersThatRefuse) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const Kind& its : kinds()) {
    if (its.wall || its.from_file) continue;
    Values usual;
    for (const Parameter& each : its.parameters) usual[std::string(each.name)] = each.default_value.value_or(0.25);
    EXPECT_NO_THROW((void)maker(its.solid(usual))) << its.name;
    for (const Parameter& each : its.parameters) {
      if (is_of_whole(each.name) && each.name != "loss_time") continue;  // not of the solid
      std::vector<double> wrong{std::nan(""), infinity, -infinity, -1.5};
      if (each.name == "poisson") wrong.insert(wrong.end(), {each.low - 1e-9, each.high + 1e-9});
      if (each.name != "poisson" && each.name != "loss_time" && each.name != "inner") wrong.push_back(0.0);
      for (const double value : wrong) {
        Values changed = usual;
        changed[std::string(each.name)] = value;
        EXPECT_THROW((void)maker(its.solid(changed)), InvalidInput) << its.name << ' ' << each.name << ' ' << value;
      }
    }
  }
}

TEST(Kinds, AreFoundByTheirNames) {
  for (const Kind& its : kinds()) EXPECT_EQ(&kind(its.name), &its);
  EXPECT_EQ(test::message_of<InvalidInput>([] { (void)kind("cube"); }),
            "kind: got 'cube', allowed wall, same, disk, sphere, hollow-sphere, rod, half-space, half-plane, plate, "
            "strip, modal, "
            "exponential");
}

TEST(Kinds, SayWhoMeetsWhom) {
  EXPECT_EQ(
      who_meets_whom(),
      "a disk meets disks, half-planes and strips; a sphere, hollow-sphere or modal body spheres, hollow spheres, "
      "half-spaces, plates and modal bodies; a rod rods");
}

}  // namespace
}  // namespace stoss
