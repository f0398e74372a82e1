#pragma once

#include <vector>

namespace stoss::bodies::sphere {

/// Nodes and weights with which Σ f(x) over x = 0, 1, …, count − 1 is Σ weight · f(node) for polynomials f of degree
/// below twice the number of nodes: the zeros of the discrete Chebyshev polynomials.
struct SumRule {
  std::vector<double> node, weight;
};

/// @param nodes of the rule; where there are no more terms, these are the rule
[[nodiscard]] SumRule sum_rule(long count, int nodes);

}  // namespace stoss::bodies::sphere
