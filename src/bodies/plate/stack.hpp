#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "bodies/plate/sheet.hpp"
#include "bodies/plate/slab.hpp"

namespace stoss::bodies::plate {

/// All layers, from the lower face up.
template <int N, typename T>
[[nodiscard]] Face<T, N> stack(const Sheets& sheets, double k, T z) {
  Face<T, N> face;
  for (std::size_t i = sheets.all.size(); i-- > 0;) {
    face = layer_face<N, T>(sheets.all[i], k, z, [&](const auto& slab) {
      if (i + 1 < sheets.all.size() || sheets.floor == Floor::free) return stacked(face, slab);
      if (sheets.floor == Floor::antisymmetric) return held_below(slab, 0);
      return N == 1 ? stacked(face, slab) : held_below(slab, N - 1);
    });
  }
  return face;
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
