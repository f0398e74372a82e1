// Rows as values: the text that is made of them, and the values that are read of it again.
#include "output/rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "output/fields.hpp"
#include "output/row_run.hpp"
#include "output/writer.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss::cli {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(Estimate, UnknownErrorIsAWord) {
  EXPECT_EQ(std::get<std::string>(error_of(3.35, infinite)), "unknown");
  EXPECT_EQ(std::get<std::string>(error_of(3.35, none)), "unknown");
  EXPECT_EQ(std::get<double>(error_of(3.35, 0.5)), 0.5);
  EXPECT_TRUE(std::isnan(std::get<double>(error_of(none, none))));
  EXPECT_EQ(with_error(3.35, infinite), "3.35 ± unknown");
  EXPECT_EQ(with_error(3.35, 0.5), "3.35 ± 0.50");
}

TEST(Estimate, ErrorHasTwoDigits) {
  EXPECT_EQ(with_error(0.94706, 0.000038), "0.947060 ± 0.000038");
  EXPECT_EQ(with_error(0.94706123, 1.2e-7), "0.94706123(12)");
  EXPECT_EQ(with_error(0.94706123, 1.2e-14), "0.947061230000(0)");
  EXPECT_EQ(with_error(1.4153e-9, 1.2e-11), "0.000000001415(12)");
  EXPECT_EQ(with_error(3.497938e-19, 1.37e-23), "3.49794(14)e-19");
  EXPECT_EQ(with_error(-3.497938e-19, 1.37e-20), "-3.50(14)e-19");
  EXPECT_EQ(with_error(9.9999e-20, 1.37e-22), "1.0000(14)e-19");
  EXPECT_EQ(with_error(9.9e-20, 9.6e-20), "9.9(96)e-20");
  EXPECT_EQ(with_error(3.4e-280, 1e-281), "3.40(10)e-280");
  EXPECT_EQ(with_error(3.4e280, 1e279), "3.40(10)e+280");
  EXPECT_EQ(with_error(5e12, 3e14), "5e+12 ± 3e+14");
  EXPECT_EQ(with_error(none, none), "not computed");
}

/// A result with what rows can hold.
struct Fall {
  long number = 0;
  Estimate height;
  double time = 0.0;
  bool good = false;
};

const Quantities<Fall> quantities{{"number", Dimension::none, "", &Fall::number},
                                  {"height", Dimension::length, "", &Fall::height},
                                  {"time", Dimension::time, "", &Fall::time},
                                  {"good", Dimension::none, "", &Fall::good}};

const Fields<Fall> fields(quantities, {},
                          {{"number", {.width = 7}},
                           {"height", {.width = 21, .with_error = true, .mark = {{"good", false}}}},
                           {"time", {.width = 8}}});

const std::vector<Fall> falls{{1, {0.5, 0.25}, 0.1, true}, {2, {1.0 / 3.0, infinite}, 2.0, false}};

/// What a file holds after these results were written to it.
class File : public testing::Test {
 protected:
  std::string written(Format format) {
    Writer writer(Output(path_, Output::Use::rows), format, provenance_, fields.columns());
    for (const Fall& fall : falls) writer.add(fields.row(fall));
    writer.finish();
    std::ifstream file(path_);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  void TearDown() override { std::filesystem::remove(path_); }

  std::string path_ = testing::TempDir() + "stoss_rows.txt";
  Provenance provenance_{"falls", "stoss fall", {{"drop", 2}}};
};

TEST_F(File, TableHasTheEssentials) {
  EXPECT_EQ(written(Format::table),
            " number               height    time\n"
            "                           R     R/c\n"
            "      1        0.50 ± 0.25       0.1\n"
            "      2 0.333333 ± unknown !       2\n");
}

TEST_F(File, CsvHasAllAndReadsBackAsTheSameValues) {
  EXPECT_TRUE(written(Format::csv)
                  .ends_with("# command: stoss fall\n# drop: 2\n"
                             "number,height[R],height_error[R],time[R/c],good\n"
                             "1,0.5,0.25,0.1,true\n"
                             "2,0.3333333333333333,unknown,2,false\n"));
  std::vector<Row> rows;
  const Output file(path_, Output::Use::resume);
  const auto [size, checked] =
      read_earlier(file, provenance_, fields.columns(), [&](const Row& row) { rows.push_back(row); });
  EXPECT_EQ(size, std::filesystem::file_size(path_));
  EXPECT_EQ(rows, (std::vector<Row>{{1.0, 0.5, 0.25, 0.1, true}, {2.0, 1.0 / 3.0, std::string(unknown), 2.0, false}}));
}

TEST_F(File, JsonHasValuesAndUnits) {
  const auto document = nlohmann::json::parse(written(Format::json));
  EXPECT_EQ(document["units"], (nlohmann::json{{"height", "R"}, {"height_error", "R"}, {"time", "R/c"}}));
  EXPECT_EQ(document["records"][1],
            (nlohmann::json{
                {"number", 2}, {"height", 1.0 / 3.0}, {"height_error", "unknown"}, {"time", 2.0}, {"good", false}}));
}

TEST(Rows, AValueWhoseErrorIsUnknownIsNotShownInATable) {
  const std::string path = testing::TempDir() + "stoss_unknown.txt";
  const Fields<Fall> plain(quantities, {}, {{"height", {.width = 10}}});
  Writer writer(Output(path, Output::Use::whole), Format::table, {}, plain.columns());
  for (const Fall& fall : falls) writer.add(plain.row(fall));
  writer.finish();
  std::ifstream file(path);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "    height\n         R\n       0.5\n   unknown\n");
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace stoss::cli
