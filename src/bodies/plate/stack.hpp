#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "bodies/plate/sheet.hpp"
#include "bodies/plate/slab.hpp"

namespace stoss::bodies::plate {

/// A layer on all those below it.
template <int N, typename T>
[[nodiscard]] Face<T, N> with_layer(const Sheets& sheets, std::size_t i, double k, T z, const Face<T, N>& below) {
  return layer_face<N, T>(sheets.all[i], k, z, [&](const auto& slab) {
    if (i + 1 < sheets.all.size() || sheets.floor == Floor::free) return stacked(below, slab);
    if (sheets.floor == Floor::antisymmetric) return held_below(slab, 0);
    return N == 1 ? stacked(below, slab) : held_below(slab, N - 1);
  });
}

/// All layers, from the lower face up.
template <int N, typename T>
[[nodiscard]] Face<T, N> stack(const Sheets& sheets, double k, T z) {
  Face<T, N> face;
  for (std::size_t i = sheets.all.size(); i-- > 0;) face = with_layer<N, T>(sheets, i, k, z, face);
  return face;
}

/// The same of moduli that are multiplied, also by complex factors or such with a derivative: a layer of mE answers at
/// z with m times what one of E answers at z/m. No vibrations are counted.
/// @param factor m of a kind of layers
template <int N, typename T, typename Factor>
[[nodiscard]] SmallMatrix<T, N> stack_of_factors(const Sheets& sheets, double k, T z, const Factor& factor) {
  Face<T, N> face;
  for (std::size_t i = sheets.all.size(); i-- > 0;) {
    const T its = factor(sheets.all[i].kind);
    face.stiffness = (1.0 / its) * face.stiffness;
    face.stiffness = its * with_layer<N, T>(sheets, i, k, z / its, face).stiffness;
  }
  return face.stiffness;
}

/// a of numbers a + bε, and b.
template <typename T, int N>
[[nodiscard]] Eigen::Matrix<double, N, N> first(const SmallMatrix<T, N>& matrix) {
  Eigen::Matrix<double, N, N> its;
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) its(i, j) = first(matrix(i, j));
  }
  return its;
}

template <typename T, int N>
[[nodiscard]] Eigen::Matrix<double, N, N> second(const SmallMatrix<T, N>& matrix) {
  return first(matrix_of<N>([&](int i, int j) { return second(matrix(i, j)); }));
}

}  // namespace stoss::bodies::plate
