#include "numeric/random.hpp"

#include <Random123/philox.h>

namespace stoss::numeric {
namespace {

constexpr double spacing = 1.0 / static_cast<double>(std::uint64_t{1} << 52U);

double unit(std::uint32_t high, std::uint32_t low) {
  const std::uint64_t bits = std::uint64_t{high} << 32U | low;
  return (static_cast<double>(bits >> 12U) + 0.5) * spacing;
}

}  // namespace

std::array<double, 2> uniform(std::uint64_t seed, const std::array<std::uint32_t, 4>& counter) {
  r123::Philox4x32::ctr_type block;
  for (std::size_t i = 0; i < counter.size(); ++i) block[i] = counter[i];
  r123::Philox4x32::key_type key;
  key[0] = static_cast<std::uint32_t>(seed);
  key[1] = static_cast<std::uint32_t>(seed >> 32U);
  const r123::Philox4x32::ctr_type bits = r123::Philox4x32()(block, key);
  return {unit(bits[0], bits[1]), unit(bits[2], bits[3])};
}

}  // namespace stoss::numeric
