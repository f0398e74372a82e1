#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "stoss/restitution/restitution.hpp"

namespace stoss::test {

/// How often values lie within their errors, and how much larger these are than the true ones.
struct Judged {
  int points = 0, within = 0;
  std::vector<double> padding;  ///< estimated over true error

  /// @param most errors that the true one may reach
  void add(const Estimate& found, double reference, double uncertainty,
           double most = std::numeric_limits<double>::infinity()) {
    const double off = std::abs(found.value - reference);
    EXPECT_LE(off, most * found.error + uncertainty);
    ++points;
    within += off <= found.error + uncertainty ? 1 : 0;
    // Elsewhere the difference is the reference's error as much as that of the value.
    if (uncertainty <= 0.1 * found.error) padding.push_back(found.error / off);
  }

  /// That so many are within, and that the median of the padding, of so many at least, is 10 at most.
  void expect_honest(double share, std::size_t least) {
    EXPECT_GE(within, share * points);
    ASSERT_GE(padding.size(), least);
    const auto middle = padding.begin() + static_cast<std::ptrdiff_t>(padding.size() / 2);
    std::nth_element(padding.begin(), middle, padding.end());
    EXPECT_LE(*middle, 10.0);
  }
};

}  // namespace stoss::test
