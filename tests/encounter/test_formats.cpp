// Documents name their format with a version: what is written does, and what is read may not be of a later one.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "stoss/encounter/document.hpp"
#include "stoss/encounter/modal_file.hpp"
#include "stoss/encounter/schema.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using Json = nlohmann::ordered_json;

template <typename Read>
std::string refusal(const Read& read) {
  try {
    read();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

std::string encounter_of(const std::string& format) {
  return refusal([&] {
    (void)encounter_from_json(R"({"later": 1, "format": )" + format +
                              R"(, "first": {"kind": "sphere", "poisson": 0.3}})");
  });
}

std::string body_of(const std::string& format) {
  return refusal([&] { (void)modal_body_from_json(R"({"later": 1, "format": )" + format + "}"); });
}

TEST(Formats, EncounterIsWrittenWithItsFormatAndReadWithAndWithout) {
  const Encounter encounter = encounter_from_json(R"({"first": {"kind": "sphere", "poisson": 0.3}})");
  const std::string written = to_json(encounter);
  EXPECT_EQ(Json::parse(written)["format"], "stoss encounter 1");
  EXPECT_EQ(to_json(encounter_from_json(written)), written);
}

TEST(Formats, SchemaHasTheVersionOfItsFormat) {
  const Json schema = Json::parse(encounter_schema());
  EXPECT_EQ(schema["$id"], "urn:stoss:encounter:1");
  EXPECT_EQ(schema["properties"]["format"]["const"], "stoss encounter 1");
  EXPECT_EQ(schema["title"], "stoss encounter 1");
  EXPECT_EQ(schema["$defs"]["modal_body"]["properties"]["format"]["const"], "stoss modal body 1");
}

TEST(Formats, LaterOnesAreRefusedBeforeWhatTheyHaveBesides) {
  EXPECT_EQ(encounter_of("\"stoss encounter 2\""),
            "format: got \"stoss encounter 2\", allowed \"stoss encounter 1\" (written by a later stoss)");
  EXPECT_EQ(body_of("\"stoss modal body 12\""),
            "body format: got \"stoss modal body 12\", allowed \"stoss modal body 1\" (written by a later stoss)");
}

TEST(Formats, OthersAreRefusedWithoutThatHint) {
  for (const char* other : {"\"stoss encounter 0\"", "\"stoss encounter\"", "\"stoss encounter x\"",
                            "\"stoss encounter 02\"", "\"stoss modal body 1\"", "1", "null", "{}"}) {
    EXPECT_EQ(encounter_of(other), "format: got " + std::string(other) + ", allowed \"stoss encounter 1\"");
  }
  EXPECT_EQ(body_of("\"stoss encounter 2\""), "body format: got \"stoss encounter 2\", allowed \"stoss modal body 1\"");
}

}  // namespace
}  // namespace stoss
