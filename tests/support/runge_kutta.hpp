#pragma once

#include <array>
#include <cstddef>

namespace stoss::test {

/// One step of the classical fourth-order method for y' = slope(y).
template <std::size_t size, typename Slope>
std::array<double, size> runge_kutta_step(const std::array<double, size>& y, double step, const Slope& slope) {
  const auto shifted = [&](const std::array<double, size>& by, double length) {
    std::array<double, size> result = y;
    for (std::size_t i = 0; i < size; ++i) result[i] += length * by[i];
    return result;
  };
  const auto first = slope(y);
  const auto second = slope(shifted(first, 0.5 * step));
  const auto third = slope(shifted(second, 0.5 * step));
  const auto fourth = slope(shifted(third, step));
  std::array<double, size> sum{};
  for (std::size_t i = 0; i < size; ++i) sum[i] = (first[i] + fourth[i]) / 6.0 + (second[i] + third[i]) / 3.0;
  return shifted(sum, step);
}

}  // namespace stoss::test
