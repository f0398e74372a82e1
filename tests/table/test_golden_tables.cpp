// What tables give and what is written of them, against files: tests/data/tables. A failing test names the file that it
// has written; where a change is meant, that one takes the place of the stored one.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "data/tables/alike.h"
#include "data/tables/clamped.h"
#include "data/tables/mixture.h"
#include "data/tables/plain.h"
#include "data/tables/strict.h"
#include "data/tables/unequal.h"
#include "support/csv.hpp"
#include "table/golden.hpp"

namespace stoss {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double not_a_value = std::numeric_limits<double>::quiet_NaN();

/// Words and numbers of a text: functions of the C library differ in the last place between processors.
std::pair<std::string, std::vector<double>> words_and_numbers(const std::string& text) {
  std::pair<std::string, std::vector<double>> parts;
  for (std::size_t i = 0; i < text.size();) {
    const bool digit = text[i] >= '0' && text[i] <= '9';
    const char before = i == 0 ? ' ' : text[i - 1];
    if (digit && (before == ' ' || before == '-' || before == '{')) {
      char* end = nullptr;
      parts.second.push_back(std::strtod(&text[i], &end));
      i = static_cast<std::size_t>(end - text.data());
    } else {
      parts.first += text[i++];
    }
  }
  return parts;
}

void expect_stored(const std::string& name, const std::string& text) {
  std::ifstream file(test::data_path("tables/" + name));
  std::stringstream stored;
  stored << file.rdbuf();
  const auto [words, numbers] = words_and_numbers(text);
  const auto [expected_words, expected] = words_and_numbers(stored.str());
  bool same = words == expected_words && numbers.size() == expected.size();
  for (std::size_t i = 0; same && i < numbers.size(); ++i) {
    same = std::abs(numbers[i] - expected[i]) <= 1e-14 * (1.0 + std::abs(expected[i]));
  }
  if (same) return;
  const std::string written = testing::TempDir() + name;
  std::ofstream(written) << text;
  ADD_FAILURE() << "tests/data/tables/" << name << " differs from " << written;
}

TEST(GoldenTables, AreTheHeadersThatAreStored) {
  const auto label = [](const char* name) {
    return TableLabel{.name = name, .unit = "m/s", .scale = 5172.19, .provenance = {"stoss", "", "as given"}};
  };
  expect_stored("clamped.h", c_header(test::golden_function(Beyond::clamp), label("clamped")));
  expect_stored("unequal.h", c_header(test::golden_pairs(false, Beyond::error), label("unequal")));
  expect_stored("mixture.h", c_header(test::golden_rule(true, Beyond::clamp), label("mixture")));
  // In the unit of the table.
  expect_stored("strict.h", c_header(test::golden_function(Beyond::error), {.name = "strict", .by_models = 0.0123}));
  expect_stored("alike.h", c_header(test::golden_pairs(true, Beyond::clamp), {.name = "alike"}));
  expect_stored("plain.h", c_header(test::golden_rule(false, Beyond::error), {.name = "plain"}));
}

TEST(GoldenTables, AreTheModulesThatAreStored) {
  const TableLabel clamped{.name = "clamped", .unit = "m/s", .scale = 5172.19, .provenance = {"stoss", "", "as given"}};
  const RestitutionFunction function = test::golden_function(Beyond::clamp);
  const PairTable pairs = test::golden_pairs(true, Beyond::clamp);
  expect_stored("clamped.rs", rust_module(function, clamped));
  expect_stored("clamped.mjs", js_module(function, clamped));
  expect_stored("alike.rs", rust_module(pairs, {.name = "alike"}));
  expect_stored("alike.mjs", js_module(pairs, {.name = "alike"}));
  const TableLabel mixture{.name = "mixture", .unit = "m/s", .scale = 5172.19, .provenance = {"stoss", "", "as given"}};
  const RuleTable of_a_mixture = test::golden_rule(true, Beyond::clamp), rule = test::golden_rule(false, Beyond::error);
  expect_stored("mixture.rs", rust_module(of_a_mixture, mixture));
  expect_stored("mixture.mjs", js_module(of_a_mixture, mixture));
  expect_stored("plain.rs", rust_module(rule, {.name = "plain"}));
  expect_stored("plain.mjs", js_module(rule, {.name = "plain"}));
}

const std::vector<double> speeds{0.0,   -0.0, 1e-310, 9e-5, 1e-4,    2e-4, -3e-4, 0.004, 0.00999,   0.01,       0.011,
                                 -0.02, 0.07, 0.15,   0.2,  0.20001, 0.25, 0.3,   0.31,  unlimited, not_a_value};
const std::vector<double> ratios{-1.0, 0.0, 0.1, 0.3, 1.0 / 3.0, 0.5, 0.55, 0.9,       1.0,        1.2,
                                 1.5,  2.0, 3.0, 3.1, 6.9,       7.0, 8.0,  unlimited, not_a_value};
const std::vector<double> slips{0.0, 1e-3, -0.01, 0.1, -7.0, unlimited, not_a_value};
const std::vector<double> few_ratios{0.0, 0.3, 0.9, 1.2, 3.0, unlimited}, few_slips{1e-3, -0.01, 0.5};

/// A look-up in the header in C: arguments, then what it gives.
std::string row(const std::string& table, const std::vector<double>& numbers) {
  std::string text = table;
  for (const double each : numbers) {
    char number[40];
    (void)std::snprintf(number, sizeof number, ", %.17g", std::isnan(each) ? not_a_value : each);
    text += number;
  }
  return text + "\n";
}

std::string look_ups_in_c() {
  std::string text;
  for (const double v : speeds) {
    text += row("strict", {v, strict_restitution(v), strict_restitution_error(v)});
    const double scaled = 5172.19 * v;
    text += row("clamped", {scaled, clamped_restitution(scaled), clamped_restitution_error(scaled)});
    for (const double r : ratios) {
      text += row("alike", {v, r, alike_pair_restitution(v, r), alike_pair_restitution_error(v, r)});
      text +=
          row("unequal", {scaled, r, unequal_pair_restitution(scaled, r), unequal_pair_restitution_error(scaled, r)});
    }
    for (const double s : slips) {
      for (const double mu : {0.0, 0.3, 1.7, -0.1, unlimited}) {
        text += row("plain", {v, s, mu, plain_rule_restitution(v, s, mu, 1.0), plain_rule_sliding(v, s, mu, 1.0),
                              plain_rule_restitution_error(v, s, mu, 1.0), plain_rule_sliding_error(v, s, mu, 1.0)});
      }
    }
    for (const double s : few_slips) {
      for (const double r : few_ratios) {
        const double w = 5172.19 * s;
        text += row("mixture",
                    {scaled, w, r, mixture_rule_restitution(scaled, w, 0.3, r), mixture_rule_sliding(scaled, w, 0.3, r),
                     mixture_rule_restitution_error(scaled, w, 0.3, r), mixture_rule_sliding_error(scaled, w, 0.3, r)});
      }
    }
  }
  return text;
}

TEST(GoldenTables, GiveInCWhatIsStored) { expect_stored("look_ups_in_c.csv", look_ups_in_c()); }

/// What a look-up gives, or that it refuses.
template <typename LookUp>
Estimate given(LookUp look_up) {
  try {
    return look_up();
  } catch (const InvalidInput&) {
    return {not_a_value, -1.0};
  }
}

std::string look_ups() {
  std::string text;
  const auto add = [&](const char* table, std::vector<double> numbers, const Estimate& found) {
    numbers.push_back(found.value), numbers.push_back(found.error);
    text += row(table, numbers);
  };
  for (const Beyond beyond : {Beyond::error, Beyond::clamp}) {
    const RestitutionFunction function = test::golden_function(beyond);
    const PairTable unequal = test::golden_pairs(false, beyond), alike = test::golden_pairs(true, beyond);
    const RuleTable plain = test::golden_rule(false, beyond), mixture = test::golden_rule(true, beyond);
    const auto along = [](const Rule& rule) { return Estimate{rule.sliding_after, rule.sliding_error}; };
    for (const double v : speeds) {
      add("function", {v}, given([&] { return function(v); }));
      for (const double r : ratios) {
        add("unequal", {v, r}, given([&] { return unequal(v, r); }));
        add("alike", {v, r}, given([&] { return alike(v, r); }));
      }
      for (const double r : few_ratios) {
        for (const double s : few_slips) {
          add("mixture", {v, s, 0.3, r}, given([&] { return mixture(v, s, 0.3, r).restitution; }));
          add("mixture", {v, s, 0.3, r}, given([&] { return along(mixture(v, s, 0.3, r)); }));
        }
      }
      for (const double s : slips) {
        for (const double mu : {0.0, 0.3}) {
          add("plain", {v, s, mu}, given([&] { return plain(v, s, mu).restitution; }));
          add("plain", {v, s, mu}, given([&] { return along(plain(v, s, mu)); }));
        }
      }
    }
  }
  return text;
}

TEST(GoldenTables, GiveWhatIsStored) { expect_stored("look_ups.csv", look_ups()); }

}  // namespace
}  // namespace stoss
