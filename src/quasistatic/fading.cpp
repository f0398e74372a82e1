// ∫₀^L e^(−κu) P(x − u) du = Σ p_k (−1)^k L^(k+1) m_k(κL), P(x + u) = Σ p_k u^k, m_k(z) = ∫₀¹ u^k e^(−zu) du
#include "quasistatic/fading.hpp"

#include <cmath>

#include "numeric/quadrature.hpp"

namespace stoss::quasistatic {
namespace {

constexpr std::size_t degrees = std::tuple_size_v<Polynomial>;

/// Values at the nodes to Legendre's coefficients, and these to those of powers.
struct Basis {
  AtNodes node{};
  std::array<AtNodes, piece_nodes> project{};
  std::array<Polynomial, piece_nodes> power{};

  Basis() {
    const numeric::GaussRule& rule = numeric::gauss_legendre(static_cast<int>(piece_nodes));
    power[0][0] = power[1][1] = 1.0;
    for (std::size_t k = 1; k + 1 < piece_nodes; ++k) {
      const auto n = static_cast<double>(k);
      for (std::size_t i = 0; i <= k + 1; ++i) {
        const double raised = i > 0 ? power[k][i - 1] : 0.0;
        power[k + 1][i] = ((2.0 * n + 1.0) * raised - n * power[k - 1][i]) / (n + 1.0);
      }
    }
    for (std::size_t i = 0; i < piece_nodes; ++i) {
      const double x = node[i] = rule.node[i];
      double last = 0.0, now = 1.0;
      for (std::size_t k = 0; k < piece_nodes; ++k) {
        const auto n = static_cast<double>(k);
        project[k][i] = (n + 0.5) * rule.weight[i] * now;
        const double next = ((2.0 * n + 1.0) * x * now - n * last) / (n + 1.0);
        last = now, now = next;
      }
    }
  }
};

const Basis& basis() {
  static const Basis all;
  return all;
}

/// The coefficients about x.
Polynomial about(Polynomial p, double x) {
  for (std::size_t from = 0; from + 1 < degrees; ++from) {
    for (std::size_t i = degrees - 1; i-- > from;) p[i] += x * p[i + 1];
  }
  return p;
}

/// m_k(z), without a difference of equal terms.
Polynomial moments(double z) {
  Polynomial m{};
  const double gone = std::exp(-z);
  constexpr double many = 40.0;
  if (z > many) {
    m[0] = (1.0 - gone) / z;
    for (std::size_t k = 1; k < degrees; ++k) m[k] = (static_cast<double>(k) * m[k - 1] - gone) / z;
    return m;
  }
  double each = gone / static_cast<double>(degrees), sum = each;
  for (std::size_t i = degrees + 1; each > 1e-17 * sum; ++i) sum += each *= z / static_cast<double>(i);
  m[degrees - 1] = sum;
  for (std::size_t k = degrees - 1; k > 0; --k) m[k - 1] = (z * m[k] + gone) / static_cast<double>(k);
  return m;
}

}  // namespace

double value_of(const Polynomial& p, double x) {
  double sum = 0.0;
  for (std::size_t i = degrees; i-- > 0;) sum = sum * x + p[i];
  return sum;
}

Polynomial integral_of(const Polynomial& p, double factor, double constant) {
  Polynomial result{};
  for (std::size_t i = 1; i < degrees; ++i) result[i] = factor * p[i - 1] / static_cast<double>(i);
  result[0] = constant - value_of(result, -1.0);
  return result;
}

const AtNodes& node_places() { return basis().node; }

Interpolant interpolate(const AtNodes& values) {
  const Basis& all = basis();
  Interpolant result;
  for (std::size_t k = 0; k < piece_nodes; ++k) {
    double coefficient = 0.0;
    for (std::size_t i = 0; i < piece_nodes; ++i) coefficient += all.project[k][i] * values[i];
    for (std::size_t i = 0; i <= k; ++i) result.polynomial[i] += coefficient * all.power[k][i];
    if (k + 2 >= piece_nodes) result.tail += std::abs(coefficient);
  }
  return result;
}

void remember(const Rates& rates, const Memories& before, const Polynomial& rate, double half, double x,
              Memories& result) {
  Polynomial shifted = about(rate, x);
  const double length = 1.0 + x;
  double power = half * length;
  for (double& each : shifted) each *= power, power *= -length;
  result.resize(rates.rate.size());
  for (std::size_t j = 0; j < result.size(); ++j) {
    const double z = rates.rate[j] * half * length;
    const Polynomial m = moments(z);
    double sum = before[j] * std::exp(-z);
    for (std::size_t k = 0; k < degrees; ++k) sum += shifted[k] * m[k];
    result[j] = sum;
  }
}

double relaxed_force(const Rates& rates, double elastic, const Memories& memories) {
  double sum = rates.relaxed * elastic;
  for (std::size_t j = 0; j < memories.size(); ++j) sum += rates.share[j] * memories[j];
  return sum;
}

}  // namespace stoss::quasistatic
