#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace stoss::test {

using Vector = std::vector<double>;

/// A random symmetric positive definite matrix, A Aᵀ with rows scaled over `decades` decades, plus a little identity.
inline Vector random_compliance(std::size_t size, double decades, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Vector a(size * size), w(size * size, 0.0);
  for (double& value : a) value = normal(random);
  for (std::size_t i = 0; i < size; ++i) {
    const double scale =
        std::pow(10.0, -decades * static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(size - 1, 1)));
    // Columns are scaled, so that the matrix itself, not only its diagonal, is badly conditioned.
    for (std::size_t row = 0; row < size; ++row) a[row * size + i] *= scale;
  }
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t k = 0; k < size; ++k) w[i * size + j] += a[i * size + k] * a[j * size + k];
    }
    w[i * size + i] += 1e-6;
  }
  return w;
}

/// Solves M x = b by Gaussian elimination in long double with pivoting.
inline std::vector<long double> gauss(std::vector<long double> m, std::vector<long double> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i) {
      if (std::abs(m[i * n + k]) > std::abs(m[pivot * n + k])) pivot = i;
    }
    for (std::size_t j = 0; j < n; ++j) std::swap(m[k * n + j], m[pivot * n + j]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const long double factor = m[i * n + k] / m[k * n + k];
      for (std::size_t j = k; j < n; ++j) m[i * n + j] -= factor * m[k * n + j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= m[k * n + j] * b[j];
    b[k] /= m[k * n + k];
  }
  return b;
}

/// The one solution, by trying all 2^size contact sets.
inline Vector by_enumeration(const Vector& w, const Vector& q) {
  const std::size_t size = q.size();
  Vector best;
  long double best_violation = std::numeric_limits<long double>::max();
  for (std::size_t bits = 0; bits < (std::size_t{1} << size); ++bits) {
    std::vector<std::size_t> set;
    for (std::size_t i = 0; i < size; ++i) {
      if ((bits >> i) & 1U) set.push_back(i);
    }
    std::vector<long double> block, right;
    for (const std::size_t i : set) {
      right.push_back(q[i]);
      for (const std::size_t j : set) block.push_back(w[i * size + j]);
    }
    const auto f = gauss(block, right);
    long double violation = 0.0L;
    Vector force(size, 0.0);
    for (std::size_t k = 0; k < set.size(); ++k) {
      force[set[k]] = static_cast<double>(f[k]);
      violation = std::max(violation, -f[k]);
    }
    for (std::size_t i = 0; i < size; ++i) {
      long double gap = -q[i];
      for (std::size_t k = 0; k < set.size(); ++k) gap += w[i * size + set[k]] * f[k];
      if (((bits >> i) & 1U) == 0) violation = std::max(violation, -gap);
    }
    if (violation < best_violation) {
      best_violation = violation;
      best = force;
    }
  }
  return best;
}

}  // namespace stoss::test
