#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "stoss/table/rule_table.hpp"

/// Collision rules that nobody computed.
namespace stoss::test {

/// A grid with a function of speed, z and ratio, and the error 1e-3.
template <typename Function>
TableValues rule_grid(std::vector<double> speeds, std::vector<double> slips, std::vector<double> ratios,
                      Function function) {
  TableValues grid{std::move(speeds), std::move(slips), std::move(ratios)};
  for (const double v : grid.speeds) {
    for (const double z : grid.slips) {
      for (const double r : grid.ratios) grid.values.push_back({function(v, z, r), 1e-3});
    }
  }
  const auto intervals = [](const std::vector<double>& places) { return places.size() > 1 ? places.size() - 1 : 1; };
  grid.interpolation_error.assign(intervals(grid.speeds) * intervals(grid.slips) * intervals(grid.ratios), 1e-4);
  return grid;
}

/// A rule from speed 0.01 to 0.2 that sticks for small s, and slides throughout from z = 0.75 on.
inline RuleValues some_rule(const std::vector<double>& ratios = {1.0}) {
  const auto restitution = [](double v, double, double r) { return 0.97 - 0.5 * v - 0.01 * (r + 1.0 / r); };
  const auto sliding = [](double v, double z, double r) {
    const double friction = 0.5 * (6.5 + v + 0.1 * (r + 1.0 / r)) * (1.0 - z);  // what gross sliding takes
    if (z >= 0.75) return 0.5 * (1.0 + z) - friction;
    const double stick = -0.2 * (1.0 + z) * (1.0 - v), last = 0.875 - 0.25 * friction / (1.0 - z);
    return stick + (last - -0.35 * (1.0 - v)) * std::pow((1.0 + z) / 1.75, 4);
  };
  return {rule_grid({0.01, 0.02, 0.05, 0.2}, {0.0}, ratios, restitution),
          rule_grid({0.01, 0.03, 0.2}, {-1.0, -0.5, 0.0, 0.5, 0.75, 0.8, 0.9, 1.0}, ratios, sliding)};
}

/// Any numbers, many of them beyond what conserves energy.
inline RuleValues wild_rule(unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(-1.5, 1.5);
  const auto wild = [&](double, double, double) { return any(random); };
  return {rule_grid({0.01, 0.02, 0.05, 0.2}, {0.0}, {1.0}, wild),
          rule_grid({0.01, 0.03, 0.2}, {-1.0, -0.5, 0.0, 0.5, 0.75, 1.0}, {1.0}, wild)};
}

}  // namespace stoss::test
