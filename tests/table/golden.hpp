#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "stoss/table/c_source.hpp"
#include "support/rules.hpp"

/// Tables of given values, of every kind: one axis, two, and those of the rule.
namespace stoss::test {

inline RestitutionFunction golden_function(Beyond beyond) {
  TableValues values;
  for (const double v : {0.0001, 0.0003, 0.0005, 0.002, 0.003, 0.01, 0.02, 0.05, 0.11, 0.13, 0.3}) {
    values.speeds.push_back(v);
    values.values.push_back({0.98 - 1.7 * v + 5.0 * v * v, 1e-4 + 1e-3 * v});
  }
  for (int k = 0; k < 10; ++k) values.interpolation_error.push_back(1e-5 * (1 + k % 3));
  return RestitutionFunction(std::move(values), beyond);
}

inline PairTable golden_pairs(bool alike, Beyond beyond) {
  TableValues values;
  values.speeds = {0.01, 0.013, 0.02, 0.05, 0.06, 0.2};
  values.ratios = alike ? std::vector{1.0, 1.5, 3.0} : std::vector{0.5, 0.6, 0.9, 1.3, 2.0, 7.0};
  values.alike = alike;
  for (const double v : values.speeds) {
    for (const double r : values.ratios) {
      values.values.push_back({0.9 - v + 2.0 * v * v - 0.02 * (r + 1.0 / r), 1e-3 * (1.0 + v)});
    }
  }
  values.interpolation_error.assign((values.speeds.size() - 1) * (values.ratios.size() - 1), 2e-3);
  return PairTable(std::move(values), beyond);
}

inline RuleTable golden_rule(bool mixture, Beyond beyond) {
  RuleValues values = mixture ? some_rule({1.0, 1.5, 3.0}) : some_rule();
  values.restitution.alike = values.sliding.alike = mixture;
  if (mixture) values.friction = 0.3;
  return RuleTable(std::move(values), beyond);
}

}  // namespace stoss::test
