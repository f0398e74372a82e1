#pragma once

/// What a subcommand answers, and the comparison with what the library gives.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "app.hpp"
#include "output/fields.hpp"
#include "process/process.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/encounter/inputs.hpp"

namespace stoss::cli {

using Json = nlohmann::json;

/// Who meets whom, as options and as a document; how fast, as typed.
struct Case {
  std::string options, document, speed;

  [[nodiscard]] Encounter encounter() const { return encounter_from_json(document); }
  [[nodiscard]] double speed_in_c() const {
    const Units units = units_of(encounter());
    return in_own_units(input(Question::impact, "speed"), std::stod(speed), units.si, units.in_si);
  }
};

inline const Case ball{"--body sphere --poisson 0.3", R"({"first":{"kind":"sphere","poisson":0.3}})", "0.1"};
inline const Case ringing{"--body sphere --poisson 0.3 --mode 2,0,energy=0.1,phase=2 --against same",
                          R"({"first":{"kind":"sphere","poisson":0.3},"against":"same",
                              "vibration":[{"body":"first","order":2,"index":0,"energy":0.1,"phase":2}]})",
                          "0.1"};
inline const Case rigid{
    "--body sphere --poisson 0.3 --rigid-body --against half-space,young=2",
    R"({"first":{"kind":"sphere","poisson":0.3,"rigid":true},"against":{"kind":"half-space","young":2}})", "0.1"};
inline const Case disk{
    "--body disk --poisson 0.33 --loss-time 0.1 --against disk,radius=2",
    R"({"first":{"kind":"disk","poisson":0.33,"loss_time":0.1},"against":{"kind":"disk","radius":2}})", "0.1"};
inline const Case solid_disk{
    "--body disk --poisson 0.25 --young 1e10 --density 2500 --radius 1 --plane strain",
    R"({"first":{"kind":"disk","radius":1,"plane":"strain","material":{"young":1e10,"poisson":0.25,"density":2500}}})",
    "100"};
inline const Case rods{"--body rod --against rod,length=2.5",
                       R"({"first":{"kind":"rod"},"against":{"kind":"rod","length":2.5}})", "0.1"};
inline const Case solid_rods{
    "--body rod --material brass --length 0.5 --area 1e-4 --against rod,material=aluminium,length=1,area=2e-4",
    R"({"first":{"kind":"rod","material":"brass","length":0.5,"area":1e-4},
        "against":{"kind":"rod","material":"aluminium","length":1,"area":2e-4}})",
    "1"};
inline const Case glass{"--body sphere --material glass --radius 0.005 --against half-space,material=brass",
                        R"({"first":{"kind":"sphere","material":"glass","radius":0.005},
                     "against":{"kind":"half-space","material":"brass"}})",
                        "1"};

/// What the subcommand writes as JSON.
inline Json answer(const std::string& command, const Case& of, const std::string& more) {
  const std::string path = testing::TempDir() + "stoss_answer.json";
  std::vector<std::string> words =
      split(command + " " + of.options + " " + more + " --quiet --format json -o " + path, ' ');
  std::reverse(words.begin(), words.end());
  CLI::App app;
  declare(app);
  try {
    app.parse(words);
  } catch (const NotAsAsked&) {
  }
  std::ifstream file(path);
  const Json document = Json::parse(file);
  std::filesystem::remove(path);
  EXPECT_TRUE(document.at("complete")) << command;
  EXPECT_EQ(document.at("schema"), "stoss/" + command + "/2");
  return document;
}

inline void expect_number(const Json& of, const std::string& name, double value) {
  ASSERT_TRUE(of.contains(name)) << name;
  if (std::isnan(value)) {
    EXPECT_TRUE(of.at(name).is_null()) << name;
  } else if (std::isinf(value)) {
    EXPECT_EQ(of.at(name), "unknown") << name;
  } else {
    EXPECT_EQ(of.at(name), value) << name;
  }
}

/// That a record has every quantity of a result, and what it is in.
template <typename Result>
void expect_all(const Json& document, std::size_t row, const Quantities<Result>& quantities, const Result& result,
                const Encounter& encounter) {
  const Units its = units_of(encounter);
  const std::set<std::string> only_own{"cutoff", "step"}, left_out{"half_width"}, lists{"runs"};
  const Json& record = document.at("records").at(row);
  for (const auto& [name, dimension, help, value, error] : quantities) {
    if (left_out.contains(name)) continue;
    const Value got = value(result);
    if (const auto* number = std::get_if<double>(&got)) {
      const bool in_si = its.si && dimension != Dimension::none && !only_own.contains(name);
      const double scale = in_si ? unit_in_si(dimension, *its.si) : 1.0;
      expect_number(record, name, *number);
      if (error) expect_number(record, name + "_error", error(result));
      EXPECT_EQ(document["units"].value(name, ""), unit_name(dimension, its.own)) << name;
      if (!in_si) continue;
      expect_number(record, name + "_si", *number * scale);
      if (error) expect_number(record, name + "_si_error", error(result) * scale);
      EXPECT_EQ(document["units"].value(name + "_si", ""), unit_name(dimension, its.in_si)) << name;
    } else if (lists.contains(name)) {
      EXPECT_EQ(record.at(name).size(), static_cast<std::size_t>(cli::number(got))) << name;
    } else {
      EXPECT_EQ(record.at(name), std::visit([](const auto& each) { return Json(each); }, got)) << name;
    }
  }
}

}  // namespace stoss::cli
