// A mass fixed to a ball: against an exact identity of two bodies, limits, units, and refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "stoss/bodies/sphere.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/restitution/oblique.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

constexpr double unladen = 4.0 / 3.0 * std::numbers::pi;  // mass of a sphere of R = ρ = 1

Restitution of(const std::string& document, double speed, double tolerance = 1e-4, double absolute = 0.0) {
  const Encounter encounter = encounter_from_json(document);
  RestitutionOptions options;
  options.tolerance = tolerance, options.absolute = absolute;
  return restitution(refinable(encounter), speed_in_c(encounter, speed), options);
}

std::string laden_ball(double mass, const std::string& more = {}) {
  return R"({"kind":"sphere","poisson":0.3,"extra_mass":)" + std::to_string(mass) + more + "}";
}

// Seen from each other, two bodies know the mass of a rigid one through the reduced mass alone.
TEST(ExtraMass, IsThatOfARigidPartnerOfTheSameReducedMass) {
  constexpr double reduced = 0.4;
  const auto against = [](double density) {
    return R"(,"against":{"kind":"sphere","rigid":true,"density":)" + std::to_string(density) + "}}";
  };
  for (const double speed : {1e-3, 0.03}) {
    const Restitution without = of(R"({"first":)" + laden_ball(0.0) + against(reduced / (1.0 - reduced)), speed, 2e-5);
    EXPECT_LT(without.lost_fraction.error, 4e-5 * without.lost_fraction.value);
    for (const double extra : {0.5, 1.0, 40.0}) {
      const double laden = 1.0 + extra, partner = reduced * laden / (laden - reduced);
      const Restitution with = of(R"({"first":)" + laden_ball(extra * unladen) + against(partner), speed, 2e-5);
      EXPECT_NEAR(with.lost_fraction.value, without.lost_fraction.value,
                  with.lost_fraction.error + without.lost_fraction.error);
      EXPECT_NEAR(with.contact_time.value, without.contact_time.value,
                  with.contact_time.error + without.contact_time.error);
    }
  }
}

TEST(ExtraMass, OfARigidBallIsItsDensity) {
  const std::string block = R"(,"against":{"kind":"half-space","poisson":0.4}})";
  const std::string first = R"({"first":{"kind":"sphere","poisson":0.3,"rigid":true)";
  const Restitution laden = of(first + R"(,"extra_mass":)" + std::to_string(2.0 * unladen) + "}" + block, 0.01);
  const Restitution block_of = of(first + "}" + R"(,"against":{"kind":"half-space","poisson":0.4,"density":)" +
                                      std::to_string(1.0 / 3.0) + R"(,"young":)" + std::to_string(1.0 / 3.0) + "}}",
                                  0.01);
  EXPECT_NEAR(laden.lost_fraction.value, block_of.lost_fraction.value,
              laden.lost_fraction.error + block_of.lost_fraction.error);
}

TEST(ExtraMass, MakesSlowContactsLastAsByHertz) {
  const double alone = of(R"({"first":)" + laden_ball(0.0) + "}", 1e-7, 1e-3, 1e-3).contact_time.value;
  for (const double extra : {1.0, 9.0}) {
    const double with = of(R"({"first":)" + laden_ball(extra * unladen) + "}", 1e-7, 1e-3, 1e-3).contact_time.value;
    EXPECT_NEAR(with / alone, std::pow(1.0 + extra, 0.4), 2e-3);
  }
}

// The limit in which the ball answers as at rest: nothing is left to lose.
TEST(ExtraMass, OfAMillionTimesTheBallLosesNothing_long) {
  const Restitution heavy = of(R"({"first":)" + laden_ball(1e6 * unladen) + "}", 1e-6, 0.5);
  EXPECT_NEAR(heavy.restitution.value, 1.0, 1e-6);
}

TEST(ExtraMass, IsAlikeInSIAndInUnitsOfTheBallAndSoAreForces) {
  constexpr double radius = 0.0015, density = 14900.0, young = 6.2e11;
  const double mass = 5.45e-3, unit = density * radius * radius * radius, c = std::sqrt(young / density);
  const std::string si = R"({"first":{"kind":"sphere","radius":0.0015,"extra_mass":0.00545,)"
                         R"("material":{"young":6.2e11,"poisson":0.3,"density":14900}}})";
  const std::string own = R"({"first":)" + laden_ball(mass / unit) + "}";
  const Restitution one = of(si, 0.01 * c), other = of(own, 0.01);
  EXPECT_NEAR(one.lost_fraction.value, other.lost_fraction.value, 1e-6 * other.lost_fraction.value);
  const Encounter encounter = encounter_from_json(si);
  const double whole = mass + unladen * unit;
  EXPECT_NEAR(si_scales(encounter)->force, whole * c * c / radius, 1e-12 * whole * c * c / radius);
}

// At the onset of yielding the energy is the same.
TEST(ExtraMass, LowersTheSpeedFromWhichABallYields) {
  const auto onset = [](const std::string& more) {
    return yield_speed(encounter_from_json(R"({"first":{"kind":"sphere","radius":0.0015,"material":"bearing steel")" +
                                           more + "}}"))
        .value();
  };
  const double solid = unladen * 7810.0 * std::pow(0.0015, 3);
  EXPECT_NEAR(onset(R"(,"extra_mass":0.00545)"), onset("") * std::sqrt(solid / (solid + 0.00545)), 1e-12);
}

TEST(ExtraMass, IsRefusedInOneLine) {
  const auto said = [](const std::string& document) {
    return test::message_of<InvalidInput>([&] { validate(encounter_from_json(document)); });
  };
  EXPECT_EQ(said(R"({"first":)" + laden_ball(-1.0) + "}"),
            "extra_mass: got -1, allowed 0 or more (a mass fixed to the body)");
  EXPECT_EQ(said(R"({"first":{"kind":"disk","poisson":0.3,"extra_mass":1}})").substr(0, 23),
            "first: got \"extra_mass\"");
  const Encounter laden = encounter_from_json(R"({"first":)" + laden_ball(1.0) + "}");
  const std::string friction = test::message_of<InvalidInput>(
      [&] { (void)oblique_restitution(refinable(laden), 0.01, {.tangential = 0.01, .friction = 0.3}); });
  EXPECT_EQ(friction.substr(0, 38), "extra_mass: friction turns a body, and");
}

}  // namespace
}  // namespace stoss
