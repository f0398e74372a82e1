#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "relaxation/zeros.hpp"

namespace stoss::quasistatic {

/// Gauss' nodes of a piece of a motion, and coefficients of ξ^k, −1 … 1, of what is computed there or its integrals.
inline constexpr std::size_t piece_nodes = 12;
using AtNodes = std::array<double, piece_nodes>;
using Polynomial = std::array<double, piece_nodes + 2>;

[[nodiscard]] double value_of(const Polynomial& p, double x);
/// ∫ p dξ from −1, times a factor, plus a constant
[[nodiscard]] Polynomial integral_of(const Polynomial& p, double factor, double constant);

/// Nodes ξ in rising order.
[[nodiscard]] const AtNodes& node_places();

/// What has values at the nodes: a polynomial, and the size of its last two Legendre terms.
struct Interpolant {
  Polynomial polynomial{};
  double tail = 0.0;
};
[[nodiscard]] Interpolant interpolate(const AtNodes& values);

/// What a material remembers of a rate: ∫ e^(−κ(t − t′)) rate dt′ for each κ.
using Memories = std::vector<double>;

/// The memories at ξ of a piece of half the length `half`, where the rate is a polynomial: exact for any κ.
/// @param before at ξ = −1
void remember(const Rates& rates, const Memories& before, const Polynomial& rate, double half, double x,
              Memories& result);

/// relaxed·elastic + Σ share·memory, a force after it has relaxed.
[[nodiscard]] double relaxed_force(const Rates& rates, double elastic, const Memories& memories);

}  // namespace stoss::quasistatic
