// The kind that docs/architecture.md adds, in the library that was built with it.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

#include "stoss/encounter.hpp"
#include "stoss/encounter/inputs.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact.hpp"
#include "stoss/restitution.hpp"

namespace stoss {
namespace {

double restitution_of(const std::string& document, double speed) {
  const Encounter encounter = encounter_from_json(document);
  return impact(contact_of(encounter, 1600.0, speed), speed).restitution;
}

double exact(double mass) { return (1.0 + mass) * (1.0 - std::exp(-2.0 / mass)) - 1.0; }

TEST(Anvil, IsMetByARodAsTheMethodOfCharacteristicsSays) {
  for (const double area : {0.2, 1.0, 5.0, 100.0}) {
    const std::string text = R"({"first": "rod", "against": {"kind": "anvil", "area": )" + std::to_string(area) + "}}";
    EXPECT_NEAR(restitution_of(text, 0.1), exact(area), 1e-3) << area;
  }
}

TEST(Anvil, IsMetByASteelRodInSI) {
  const std::string steel = R"("material": {"young": 2.1e11, "poisson": 0.3, "density": 7850})";
  const std::string text = R"({"first": {"kind": "rod", "length": 0.1, "area": 1e-4, )" + steel +
                           R"(}, "against": {"kind": "anvil", "length": 0.05, "area": 4e-4, )" + steel + "}}";
  EXPECT_NEAR(restitution_of(text, 1e-3), exact(2.0), 1e-3);
}

TEST(Anvil, IsInTheSchemaAndInWhoMeetsWhom) {
  EXPECT_NE(encounter_schema().find("\"anvil\""), std::string::npos);
  EXPECT_NE(who_meets_whom().find("a rod rods and anvils"), std::string::npos) << who_meets_whom();
}

TEST(Anvil, IsWrittenAsItIsRead) {
  const Encounter encounter = encounter_from_json(R"({"first": "rod", "against": {"kind": "anvil", "area": 2}})");
  EXPECT_EQ(encounter_from_json(to_json(encounter)).against.values.at("area"), 2.0);
}

TEST(Anvil, IsRefusedWhereItCannotBe) {
  const auto refused = [](const std::string& text) {
    EXPECT_THROW((void)contact_of(encounter_from_json(text), 10.0, 0.1), InvalidInput) << text;
  };
  refused(R"({"first": "anvil"})");
  refused(R"({"first": "rod", "against": {"kind": "anvil", "area": 0}})");
  refused(R"({"first": "rod", "against": {"kind": "anvil", "radius": 1}})");
  refused(R"({"first": "rod", "against": {"kind": "anvil", "material": "structural steel"}})");
  refused(R"({"first": {"kind": "sphere", "poisson": 0.3}, "against": {"kind": "anvil"}})");
}

TEST(HalfWidth, IsAnInputOfImpacts) {
  const Input& its = input(Question::impact, "half_width");
  EXPECT_EQ(in_own_units(its, 0.5, std::nullopt, UnitSystem::sphere), 0.5);
  EXPECT_THROW(require(its, 0.0, std::nullopt, UnitSystem::sphere), InvalidInput);
  EXPECT_THROW((void)input(Question::bounce, "half_width"), InvalidInput);
}

TEST(Anvil, MayBeRefined) {
  const Encounter encounter = encounter_from_json(R"({"first": "rod", "against": {"kind": "anvil", "area": 2}})");
  const Restitution found = restitution(refinable(encounter), 0.1, {.tolerance = 0.1});
  EXPECT_NEAR(found.restitution.value, exact(2.0), found.restitution.error);
}

}  // namespace
}  // namespace stoss
