// Series as people type them, against exact arithmetic.
#include "stoss/encounter/series.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/refusal.hpp"

namespace stoss {
namespace {

struct Case {
  const char* text;
  std::vector<double> values;
};

// By Python: fractions.Fraction for lin, decimal with 120 digits for log, then float().
const std::vector<Case> oracle{
    {"log:1e-3:0.1:5", {0.001, 0.0031622776601683794, 0.01, 0.03162277660168379, 0.1}},
    {"log:0.01:0.16:5", {0.01, 0.02, 0.04, 0.08, 0.16}},
    {"log:1e-4:0.3:7",
     {0.0001, 0.0003797696104623708, 0.0014422495703074083, 0.005477225575051661, 0.02080083823051904,
      0.07899526232095005, 0.3}},
    {"log:1e-8:1:4", {1e-08, 4.6415888336127786e-06, 0.002154434690031884, 1.0}},
    {"log:0.3:1e-4:4", {0.3, 0.02080083823051904, 0.0014422495703074083, 0.0001}},
    {"log:3e-308:1e308:5", {3e-308, 2.2795070569547775e-154, 1.7320508075688772, 1.3160740129524924e+154, 1e+308}},
    {"log:4e-324:1e-320:4", {5e-324, 5.4e-323, 7.36e-322, 1e-320}},
    {"lin:0.1:0.3:3", {0.1, 0.2, 0.3}},
    {"lin:0:0.4:8",
     {0.0, 0.05714285714285714, 0.11428571428571428, 0.17142857142857143, 0.22857142857142856, 0.2857142857142857,
      0.34285714285714286, 0.4}},
    {"lin:-0.9:0.9:7", {-0.9, -0.6, -0.3, 0.0, 0.3, 0.6, 0.9}},
    {"lin:1:2:10",
     {1.0, 1.1111111111111112, 1.2222222222222223, 1.3333333333333333, 1.4444444444444444, 1.5555555555555556,
      1.6666666666666667, 1.7777777777777777, 1.8888888888888888, 2.0}},
    {"lin:0.1:0.7:7", {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7}},
    {"lin:1e-320:1e-300:3", {1e-320, 5e-301, 1e-300}},
    {"lin:-1e30:1:4", {-1e+30, -6.666666666666666e+29, -3.333333333333333e+29, 1.0}},
    {"lin:9007199254740992:9007199254740994:3", {9007199254740992.0, 9007199254740992.0, 9007199254740994.0}},
    {"lin:9007199254740994:9007199254740996:3", {9007199254740994.0, 9007199254740996.0, 9007199254740996.0}},
    {"lin:1.7e308:-1.7e308:4", {1.7e+308, 5.666666666666667e+307, -5.666666666666667e+307, -1.7e+308}},
    {"lin:0.5:0.5:2", {0.5, 0.5}},
    {"lin:0.25:1:1", {0.25}},
};

TEST(Series, ValuesAreTheDoublesNearestToTheExactOnes) {
  for (const Case& each : oracle) EXPECT_EQ(parse_series("speed", each.text), each.values) << each.text;
}

TEST(Series, NumbersOfAListAreTheNearestDoubles) {
  const std::vector<double> expected{
      0.1, -0.2, 1e-4, 5.0, 0.5, 2.2250738585072014e-308, 5e-324, 1e23, 9007199254740992.0};
  EXPECT_EQ(parse_series("speed", "0.1, -.2,+1E-04 ,5.,00.5,22250738585072014e-324,4.9e-324,1e23,9007199254740993"),
            expected);
  EXPECT_EQ(parse_series("speed", "0.3"), std::vector<double>{0.3});
  EXPECT_EQ(parse_number("speed", "1" + std::string(390, '0') + "e-390"), 1.0);
  EXPECT_EQ(parse_number("speed", "0e99999999999999999999"), 0.0);
  EXPECT_TRUE(std::signbit(parse_number("speed", "-0")));
}

TEST(Series, OneNumberOfASeriesIsItsFirst) {
  EXPECT_EQ(parse_series("speed", "log:0.1:0.2:1"), std::vector<double>{0.1});
  EXPECT_EQ(parse_series("speed", "lin: 0.1 : 0.2 : 1 "), std::vector<double>{0.1});
}

TEST(Series, ALongOneIsMonotonousAndEndsWhereItShould) {
  const std::vector<double> values = parse_series("speed", "log:1e-6:0.5:20e3");
  ASSERT_EQ(values.size(), 20000U);
  for (std::size_t i = 1; i < values.size(); ++i) ASSERT_GT(values[i], values[i - 1]);
  EXPECT_EQ(values.back(), 0.5);
  EXPECT_NEAR(values[10000], 1e-6 * std::pow(5e5, 10000.0 / 19999.0), 1e-16);
}

TEST(Series, Refuses) {
  const std::string many = ", allowed a number, a list a,b,c, log:a:b:n or lin:a:b:n";
  const auto expect = [&](const std::string& text, const std::string& reason) {
    EXPECT_EQ(test::message_of<InvalidInput>([&] { (void)parse_series("speed", text); }),
              "speed: got '" + text + "'" + many + " (" + reason + ")");
  };
  for (const char* text :
       {"a", "--1", "+-1", "0x10", "nan", "inf", "1e", ".", "1.2.3", "0.1;0.2", "1_000", "LOG:1:2:3"}) {
    expect(text, "it is not a decimal number");
  }
  expect("", "a number is missing");
  expect("0.1,,0.2", "a number is missing");
  expect("0.1,x", "'x' is not a decimal number");
  expect("1e309", "it is beyond double precision, about 1e-308 to 1e308");
  expect("1e-324,1", "'1e-324' is beyond double precision, about 1e-308 to 1e308");
  expect("1e99999999999999999999", "it is beyond double precision, about 1e-308 to 1e308");
  expect("lin:0:1e400:3", "'1e400' is beyond double precision, about 1e-308 to 1e308");
  expect("log:0.1:0.2", "it needs three parts after the first colon");
  expect("log:0.1:0.2:3:4", "it needs three parts after the first colon");
  expect("log:0:1:3", "a logarithmic series needs ends above 0");
  for (const char* count : {"0", "-1", "1.5", "1000001"}) {
    expect("lin:0:1:" + std::string(count), "n is " + std::string(count) + ", not a whole number from 1 to 1000000");
  }
  EXPECT_EQ(test::message_of<InvalidInput>([] { (void)parse_number("poisson", "1,2"); }),
            "poisson: got '1,2', allowed one decimal number, as in 0.33 or 1e-4 (it is not a decimal number)");
}

TEST(Series, WholeNumbers) {
  EXPECT_EQ(parse_integer("nodes", "1e3"), 1000);
  EXPECT_EQ(parse_integer("nodes", "-64.0"), -64);
  const std::string allowed = ", allowed one whole number, as in 64 or 1e3";
  EXPECT_EQ(test::message_of<InvalidInput>([] { (void)parse_integer("nodes", "1.5"); }),
            "nodes: got '1.5'" + allowed + " (it is not a whole number)");
  EXPECT_EQ(test::message_of<InvalidInput>([] { (void)parse_integer("nodes", "3e9"); }),
            "nodes: got '3e9'" + allowed + " (it is too large)");
}

}  // namespace
}  // namespace stoss
