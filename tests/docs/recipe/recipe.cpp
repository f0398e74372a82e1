// The kind that docs/architecture.md adds, in the library that was built with it.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "stoss/encounter.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact.hpp"
#include "stoss/restitution.hpp"

namespace stoss {
namespace {

double restitution_of(const std::string& document, double speed) {
  const Encounter encounter = encounter_from_json(document);
  return impact(contact_of(encounter, 1600.0, speed), speed).restitution;
}

// A rod of mass 1 in its own units.
TEST(Anvil, IsMetByARodAsTheMethodOfCharacteristicsSays) {
  for (const double mass : {0.2, 1.0, 5.0, 100.0}) {
    const std::string text = R"({"first": "rod", "against": {"kind": "anvil", "mass": )" + std::to_string(mass) + "}}";
    EXPECT_NEAR(restitution_of(text, 0.1), (1.0 + mass) * (1.0 - std::exp(-2.0 / mass)) - 1.0, 1e-3) << mass;
  }
}

TEST(Anvil, IsMetByASteelRodInSI) {
  const std::string text = R"({"first": {"kind": "rod", "length": 0.1, "area": 1e-4, "material": "steel"},
                               "against": {"kind": "anvil", "mass": 0.1}})";
  const Encounter encounter = encounter_from_json(text);
  const double rod_mass = 0.1 * 1e-4 * named_material("steel").density, mass = 0.1 / rod_mass;
  const Impact found = impact(contact_of(encounter, 1600.0, 1e-3), 1e-3);
  EXPECT_NEAR(found.restitution, (1.0 + mass) * (1.0 - std::exp(-2.0 / mass)) - 1.0, 1e-3);
}

TEST(Anvil, IsInTheSchemaAndInWhoMeetsWhom) {
  EXPECT_NE(encounter_schema().find("\"anvil\""), std::string::npos);
  EXPECT_NE(who_meets_whom().find("a rod meets rods and anvils"), std::string::npos) << who_meets_whom();
}

TEST(Anvil, IsWrittenAsItIsRead) {
  const Encounter encounter = encounter_from_json(R"({"first": "rod", "against": {"kind": "anvil", "mass": 2}})");
  EXPECT_EQ(encounter_from_json(to_json(encounter)).against.values.at("mass"), 2.0);
}

TEST(Anvil, IsRefusedWhereItCannotBe) {
  const auto refused = [](const std::string& text) {
    EXPECT_THROW((void)contact_of(encounter_from_json(text), 10.0, 0.1), InvalidInput) << text;
  };
  refused(R"({"first": {"kind": "anvil", "mass": 1}})");
  refused(R"({"first": "rod", "against": "anvil"})");
  refused(R"({"first": "rod", "against": {"kind": "anvil", "mass": 0}})");
  refused(R"({"first": "rod", "against": {"kind": "anvil", "mass": 1, "length": 1}})");
  refused(R"({"first": "rod", "against": {"kind": "anvil", "mass": 1, "material": "steel"}})");
  refused(R"({"first": {"kind": "sphere", "poisson": 0.3}, "against": {"kind": "anvil", "mass": 1}})");
}

TEST(Anvil, MayBeRefined) {
  const Encounter encounter = encounter_from_json(R"({"first": "rod", "against": {"kind": "anvil", "mass": 2}})");
  const Restitution found = restitution(refinable(encounter), 0.1, {.tolerance = 0.1});
  EXPECT_NEAR(found.restitution.value, 3.0 * (1.0 - std::exp(-1.0)) - 1.0, found.restitution.error);
}

}  // namespace
}  // namespace stoss
