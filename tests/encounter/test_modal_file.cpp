// Files of bodies by their modes at a point, in documents and by themselves.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "stoss/encounter/document.hpp"
#include "stoss/encounter/modal_file.hpp"
#include "stoss/encounter/moving.hpp"
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
  body.curvature_difference = 2.4 * body.curvature;  // a saddle
  EXPECT_NEAR(modal_body_from_json(to_json(body)).curvature_difference, body.curvature_difference, 1e-9);
}

TEST(ModalFile, KnowsWhetherABodyIsHeld) {
  Json given = file();
  EXPECT_FALSE(modal_body_from_json(given.dump()).held);
  given["held"] = true;
  const ModalBody body = modal_body_from_json(given.dump());
  EXPECT_TRUE(body.held);
  EXPECT_TRUE(modal_body_from_json(to_json(body)).held);
  given["rotation"] = {{"inertia", {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}},
                       {"point", {0.5, 0.0, 0.0}},
                       {"normal", {0.0, 0.0, 2.0}}};
  test::expect_refusal([&] { (void)modal_body_from_json(given.dump()); }, {"rotation", "held"});
  given["held"] = 1;
  test::expect_refusal([&] { (void)modal_body_from_json(given.dump()); }, {"held", "true or false"});
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

// Readers differ in which of both counts.
TEST(ModalFile, HasNoKeyTwice) {
  const std::string whole = file().dump();
  const auto refused = [&](const std::string& before, const std::string& more) {
    std::string text = whole;
    const auto place = text.find(before);
    ASSERT_NE(place, std::string::npos) << before;
    text.insert(place, more);
    test::expect_refusal([&] { (void)modal_body_from_json(text, "bell.json"); },
                         {"bell.json: got the key", "twice, allowed once"});
    const std::string document = R"({"first": {"kind": "body", "body": )" + text + "}}";
    test::expect_refusal([&] { (void)encounter_from_json(document); }, {"encounter: got the key", "twice"});
  };
  refused("\"mass\"", "\"mass\": 1, ");
  refused("\"mass\"", "\"m\\u0061ss\": 1, ");  // the same name
  refused("\"displacement\"", "\"frequency\": [], ");
  EXPECT_NO_THROW((void)modal_body_from_json(whole));
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
    refused({std::string("bell.json ") + needed, "missing"}, [&](Json& given) { given.erase(needed); });
  }
  refused({"curvature", "hollow"}, [](Json& given) { given["curvature"] = -3.0; });
  refused({"curvature", "hollow"}, [](Json& given) { given["curvature"] = {-3.0, 2.0}; });
  refused({"curvature", "2 numbers"}, [](Json& given) { given["curvature"] = {1.0, 2.0, 3.0}; });
  refused({"modes displacement", "numbers"}, [](Json& given) { given["modes"]["displacement"].push_back(1.0); });
  refused({"modes frequency", "missing"}, [](Json& given) { given["modes"].erase("frequency"); });
  refused({"mass", "finite number"}, [](Json& given) { given["mass"] = "heavy"; });
  refused({"poisson"}, [](Json& given) { given["poisson"] = 0.6; });
  // A line end would begin a further line of headers.
  refused({"bell.json name", "one line"}, [](Json& given) { given["name"] = "bell\n0.1,0.9"; });
  refused({"bell.json name", "one line"}, [](Json& given) { given["name"] = std::string(201, 'x'); });
  refused({"bell.json origin", "one line"}, [](Json& given) { given["origin"] = "CAD\u2028file"; });
  refused({"mode 1 frequency"}, [](Json& given) { given["modes"]["frequency"][0] = -5.0; });
  test::expect_refusal([] { (void)modal_body_from_json("{"); }, {"JSON"});
  test::expect_refusal([] { (void)modal_body_from_json("[1]"); }, {"object"});
}

ModalBody rough_steel_ball() {
  ModalBody own = test::modal_sphere_along(0.3, 8.0);
  return in_units(own, 100.0, 1.0 / 210e9, 1.0 / 7850.0);
}

TEST(ModalFile, ReadsBackItsTangent) {
  ModalBody body = rough_steel_ball();
  body.tangent->compliance_error = 1e-12;
  body.tangent->cross = 0.5;
  body.modes[1].tangential_error = 0.1;
  const ModalBody same = modal_body_from_json(to_json(body));
  ASSERT_TRUE(same.tangent.has_value());
  EXPECT_EQ(same.tangent->mass, body.tangent->mass);
  EXPECT_EQ(same.tangent->inertia, body.tangent->inertia);
  EXPECT_EQ(same.tangent->arm, body.tangent->arm);
  EXPECT_EQ(same.tangent->cross, 0.5);
  EXPECT_EQ(same.tangent->compliance, body.tangent->compliance);
  EXPECT_EQ(same.tangent->compliance_error, 1e-12);
  EXPECT_TRUE(same.tangent->has_bends);
  EXPECT_EQ(same.modes[1].tangential, body.modes[1].tangential);
  EXPECT_EQ(same.modes[1].tangential_bend, body.modes[1].tangential_bend);
  EXPECT_EQ(same.modes[1].tangential_error, 0.1);
  EXPECT_EQ(to_json(same), to_json(modal_body_from_json(to_json(same))));
  Json given = Json::parse(to_json(body));
  given["modes"].erase("tangential_displacement_curvature");
  EXPECT_FALSE(modal_body_from_json(given.dump()).tangent->has_bends);
}

// A block that is struck on a face beside its middle: 1/m_t = 1/m + (r × t)·I⁻¹(r × t).
TEST(ModalFile, KnowsHowFrictionTurnsABody) {
  Json given = Json::parse(to_json(rough_steel_ball()));
  const double mass = given["mass"], a = 0.02, b = 0.03, c = 0.05;
  const double across = mass / 12.0 * (b * b + c * c), along = mass / 12.0 * (a * a + c * c),
               up = mass / 12.0 * (a * a + b * b);
  given["rotation"] = {{"inertia", {{across, 0.0, 0.0}, {0.0, along, 0.0}, {0.0, 0.0, up}}},
                       {"point", {0.0, 0.01, 0.5 * c}},
                       {"normal", {0.0, 0.0, 1.0}}};
  given["tangent"] = {{"direction", {2.0, 0.0, 0.0}}, {"compliance", 1e-12}};
  const ModalBody body = modal_body_from_json(given.dump());
  EXPECT_NEAR(1.0 / body.mass, 1.0 / mass + 0.01 * 0.01 / across, 1e-9 / mass);
  const PointTangent& its = *body.tangent;
  EXPECT_EQ(its.mass, mass);
  EXPECT_NEAR(its.arm, std::hypot(0.01, 0.5 * c), 1e-15);
  EXPECT_NEAR(its.arm * its.arm / its.inertia, 0.25 * c * c / along + 0.01 * 0.01 / up, 1e-9 / mass);
  EXPECT_NEAR(its.cross, 0.0, 1e-12);
  given["tangent"]["direction"] = {0.0, 1.0, 0.0};  // along which the blow is off its centre
  EXPECT_NEAR(modal_body_from_json(given.dump()).tangent->cross, -0.01 * 0.5 * c / across, 1e-9 / mass);
}

TEST(ModalFile, NamesWhatIsWrongWithATangent) {
  const auto refused = [](const std::vector<std::string>& parts, const auto& change) {
    Json given = Json::parse(to_json(rough_steel_ball()));
    change(given);
    test::expect_refusal([&] { (void)modal_body_from_json(given.dump(), "bell.json"); }, parts);
  };
  refused({"bell.json tangent", "colour"}, [](Json& given) { given["tangent"]["colour"] = 1.0; });
  refused({"tangent compliance", "missing"}, [](Json& given) { given["tangent"].erase("compliance"); });
  refused({"tangent inertia", "missing", "rotation"}, [](Json& given) { given["tangent"].erase("inertia"); });
  refused({"tangent arm", "missing"}, [](Json& given) { given["tangent"].erase("arm"); });
  refused({"tangential_displacement", "without a tangent"}, [](Json& given) { given.erase("tangent"); });
  refused({"tangential_displacement", "got none"},
          [](Json& given) { given["modes"].erase("tangential_displacement"); });
  refused({"tangential_displacement", "numbers"},
          [](Json& given) { given["modes"]["tangential_displacement"].push_back(1.0); });
  const auto turning = [](Json& given) {
    const double inertia = given["tangent"]["inertia"];
    given["rotation"] = {{"inertia", {{inertia, 0.0, 0.0}, {0.0, inertia, 0.0}, {0.0, 0.0, inertia}}},
                         {"point", {0.0, 0.0, 0.01}},
                         {"normal", {0.0, 0.0, 1.0}}};
  };
  refused({"tangent", "mass", "direction"}, [&](Json& given) { turning(given); });
  refused({"tangent direction", "perpendicular"}, [&](Json& given) {
    turning(given);
    given["tangent"] = {{"direction", {1.0, 0.0, 0.5}}, {"compliance", 0.0}};
  });
  refused({"tangent direction", "missing"}, [&](Json& given) {
    turning(given);
    given["tangent"] = {{"compliance", 0.0}};
  });
}

TEST(ModalFile, StandsInADocument) {
  Json document{{"first", {{"kind", "modal"}, {"body", file()}}},
                {"against", {{"kind", "sphere"}, {"radius", 0.02}, {"material", "glass"}}}};
  const Encounter encounter = encounter_from_json(document.dump());
  EXPECT_NEAR(si_scales(encounter)->length, 0.01, 1e-12);
  EXPECT_EQ(to_json(encounter_from_json(to_json(encounter))), to_json(encounter));
  const Restitution found = restitution(refinable(encounter), speed_in_c(encounter, 1.0), {.tolerance = 0.1});
  Json with_sphere = document;
  with_sphere["first"] = {
      {"kind", "sphere"}, {"radius", 0.01}, {"material", {{"young", 210e9}, {"poisson", 0.3}, {"density", 7850}}}};
  const Encounter exact = encounter_from_json(with_sphere.dump());
  const Restitution expected = restitution(refinable(exact), speed_in_c(exact, 1.0));
  EXPECT_NEAR(found.lost_fraction.value, expected.lost_fraction.value,
              found.lost_fraction.error + expected.lost_fraction.error);
  // The other way around, in units of the other.
  std::swap(document["first"], document["against"]);
  const Encounter turned = encounter_from_json(document.dump());
  const Restitution same = restitution(refinable(turned), speed_in_c(turned, 1.0), {.tolerance = 0.1});
  EXPECT_NEAR(same.lost_fraction.value, expected.lost_fraction.value,
              same.lost_fraction.error + expected.lost_fraction.error);
}

// A table knows how it rubs, but not how it turns in space.
TEST(ModalFile, IsNoBodyOfASimulation) {
  const Json document{{"first", {{"kind", "modal"}, {"body", Json::parse(to_json(rough_steel_ball()))}}},
                      {"against", "same"}};
  test::expect_refusal([&] { (void)moving_pair(encounter_from_json(document.dump())); }, {"body", "modal"});
}

TEST(ModalFile, GoesWithMaterialsOnly) {
  Json document{{"first", {{"kind", "modal"}, {"body", file()}}}, {"against", {{"kind", "sphere"}, {"poisson", 0.3}}}};
  test::expect_refusal([&] { (void)encounter_from_json(document.dump()); }, {"against: needs a material too"});
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
