// Encounters as JSON documents: read back as they were written, refused in one line.
#include "stoss/encounter/document.hpp"

#include <gtest/gtest.h>

#include <string>

#include "stoss/encounter/encounter.hpp"
#include "stoss/encounter/visible.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

TEST(EncounterDocument, ReadsBackAsItWasWritten) {
  const std::string text =
      R"({"format":"stoss encounter 1","first":{"kind":"sphere","radius":0.005,"material":"bearing steel"},)"
      R"("against":{"kind":"half-space","material":{"young":70000000000.0,"poisson":0.22,"density":2500.0}},)"
      R"("vibration":[{"body":"first","order":2,"index":0,"energy":0.1,"phase":1.5}]})";
  const Encounter read = encounter_from_json(text);
  EXPECT_EQ(read.first.material_name, "bearing steel");
  EXPECT_EQ(read.first.material->yield_strength, 1.7e9);
  EXPECT_EQ(to_json(encounter_from_json(to_json(read))), to_json(read));
  EXPECT_EQ(to_json(read), text);
  const std::string bare = R"({"format":"stoss encounter 1","first":{"kind":"disk","poisson":0.33},"against":"wall"})";
  EXPECT_EQ(to_json(encounter_from_json(bare)), bare);
}

TEST(EncounterDocument, IsRefusedInOneLine) {
  const auto said = [](const std::string& text) {
    return test::message_of<InvalidInput>([&] { (void)encounter_from_json(text); });
  };
  EXPECT_EQ(said("{}"), "encounter: got {}, allowed an object with a first body");
  EXPECT_EQ(said(R"({"first":{"kind":"disk","poisson":"x"}})"), "first poisson: got \"x\", allowed a finite number");
  EXPECT_EQ(said(R"({"first":{"kind":"disk","poison":0.3}})"),
            "first: got \"poison\", allowed kind, poisson, radius, young, density, loss_time, quality, roughness, u0, "
            "coat, coat_young, coat_poisson, coat_quality, relaxation, "
            "young_is, material, plane, rigid");
  EXPECT_EQ(said(R"({"first":{"kind":"disk","poisson":0.3},"speed":1})"),
            "encounter: got \"speed\", allowed format, first, against, vibration");
  EXPECT_EQ(said(R"({"first":{"kind":"sphere","radius":1,"material":"steal"}})").substr(0, 56),
            "material: got 'steal', allowed structural steel, glass, ");
  EXPECT_EQ(
      said(R"({"first":{"kind":"sphere","radius":1,"material":"steel"}})"),
      "material: got 'steel', allowed 'structural steel' (yields at 235 MPa) or 'bearing steel' (at 1.7 GPa): their "
      "yield speeds differ by a factor of 140");
  EXPECT_EQ(said("{").substr(0, 30), "encounter: not a JSON document");
  EXPECT_EQ(said(R"({"first": {"kind": "disk", "poisson": 0.3, "poisson": 0.4}})"),
            "encounter: got the key \"poisson\" twice, allowed once");
  EXPECT_EQ(said(R"({"first": {"kind": "disk", "poisson": 0.3}, "first": {"kind": "rod"}})"),
            "encounter: got the key \"first\" twice, allowed once");
  for (const char* text : {"", "[]", "1e999", "{\"first\":[]}", R"({"first":"wall"})", "\xff", R"({"first":{}})"}) {
    EXPECT_NE(said(text), "") << text;
    EXPECT_EQ(said(text).find('\n'), std::string::npos) << text;
  }
}

// What fuzzers have found: fuzz/corpus has more of it.
TEST(EncounterDocument, IsRefusedInALineThatCanBePrinted) {
  const auto expect_printable = [](const std::string& text) {
    const std::string said = test::message_of<InvalidInput>([&] { (void)encounter_from_json(text); });
    EXPECT_EQ(visible(said), said);
    EXPECT_LT(said.size(), 1000U);
  };
  const std::string long_word(100000, 'x'), cut_off = std::string(59, 'x') + "\u03b5\u03b5";
  for (const std::string& word :
       {std::string(R"(a\nb)"), std::string(R"(\u0000)"), std::string("\u2028"), long_word, cut_off}) {
    expect_printable(R"({"first":{"kind":")" + word + "\"}}");
    expect_printable(R"({"first":{"kind":"disk",")" + word + "\":1}}");
    expect_printable(R"({"first":{"kind":"disk","poisson":")" + word + "\"}}");
    expect_printable(R"({"first":{"kind":"disk","poisson":0.3,"radius":1,"material":")" + word + "\"}}");
  }
  expect_printable("{\"first\":\u03b5}");
  expect_printable("{\"first\":\"\xff\"}");
  expect_printable("{\"first\":" + std::string(100000, '9') + "e9}");
}

TEST(EncounterDocument, IsNotNestedDeeply) {
  const std::string open(1000000, '['), close(1000000, ']');
  const std::string first = R"({"first":{"kind":"disk","poisson":)";
  test::expect_refusal([&] { (void)encounter_from_json(open); }, {"encounter", "nested"});
  test::expect_refusal([&] { (void)encounter_from_json(open + close); }, {"encounter", "nested"});
  test::expect_refusal([&] { (void)encounter_from_json(first + open + close + "}}"); }, {"encounter", "nested"});
}

TEST(EncounterDocument, KeepsWholeNumbers) {
  const auto document = [](const std::string& order) {
    return R"({"first":{"kind":"disk","poisson":0.3},"vibration":[{"index":0,"energy":0.1,"order":)" + order + "}]}";
  };
  EXPECT_EQ(encounter_from_json(document("2")).vibration.front().order, 2);
  for (const char* order : {"4294967298", "-4294967294", "18446744073709551615", "2.0", "1e2"}) {
    test::expect_refusal([&] { (void)encounter_from_json(document(order)); }, {"vibration order", "whole number"});
  }
}

}  // namespace
}  // namespace stoss
