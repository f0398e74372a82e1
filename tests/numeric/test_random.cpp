// Random numbers by counter: the published answers of Philox4x32-10, and no number twice.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include "numeric/random.hpp"

namespace stoss::numeric {
namespace {

/// The uniform number of two words, in long double: the upper 52 bits, and half of the last.
long double expected(std::uint32_t high, std::uint32_t low) {
  const long double all = std::ldexp(static_cast<long double>(high), 32) + static_cast<long double>(low);
  return std::ldexp(std::floor(std::ldexp(all, -12)) + 0.5L, -52);
}

// The known answers that come with Random123 (kat_vectors, philox4x32 10).
TEST(Random, HasThePublishedNumbers) {
  const auto zero = uniform(0, {0, 0, 0, 0});
  EXPECT_EQ(zero[0], expected(0x6627e8d5, 0xe169c58d));
  EXPECT_EQ(zero[1], expected(0xbc57ac4c, 0x9b00dbd8));
  constexpr std::uint32_t all = std::numeric_limits<std::uint32_t>::max();
  const auto ones = uniform(std::numeric_limits<std::uint64_t>::max(), {all, all, all, all});
  EXPECT_EQ(ones[0], expected(0x408f276d, 0x41c83b0e));
  EXPECT_EQ(ones[1], expected(0xa20bc7c6, 0x6d5451fd));
  const auto pi = uniform(0x299f31d0a4093822, {0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344});
  EXPECT_EQ(pi[0], expected(0xd16cfe09, 0x94fdcceb));
  EXPECT_EQ(pi[1], expected(0x5001e420, 0x24126ea1));
}

TEST(Random, FillsTheUnitIntervalEvenlyAndNeverRepeats) {
  constexpr std::uint32_t count = 20000;
  std::set<double> seen;
  double sum = 0.0, squares = 0.0, product = 0.0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [u, v] = uniform(7, {i, 0, 3, 1});
    ASSERT_GT(std::min(u, v), 0.0);
    ASSERT_LT(std::max(u, v), 1.0);
    seen.insert({u, v});
    sum += (u + v - 1.0) / count;
    squares += ((u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5)) / count;
    product += (u - 0.5) * (v - 0.5) / count;
  }
  EXPECT_EQ(seen.size(), 2 * count);
  // Five standard errors of each.
  EXPECT_LT(std::abs(sum), 5.0 * std::sqrt(2.0 / 12.0 / count));
  EXPECT_LT(std::abs(squares - 2.0 / 12.0), 5.0 * std::sqrt(2.0 / 180.0 / count));
  EXPECT_LT(std::abs(product), 5.0 / 12.0 / std::sqrt(count));
}

}  // namespace
}  // namespace stoss::numeric
