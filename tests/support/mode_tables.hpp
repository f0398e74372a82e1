#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "stoss/bodies/round.hpp"
#include "support/csv.hpp"

namespace stoss::test {

/// The modes in each window of a table of tests/data (of one Poisson's ratio and order, between two frequencies) are
/// those of mpmath: as many, ω to 1e-12 and the amplitudes of columns `radial` and `tangential` to 1e-10.
/// @param modes_of all modes of a Poisson's ratio
/// @param weight that the tangential amplitude has beside the radial one, of an order
/// @returns the number of modes that were compared
inline std::size_t compare_with_mpmath(const std::string& table, const std::string& radial,
                                       const std::string& tangential,
                                       const std::function<std::vector<bodies::Mode>(double)>& modes_of,
                                       const std::function<double(int)>& weight) {
  std::map<std::tuple<double, int, double, double>, std::vector<bodies::Mode>> expected;
  for (const auto& row : read_csv(table)) {
    expected[{row.number("poisson"), row.integer("n"), row.number("window_low"), row.number("window_high")}].push_back(
        {row.integer("n"), 0, row.number("omega"), row.number(radial), row.number(tangential)});
  }
  std::map<double, std::vector<bodies::Mode>> modes;
  std::size_t compared = 0;
  for (const auto& [window, reference] : expected) {
    const auto& [poisson, order, low, high] = window;
    auto& all = modes[poisson];
    if (all.empty()) all = modes_of(poisson);
    std::vector<bodies::Mode> found;
    for (const bodies::Mode& mode : all) {
      if (mode.order == order && mode.omega > low && mode.omega < high) found.push_back(mode);
    }
    SCOPED_TRACE("nu = " + std::to_string(poisson) + ", n = " + std::to_string(order) + ", omega from " +
                 std::to_string(low) + " to " + std::to_string(high));
    EXPECT_EQ(found.size(), reference.size());
    for (std::size_t i = 0; i < std::min(found.size(), reference.size()); ++i, ++compared) {
      const double along = weight(order);
      const double amplitude = std::max(std::abs(reference[i].radial), along * std::abs(reference[i].tangential));
      EXPECT_NEAR(found[i].omega / reference[i].omega, 1.0, 1e-12);
      EXPECT_NEAR(found[i].radial, reference[i].radial, 1e-10 * amplitude) << "omega " << found[i].omega;
      EXPECT_NEAR(along * found[i].tangential, along * reference[i].tangential, 1e-10 * amplitude)
          << "omega " << found[i].omega;
    }
  }
  return compared;
}

}  // namespace stoss::test
