#include "numeric/gauss_legendre.hpp"

#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>

namespace stoss::numeric {
namespace {

/// P_n(x) and its derivative.
struct Legendre {
  double value, slope;
};

Legendre legendre(int n, double x) {
  double before = 1.0, value = x;
  for (int k = 2; k <= n; ++k) {
    const double next = ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k;
    before = value;
    value = next;
  }
  return {value, n * (before - x * value) / (1.0 - x * x)};
}

GaussRule made(int nodes) {
  GaussRule rule;
  rule.node.resize(static_cast<std::size_t>(nodes));
  rule.weight.resize(rule.node.size());
  for (int i = 0; i < (nodes + 1) / 2; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (nodes + 0.5));
    if (2 * i + 1 == nodes) x = 0.0;
    constexpr int iterations = 8;  // Newton's method doubles the digits of a start that has three
    double last = 1.0;
    for (int k = 0; k < iterations && std::abs(last) > 1e-17; ++k) {
      const Legendre at = legendre(nodes, x);
      last = at.value / at.slope;
      x -= last;
    }
    const double slope = legendre(nodes, x).slope;
    const double weight = 2.0 / ((1.0 - x * x) * slope * slope);
    const auto low = static_cast<std::size_t>(i), high = static_cast<std::size_t>(nodes - 1 - i);
    rule.node[low] = -x;
    rule.node[high] = x;
    rule.weight[low] = rule.weight[high] = weight;
  }
  return rule;
}

}  // namespace

const GaussRule& gauss_legendre(int nodes) {
  thread_local std::map<int, GaussRule> known;
  const auto found = known.find(nodes);
  return found != known.end() ? found->second : known.emplace(nodes, made(nodes)).first->second;
}

}  // namespace stoss::numeric
