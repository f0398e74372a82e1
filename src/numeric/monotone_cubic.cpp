#include "numeric/monotone_cubic.hpp"

#include <utility>

namespace stoss::numeric {

MonotoneCubic::MonotoneCubic(std::vector<double> at, std::vector<double> of) : x(std::move(at)), y(std::move(of)) {
  const auto secant = [this](std::size_t k) { return (y[k + 1] - y[k]) / (x[k + 1] - x[k]); };
  slope.push_back(secant(0));
  for (std::size_t k = 1; k + 1 < x.size(); ++k) {
    const double left = secant(k - 1), right = secant(k), before = x[k] - x[k - 1], after = x[k + 1] - x[k];
    const double first = 2.0 * after + before, second = after + 2.0 * before;
    slope.push_back(left * right > 0.0 ? (first + second) / (first / left + second / right) : 0.0);
  }
  slope.push_back(secant(x.size() - 2));
}

}  // namespace stoss::numeric
