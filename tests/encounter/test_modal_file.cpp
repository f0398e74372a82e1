// Files of bodies by their modes at a point, in documents and by themselves.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "stoss/encounter/document.hpp"
#include "stoss/encounter/modal_file.hpp"
#include "stoss/errors.hpp"
#include "support/modal_sphere.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace modal_files {
namespace {

using Json = nlohmann::ordered_json;

ModalBody steel_ball() { return in_units(test::modal_sphere(0.3, 8.0), 100.0, 1.0 / 210e9, 1.0 / 7850.0); }

Json file() { return Json::parse(to_json(steel_ball())); }

TEST(ModalFile, ReadsBackAsTheSameBody) {
  ModalBody body = steel_ball();
  body.origin = "closed form";
  body.compliance_error = 1e-12;
  body.modes[3].omega_error = 10.0;
  body.modes[4].displacement_error = 0.1;
  body.curvature_difference = 50.0;
  const ModalBody same = modal_body_from_json(to_json(body));
  EXPECT_EQ(same.name, body.name);
  EXPECT_EQ(same.origin, body.origin);
  EXPECT_NEAR(same.curvature_difference, body.curvature_difference, 1e-9);
  EXPECT_EQ(same.modes.size(), body.modes.size());
  EXPECT_TRUE(same.has_bends);
  EXPECT_NEAR(same.modes[3].omega_error, 10.0, 1e-12);
  EXPECT_EQ(same.modes[4].displacement_error, 0.1);
  EXPECT_EQ(to_json(modal_body_from_json(to_json(same))), to_json(same));
}

// A thin rod that is struck at its end, across: a quarter of its mass is felt.
TEST(ModalFile, KnowsHowABodyTurns) {
  Json given = file();
  const double mass = given["mass"], length = 0.3, inertia = mass * length * length / 12.0;
  given["rotation"] = {{"inertia", {{1e-9, 0.0, 0.0}, {0.0, inertia, 0.0}, {0.0, 0.0, inertia}}},
                       {"point", {0.5 * length, 0.0, 0.0}},
                       {"normal", {0.0, 0.0, 2.0}}};
  EXPECT_NEAR(modal_body_from_json(given.dump()).mass, 0.25 * mass, 1e-12);
  given["rotation"]["inertia"][0][1] = 1.0;
  test::expect_refusal([&] { (void)modal_body_from_json(given.dump()); }, {"rotation inertia", "symmetric"});
}

TEST(ModalFile, NamesWhatIsWrong) {
  const auto refused = [](const std::vector<std::string>& parts, const auto& change) {
    Json given = file();
    change(given);
    test::expect_refusal([&] { (void)modal_body_from_json(given.dump(), "bell.json"); }, parts);
  };
  refused({"bell.json format"}, [](Json& given) { given["format"] = "stoss modal body 9"; });
  refused({"bell.json format"}, [](Json& given) { given.erase("format"); });
  refused({"bell.json", "colour", "mass"}, [](Json& given) { given["colour"] = "red"; });
  for (const char* needed : {"mass", "curvature", "young", "poisson", "density", "compliance", "modes"}) {
    refused({std::string("bell.json ") + needed, "got none"}, [&](Json& given) { given.erase(needed); });
  }
  refused({"curvature", "hollow"}, [](Json& given) { given["curvature"] = -3.0; });
  refused({"curvature", "2 numbers"}, [](Json& given) { given["curvature"] = {1.0, 2.0, 3.0}; });
  refused({"modes displacement", "numbers"}, [](Json& given) { given["modes"]["displacement"].push_back(1.0); });
  refused({"modes frequency", "got none"}, [](Json& given) { given["modes"].erase("frequency"); });
  refused({"mass", "finite number"}, [](Json& given) { given["mass"] = "heavy"; });
  refused({"poisson"}, [](Json& given) { given["poisson"] = 0.6; });
  refused({"mode 1 frequency"}, [](Json& given) { given["modes"]["frequency"][0] = -5.0; });
  test::expect_refusal([] { (void)modal_body_from_json("{"); }, {"JSON"});
  test::expect_refusal([] { (void)modal_body_from_json("[1]"); }, {"object"});
}

TEST(ModalFile, StandsInADocument) {
  Json document{{"first", {{"kind", "modal"}, {"body", file()}}},
                {"against", {{"kind", "sphere"}, {"radius", 0.02}, {"material", "glass"}}}};
  const Encounter encounter = encounter_from_json(document.dump());
  EXPECT_NEAR(si_scales(encounter)->length, 0.01, 1e-12);
  EXPECT_EQ(to_json(encounter_from_json(to_json(encounter))), to_json(encounter));
  const Restitution found = restitution(refinable(encounter), own_speed(encounter, 1.0), {.tolerance = 0.1});
  Json with_sphere = document;
  with_sphere["first"] = {
      {"kind", "sphere"}, {"radius", 0.01}, {"material", {{"young", 210e9}, {"poisson", 0.3}, {"density", 7850}}}};
  const Encounter exact = encounter_from_json(with_sphere.dump());
  const Restitution expected = restitution(refinable(exact), own_speed(exact, 1.0));
  EXPECT_NEAR(found.lost_fraction.value, expected.lost_fraction.value,
              found.lost_fraction.error + expected.lost_fraction.error);
  // The other way around, in units of the other.
  std::swap(document["first"], document["against"]);
  const Encounter turned = encounter_from_json(document.dump());
  const Restitution same = restitution(refinable(turned), own_speed(turned, 1.0), {.tolerance = 0.1});
  EXPECT_NEAR(same.lost_fraction.value, expected.lost_fraction.value,
              same.lost_fraction.error + expected.lost_fraction.error);
}

TEST(ModalFile, GoesWithMaterialsOnly) {
  Json document{{"first", {{"kind", "modal"}, {"body", file()}}}, {"against", {{"kind", "sphere"}, {"poisson", 0.3}}}};
  test::expect_refusal([&] { (void)encounter_from_json(document.dump()); }, {"against material"});
  document["against"] = "same";
  EXPECT_NO_THROW((void)encounter_from_json(document.dump()));
  document["first"]["radius"] = 2.0;
  test::expect_refusal([&] { (void)encounter_from_json(document.dump()); }, {"first", "radius"});
  document["first"].erase("radius");
  document["first"].erase("body");
  test::expect_refusal([&] { (void)encounter_from_json(document.dump()); }, {"first", "body"});
}

}  // namespace
}  // namespace modal_files
}  // namespace stoss
