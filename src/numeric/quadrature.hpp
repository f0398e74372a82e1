#pragma once

#include <vector>

#include "stoss/poll.hpp"

namespace stoss::numeric {

/// Nodes and weights of Gauss–Legendre quadrature on −1 … 1, ascending.
struct GaussRule {
  std::vector<double> node, weight;
};

/// The rule of any number of nodes, to 1e-15; kept for the next call on the same thread.
/// Takes the square of their number: 0.1 s for some 10⁴.
[[nodiscard]] const GaussRule& gauss_legendre(int nodes, const Poll& poll = {});

/// Nodes and weights with which Σ f(x) over x = 0, 1, …, count − 1 is Σ weight · f(node) for polynomials f of degree
/// below twice the number of nodes: the zeros of the discrete Chebyshev polynomials.
struct SumRule {
  std::vector<double> node, weight;
};

/// @param nodes of the rule; where there are no more terms, these are the rule
[[nodiscard]] SumRule sum_rule(long count, int nodes);

}  // namespace stoss::numeric
