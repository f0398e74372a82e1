// Points and weights of the rules of quadrature that spectral elements of order 4 take along a row or column, on (−1,
// 1), and the derivatives of the polynomials through these points.
#pragma once

#include <array>
#include <cstddef>

namespace bench {

inline constexpr std::size_t element_side = 5;  ///< nodes

struct SpectralRule {
  using Row = std::array<double, element_side>;

  Row points, weights;
  /// d/dr of the polynomial that is 1 at one point and 0 at the others, at all points: [point][polynomial].
  std::array<Row, element_side> derivative;
};

constexpr SpectralRule spectral_rule(const SpectralRule::Row& x, const SpectralRule::Row& weights) {
  SpectralRule result{x, weights, {}};
  for (std::size_t i = 0; i < element_side; ++i) {
    for (std::size_t j = 0; j < element_side; ++j) {
      for (std::size_t k = 0; k < element_side; ++k) {
        if (k == j) continue;
        double product = 1.0 / (x[j] - x[k]);
        for (std::size_t l = 0; l < element_side; ++l) {
          if (l != j && l != k) product *= (x[i] - x[l]) / (x[j] - x[l]);
        }
        result.derivative[i][j] += product;
      }
    }
  }
  return result;
}

/// Gauss–Lobatto: exact for ∫ f dr, f of degree 7.
inline constexpr SpectralRule lobatto = spectral_rule({-1.0, -0.654653670707977144, 0.0, 0.654653670707977144, 1.0},
                                                      {1.0 / 10, 49.0 / 90, 32.0 / 45, 49.0 / 90, 1.0 / 10});

/// Gauss–Lobatto–Jacobi: exact for ∫ f (1 + r) dr, f of degree 7. For elements whose side r = −1 lies on an axis of
/// symmetry, where nodes would have no mass by the other rule (C. Bernardi, M. Dauge & Y. Maday, Spectral Methods for
/// Axisymmetric Domains, 1999).
inline constexpr SpectralRule lobatto_at_axis =
    spectral_rule({-1.0, -0.507787629558314916, 0.132300820777323228, 0.708820142114325022, 1.0},
                  {1.0 / 75, 0.289656694561163306, 0.736004369481632757, 0.794338935957203937, 1.0 / 6});

}  // namespace bench
