// Tables as text: what C and readers of two columns get. tests/cli/test_table.py compiles and runs the header.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "stoss/table/c_source.hpp"
#include "stoss/table/two_column.hpp"
#include "support/refusal.hpp"
#include "support/rules.hpp"
#include "table/arguments.hpp"
#include "table/c_text.hpp"

namespace stoss {
namespace {

/// A wave between 1e-4 and 0.3 with a known error.
RestitutionFunction wave(Beyond beyond = Beyond::clamp, double error = 1e-4) {
  TableValues values;
  const double begin = std::log(1e-4), end = std::log(0.3);
  constexpr int last = 60;
  for (int k = 0; k <= last; ++k) {
    const double x = begin + (end - begin) * k / last;
    const double speed = k == 0 ? 1e-4 : k == last ? 0.3 : std::exp(x);
    values.speeds.push_back(speed);
    values.values.push_back({0.9 + 0.05 * std::sin(2.0 * x) - 0.3 * speed, error});
  }
  values.interpolation_error.assign(last, 0.0);
  return RestitutionFunction(std::move(values), beyond);
}

std::vector<std::pair<double, double>> read(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::pair<double, double>> rows;
  for (double speed = 0.0, value = 0.0; in >> speed >> value;) rows.emplace_back(speed, value);
  return rows;
}

/// Maximum distance of chords between rows from a function, at many speeds of each.
double furthest(const std::vector<std::pair<double, double>>& rows, const RestitutionFunction& function, double scale) {
  double worst = 0.0;
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    const auto [from, low] = rows[k];
    const auto [to, high] = rows[k + 1];
    for (int i = 1; i < 200; ++i) {
      const double v = from * std::pow(to / from, i / 200.0);
      const double chord = low + (high - low) * (v - from) / (to - from);
      worst = std::max(worst, std::abs(chord - function.value(v / scale)));
    }
  }
  return worst;
}

TEST(TwoColumns, StayWithinTheErrorBetweenRows) {
  const RestitutionFunction function = wave();
  for (const double error : {2e-4, 1e-3, 1e-2}) {
    const auto rows = read(two_column(function, error));
    EXPECT_EQ(rows.front().first, 1e-4);
    EXPECT_EQ(rows.back().first, 0.3);
    for (std::size_t k = 1; k < rows.size(); ++k) EXPECT_GT(rows[k].first, rows[k - 1].first);
    EXPECT_LE(furthest(rows, function, 1.0) + function.greatest_error(), error);
  }
}

TEST(TwoColumns, HaveNoMoreRowsThanThatTakes) {
  const RestitutionFunction function = wave();
  constexpr double error = 1e-3;
  const auto rows = read(two_column(function, error));
  for (std::size_t k = 0; k + 2 < rows.size(); ++k) {  // without the row between
    EXPECT_GT(furthest({rows[k], rows[k + 2]}, function, 1.0) + function.greatest_error(), error);
  }
  // A chord over h is off by h²|f''|/8: the rows grow as the root of the error.
  const auto finer = read(two_column(function, 1e-4 + 0.25 * (error - 1e-4)));
  EXPECT_NEAR(static_cast<double>(finer.size() - 1) / static_cast<double>(rows.size() - 1), 2.0, 0.2);
}

TEST(TwoColumns, AreInTheUnitOfTheTable) {
  constexpr double c = 5172.19;
  const RestitutionFunction function = wave();
  const auto rows = read(two_column(function, 1e-3, c));
  EXPECT_LE(furthest(rows, function, c) + function.greatest_error(), 1e-3);
}

TEST(TwoColumns, RefuseWhatTheFunctionIsNot) {
  test::expect_refusal([&] { (void)two_column(wave(), 1e-4); }, {"error: got 0.0001, allowed 0.000101 or more"});
  test::expect_refusal([&] { (void)two_column(wave(), std::nan("")); }, {"error: got nan"});
  test::expect_refusal([&] { (void)two_column(wave(), 1e-3, 0.0); }, {"scale: got 0"});
  test::expect_refusal([&] { (void)two_column(wave(), 1e-3, std::nan("")); }, {"scale: got nan"});
}

TEST(TwoColumns, OfARuleStayWithinTheErrorAtOneSpeed) {
  const RuleTable rule(test::some_rule());
  constexpr double speed = 0.04, friction = 0.3, error = 0.01;
  const auto rows = read(two_column(rule, speed, error));
  ASSERT_GT(rows.size(), 4U);
  EXPECT_LT(rows.size(), 30U);
  EXPECT_EQ(rows.front(), (std::pair{0.0, 0.0}));
  for (double w = 0.01; w < 100.0; w *= 1.01) {
    std::size_t k = 0;
    while (k + 2 < rows.size() && rows[k + 1].first <= w) ++k;
    const auto [from, low] = rows[k];
    const auto [to, high] = rows[k + 1];
    const double chord = low + (high - low) * (w - from) / (to - from);
    const double expected = rule(speed, w * friction * speed, friction).sliding_after / (friction * speed);
    EXPECT_LE(std::abs(chord - expected) / (1.0 + w) + rule.greatest_sliding_error(), error * 1.001) << w;
  }
  test::expect_refusal([&] { (void)two_column(rule, speed, 1e-3); }, {"error: got 0.001"});
  test::expect_refusal([&] { (void)two_column(rule, 1.0, error); }, {"speed: got 1"});
  test::expect_refusal([&] { (void)two_column(RuleTable(test::some_rule({1.0, 2.0, 3.0})), speed, error); }, {"ratio"});
}

TEST(SpeedRange, IsWhatWasTyped) {
  // 0.01 m/s over c and back is not 0.01 for every c.
  int rounded = 0;
  for (int i = 0; i < 100; ++i) {
    const double c = 5000.0 + 0.7 * i;
    const double slowest = 0.01 / c, fastest = 7.3 / c;
    if (slowest * c != 0.01 || fastest * c != 7.3) ++rounded;
    const auto [from, to] = table::speed_range(slowest, fastest, c);
    EXPECT_LE(from, 0.01);
    EXPECT_NEAR(from, 0.01, 1e-17);
    EXPECT_GE(to, 7.3);
    EXPECT_NEAR(to, 7.3, 1e-14);
  }
  EXPECT_GT(rounded, 0);
}

TEST(CHeader, RefusesWhatCCannotHave) {
  const SlowLaw none = [](double) { return Estimate{1.0, 0.0}; };
  test::expect_refusal([&] { (void)c_header(RestitutionFunction(wave().values(), Beyond::law, none)); },
                       {"beyond: got law"});
  test::expect_refusal([&] { (void)c_header(wave(), {.scale = -1.0}); }, {"scale: got -1"});
  for (const std::string name : {"", "1a", "_a", "a-b", "ä", "a b"}) {
    test::expect_refusal([&] { (void)c_header(wave(), {.name = name}); }, {"name: got '"});
  }
  test::expect_refusal([&] { (void)c_header(wave(), {.name = std::string(41, 'a')}); }, {"name: got 'aaaa"});
}

TEST(CHeader, HasOneNameForAll) {
  const std::string text = c_header(wave(), {.name = "ball_2"});
  EXPECT_EQ(text.find("stoss"), std::string::npos);
  EXPECT_EQ(text.find('@'), std::string::npos);
  for (const std::string part : {"#ifndef BALL_2_RESTITUTION_TABLE", "double ball_2_restitution(double speed)",
                                 "double ball_2_restitution_error(double speed)", "#define BALL_2_SLOWEST 0.0001",
                                 "#define BALL_2_FASTEST 0.3", "at most 0.0001\n"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
}

TEST(CHeader, IsNotEndedByItsProvenance) {
  const std::string text = c_header(wave(), {.provenance = {"a */ int b; /* c", "/*/ \?\?/", "line\nend\\"}});
  const std::string comment = text.substr(0, text.find("\n#ifndef"));
  EXPECT_EQ(comment.find("*/"), comment.size() - 2);
  EXPECT_EQ(comment.find("/*", 1), std::string::npos);
  EXPECT_EQ(comment.find("\?\?"), std::string::npos);
  EXPECT_NE(comment.find(" * line end\\\n */"), std::string::npos);
}

TEST(CText, NumbersAreDoubles) {
  EXPECT_EQ(table::c_number(1.0), "1.0");
  EXPECT_EQ(table::c_number(-3.0), "-3.0");
  EXPECT_EQ(table::c_number(0.1), "0.1");
  EXPECT_EQ(table::c_number(1e-5), "1e-05");
  EXPECT_EQ(std::stod(table::c_number(1.0 / 3.0)), 1.0 / 3.0);
}

}  // namespace
}  // namespace stoss
