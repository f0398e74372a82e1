// What the three tables have in common, as they are faces of one: that of ε_n stands for a rule.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "stoss/table/pair_table.hpp"
#include "stoss/table/restitution_function.hpp"
#include "stoss/table/rule_table.hpp"
#include "support/refusal.hpp"
#include "support/rules.hpp"

namespace stoss {
namespace {

constexpr double without_bound = std::numeric_limits<double>::infinity();
constexpr double not_any = std::numeric_limits<double>::quiet_NaN();

using LookUp = std::function<Estimate(double speed, double ratio)>;

struct Face {
  std::string name;
  LookUp (*made)(const TableValues& values, Beyond beyond);
  bool is_mixture;

  /// Of no smooth function, at uneven places.
  [[nodiscard]] TableValues values() const {
    const std::vector<double> ratios = is_mixture ? std::vector{1.0, 1.4, 2.0, 7.0} : std::vector{1.0};
    const auto uneven = [](double v, double, double r) { return 0.6 + 0.3 * std::sin(1e3 * v + 7.0 * r); };
    return test::rule_grid({0.01, 0.013, 0.02, 0.05, 0.06, 0.2}, {0.0}, ratios, uneven);
  }
};

void PrintTo(const Face& face, std::ostream* stream) { *stream << face.name; }

LookUp function(const TableValues& values, Beyond beyond) {
  return [table = RestitutionFunction(values, beyond)](double v, double) {
    const Estimate found = table(v);
    EXPECT_EQ(table.value(v), found.value);
    EXPECT_LE(found.error, std::isfinite(found.error) ? table.greatest_error() : found.error);
    return found;
  };
}

LookUp pairs(const TableValues& values, Beyond beyond) {
  return [table = PairTable(values, beyond)](double v, double r) {
    const Estimate found = table(v, r);
    EXPECT_EQ(table.value(v, r), found.value);
    EXPECT_LE(found.error, std::isfinite(found.error) ? table.greatest_error() : found.error);
    return found;
  };
}

LookUp rule(const TableValues& values, Beyond beyond) {
  const auto line = [](double, double z, double) { return z > 0.0 ? z : 0.0; };
  RuleValues both{values, test::rule_grid({0.01, 0.2}, {-1.0, 0.0, 1.0}, values.ratios, line)};
  both.sliding.alike = values.alike;
  return [table = RuleTable(both, beyond)](double v, double r) { return table(v, 0.1, 0.3, r).restitution; };
}

class Tables : public testing::TestWithParam<Face> {};

TEST_P(Tables, MeetTheirValuesWithTheirErrors) {
  const TableValues given = GetParam().values();
  const LookUp table = GetParam().made(given, Beyond::error);
  const double weight = GetParam().is_mixture ? 1.25 : 1.0;
  std::size_t i = 0;
  for (const double v : given.speeds) {
    for (const double r : given.ratios) {
      EXPECT_NEAR(table(v, r).value, given.values[i++].value, 1e-14) << v << ' ' << r;
      EXPECT_NEAR(table(v, r).error, weight * 1e-3 + 1e-4, 1e-15);
      EXPECT_EQ(table(-v, r).value, table(v, r).value);
    }
  }
}

TEST_P(Tables, RefuseWhatIsBeyondTheirRangeOrClampIt) {
  const LookUp strict = GetParam().made(GetParam().values(), Beyond::error);
  const LookUp clamped = GetParam().made(GetParam().values(), Beyond::clamp);
  const auto refuses = [&](const LookUp& table, double v, double r, const std::vector<std::string>& parts) {
    test::expect_refusal([&] { (void)table(v, r); }, parts);
  };
  for (const double v : {0.0, -0.0, 1e-300, 0.009, -0.009}) {
    refuses(strict, v, 1.0, {"speed: got ", "0.01 to 0.2", "the range for which"});
    EXPECT_EQ(clamped(v, 1.0).value, clamped(0.01, 1.0).value) << v;
    EXPECT_EQ(clamped(v, 1.0).error, without_bound);
  }
  for (const double v : {0.21, -3.0, 1e300}) {
    refuses(strict, v, 1.0, {"speed: got ", "0.01 to 0.2"});
    EXPECT_EQ(clamped(v, 1.0).value, clamped(0.2, 1.0).value) << v;
  }
  for (const double bad : {not_any, without_bound, -without_bound}) {
    for (const LookUp& table : {strict, clamped}) {
      refuses(table, bad, 1.0, {"speed: got ", "finite"});
      if (GetParam().is_mixture) refuses(table, 0.1, bad, {"ratio: got ", "positive finite"});
    }
  }
  if (!GetParam().is_mixture) return;
  refuses(strict, 0.1, 0.9, {"ratio: got 0.9, allowed 1 to 7"});
  refuses(strict, 0.1, 8.0, {"ratio: got 8, allowed 1 to 7"});
  EXPECT_EQ(clamped(0.1, 9.0).value, clamped(0.1, 7.0).value);
  EXPECT_EQ(clamped(3.0, 0.1).value, clamped(0.2, 1.0).value);
  for (const double bad : {0.0, -1.0}) refuses(clamped, 0.1, bad, {"ratio: got "});
}

TEST_P(Tables, OfBodiesThatAreAlikeAreSymmetric) {
  if (!GetParam().is_mixture) return;
  TableValues given = GetParam().values();
  given.alike = true;
  const LookUp table = GetParam().made(given, Beyond::error);
  for (const double r : {1.0, 1.1, 1.7, 2.2, 7.0}) {
    EXPECT_NEAR(table(0.03, r).value, table(0.03, 1.0 / r).value, 1e-15) << r;
    EXPECT_EQ(table(0.03, r).error, table(0.03, 1.0 / r).error) << r;
  }
  const double step = 1e-4;  // no kink at 1
  EXPECT_NEAR(table(0.03, 1.0 + step).value, table(0.03, 1.0).value, 100.0 * step * step);
  test::expect_refusal([&] { (void)table(0.03, 8.0); }, {"ratio: got 8, allowed 1 to 7 or inverse"});
}

TEST_P(Tables, RefuseValuesOfNoTable) {
  const auto refuse = [](const std::function<void(TableValues&)>& spoil, const std::vector<std::string>& parts) {
    TableValues values = GetParam().values();
    spoil(values);
    test::expect_refusal([&] { (void)GetParam().made(values, Beyond::error); }, parts);
  };
  for (const double bad : {0.0, -1.0, not_any, without_bound, 0.01}) {
    refuse([bad](TableValues& values) { values.speeds[1] = bad; }, {"speeds: got "});
    refuse([bad](TableValues& values) { values.ratios[0] = bad < 0.01 ? bad : not_any; }, {"ratios: got "});
  }
  refuse([](TableValues& values) { values.alike = true, values.ratios[0] = 0.5; }, {"ratios: got 0.5"});
  refuse([](TableValues& values) { values.slips = {-1.0, 0.5}; }, {"slips"});
  refuse([](TableValues& values) { values.values.pop_back(); }, {"restitution: got "});
  for (const double bad : {not_any, without_bound}) {
    refuse([bad](TableValues& values) { values.values[3].value = bad; }, {"restitution", "not converged"});
    refuse([bad](TableValues& values) { values.values[3].error = bad; }, {"restitution", "not converged"});
  }
  refuse([](TableValues& values) { values.interpolation_error.push_back(0.0); }, {"interpolation_error: got "});
  for (const double bad : {-1.0, not_any, without_bound}) {
    refuse([bad](TableValues& values) { values.interpolation_error[3] = bad; }, {"interpolation_error"});
  }
  test::expect_refusal([] { (void)GetParam().made(GetParam().values(), Beyond::law); }, {"beyond: got law"});
}

INSTANTIATE_TEST_SUITE_P(Table, Tables,
                         testing::Values(Face{"function", &function, false}, Face{"pairs", &pairs, true},
                                         Face{"rule", &rule, false}, Face{"rule_of_a_mixture", &rule, true}),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace stoss
