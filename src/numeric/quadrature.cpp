#include "numeric/quadrature.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <numeric>

namespace stoss::numeric {
namespace {

/// Zeros that are found at once: their recurrences do not wait for each other.
constexpr std::size_t lanes = 8;
using Lanes = std::array<double, lanes>;

/// P_n(x) and its derivative.
struct Legendre {
  Lanes value, slope;
};

Legendre legendre(int n, const Lanes& x) {
  Lanes before, value = x;
  before.fill(1.0);
  for (int k = 2; k <= n; ++k) {
    for (std::size_t l = 0; l < lanes; ++l) {
      const double next = ((2.0 * k - 1.0) * x[l] * value[l] - (k - 1.0) * before[l]) / k;
      before[l] = value[l];
      value[l] = next;
    }
  }
  Lanes slope;
  for (std::size_t l = 0; l < lanes; ++l) slope[l] = n * (before[l] - x[l] * value[l]) / (1.0 - x[l] * x[l]);
  return {value, slope};
}

GaussRule made(int nodes, const Poll& poll) {
  GaussRule rule;
  rule.node.resize(static_cast<std::size_t>(nodes));
  rule.weight.resize(rule.node.size());
  const auto count = static_cast<std::size_t>((nodes + 1) / 2);
  for (std::size_t first = 0; first < count; first += lanes) {
    if (poll) poll();
    Lanes x;
    for (std::size_t l = 0; l < lanes; ++l) {
      const auto i = static_cast<double>(std::min(first + l, count - 1));
      x[l] = 2.0 * i + 1.0 == nodes ? 0.0 : std::cos(std::numbers::pi * (i + 0.75) / (nodes + 0.5));
    }
    constexpr int iterations = 8;  // Newton's method doubles the digits of a start that has three
    constexpr double close = 1e-17;
    Lanes last;
    last.fill(1.0);
    const auto open = [](double step) { return std::abs(step) > close; };
    for (int k = 0; k < iterations && std::any_of(last.begin(), last.end(), open); ++k) {
      const Legendre at = legendre(nodes, x);
      for (std::size_t l = 0; l < lanes; ++l) {
        if (!open(last[l])) continue;
        last[l] = at.value[l] / at.slope[l];
        x[l] -= last[l];
      }
    }
    const Lanes slope = legendre(nodes, x).slope;
    for (std::size_t l = 0; l < lanes && first + l < count; ++l) {
      const std::size_t low = first + l, high = rule.node.size() - 1 - low;
      rule.node[low] = -x[l];
      rule.node[high] = x[l];
      rule.weight[low] = rule.weight[high] = 2.0 / ((1.0 - x[l] * x[l]) * slope[l] * slope[l]);
    }
  }
  return rule;
}

}  // namespace

const GaussRule& gauss_legendre(int nodes, const Poll& poll) {
  thread_local std::map<int, GaussRule> known;
  const auto found = known.find(nodes);
  return found != known.end() ? found->second : known.emplace(nodes, made(nodes, poll)).first->second;
}

/// Golub and Welsch: about the middle x = (K−1)/2 of K points the monic discrete Chebyshev polynomials have the
/// recurrence p_{k+1} = x p_k − b_k p_{k−1}, b_k = k² (K² − k²)/(4(4k² − 1)).
SumRule sum_rule(long count, int nodes) {
  SumRule rule;
  if (count <= nodes) {
    rule.node.resize(static_cast<std::size_t>(count));
    std::iota(rule.node.begin(), rule.node.end(), 0.0);
    rule.weight.assign(rule.node.size(), 1.0);
    return rule;
  }
  const auto terms = static_cast<double>(count);
  const double half = 0.5 * terms;
  Eigen::VectorXd side(nodes - 1);  // in units of half the range
  for (int k = 1; k < nodes; ++k) {
    const double square = static_cast<double>(k) * k;
    side(k - 1) = std::sqrt(square * (1.0 - square / (terms * terms)) / (4.0 * square - 1.0));
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(Eigen::VectorXd::Zero(nodes), side);
  for (int k = 0; k < nodes; ++k) {
    const double first = solver.eigenvectors()(0, k);
    rule.node.push_back(0.5 * (terms - 1.0) + half * solver.eigenvalues()(k));
    rule.weight.push_back(terms * first * first);
  }
  return rule;
}

}  // namespace stoss::numeric
