#include "numeric/parabolic_cubic.hpp"

namespace stoss::numeric {

std::vector<double> parabolic_slopes(const std::vector<double>& x, const std::vector<double>& y, bool even) {
  const std::size_t last = x.size() - 1;
  const auto width = [&](std::size_t k) { return x[k + 1] - x[k]; };
  const auto secant = [&](std::size_t k) { return (y[k + 1] - y[k]) / width(k); };
  // How the secant of an interval changes to the next, per unit of the length of both.
  const auto bend = [&](std::size_t k) { return (secant(k + 1) - secant(k)) / (width(k) + width(k + 1)); };
  std::vector<double> slope;
  slope.push_back(even && x[0] == 0.0 ? 0.0 : secant(0) - width(0) * bend(0));
  for (std::size_t k = 1; k < last; ++k) slope.push_back(secant(k - 1) + width(k - 1) * bend(k - 1));
  slope.push_back(secant(last - 1) + width(last - 1) * bend(last - 2));
  return slope;
}

}  // namespace stoss::numeric
