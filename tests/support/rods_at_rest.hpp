#pragma once

#include <cmath>
#include <utility>

#include "vibration/rod_vibrations.hpp"

namespace stoss::test {

/// ε of two unexcited rods, exactly (docs/theory/pairs.md).
inline double restitution_at_rest(const Rod& one, const Rod& other) {
  RodMeasures quick(one), slow(other);
  if (quick.transit > slow.transit) std::swap(quick, slow);
  const double z1 = quick.impedance, z2 = slow.impedance, ratio = slow.transit / quick.transit;
  if (z1 <= z2) return (z2 - z1 + 2.0 * z1 / ratio) / (z1 + z2);
  const double r = (z1 - z2) / (z1 + z2), whole = std::floor(ratio);
  return (1.0 + quick.mass / slow.mass) * (1.0 - std::pow(r, whole) * (1.0 - (ratio - whole) * (1.0 - r))) - 1.0;
}

}  // namespace stoss::test
