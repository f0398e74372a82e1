#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "bodies/surface/residual.hpp"
#include "numeric/cosine_integral.hpp"
#include "numeric/gauss_legendre.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies {

/// Calls visit(k, length, weight) for the wave numbers of a quadrature, whose weights are ½ length · weight, of what is
/// smooth over factors of 2, from 0 on altogether, but for products of two shapes at distances up to the farthest.
template <typename Visit>
void for_wave_numbers(double begin, double end, double farthest, const Visit& visit) {
  constexpr double phase = 16.0;  // by which a product of two shapes turns in a panel
  const auto& rule = numeric::gauss_legendre(16);
  const double widest = 0.5 * phase / farthest;
  for (double from = begin; from < end;) {
    const double to = std::min({end, from > 0.0 ? 2.0 * from : widest, from + widest});
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      visit(0.5 * (from + to) + 0.5 * (to - from) * rule.node[i], to - from, rule.weight[i]);
    }
    from = to;
  }
}

/// Points that are equally spaced in angle lie closer to each other the further out they are: each pair has the wave
/// numbers that its own distance resolves. High ones add C cos(kΔr)/k, so the change from the common end K is
/// C [Ci(π|i−j|) − Ci(KΔr)], of a point by itself −C ln cos α.
/// @param visit receives i, j ≤ i, and the bracket
template <typename Visit>
void for_pairs_beyond(const ContactPoints& points, double highest, const Visit& visit) {
  std::vector<double> wanted{0.0};
  for (std::size_t k = 1; k < points.count; ++k) {
    wanted.push_back(numeric::cosine_integral(std::numbers::pi * static_cast<double>(k)));
  }
  for (std::size_t i = 0; i < points.count; ++i) {
    visit(i, i, -std::log(std::cos(points.angle(i))));
    const double here = lateral_distance(points, i);
    for (std::size_t j = 0; j < i; ++j) {
      const double apart = here - lateral_distance(points, j);
      visit(i, j, wanted[i - j] - numeric::cosine_integral(highest * apart));
    }
  }
}

}  // namespace stoss::bodies
