#pragma once

#include <array>
#include <cstddef>

namespace stoss::bodies::plate {

/// A matrix of N × N numbers, N ≤ 2, real ones or pairs, which compilers keep in registers.
template <typename T, int N>
struct SmallMatrix {
  std::array<std::array<T, N>, N> rows{};

  constexpr T& operator()(int i, int j) { return rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]; }
  constexpr const T& operator()(int i, int j) const {
    return rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
};

/// A diagonal one.
template <typename T, int N>
struct Diagonal {
  std::array<T, N> its{};

  constexpr T& operator()(int i) { return its[static_cast<std::size_t>(i)]; }
  constexpr const T& operator()(int i) const { return its[static_cast<std::size_t>(i)]; }
};

/// The matrix of element(i, j).
template <int N, typename Element>
[[nodiscard]] constexpr auto matrix_of(const Element& element) {
  SmallMatrix<decltype(element(N, N)), N> its;
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) its(i, j) = element(i, j);
  }
  return its;
}

template <typename T, typename U, int N>
[[nodiscard]] constexpr auto operator+(const SmallMatrix<T, N>& x, const SmallMatrix<U, N>& y) {
  return matrix_of<N>([&](int i, int j) { return x(i, j) + y(i, j); });
}

template <typename T, typename U, int N>
[[nodiscard]] constexpr auto operator-(const SmallMatrix<T, N>& x, const SmallMatrix<U, N>& y) {
  return matrix_of<N>([&](int i, int j) { return x(i, j) - y(i, j); });
}

template <typename T, int N>
[[nodiscard]] constexpr auto operator+(const Diagonal<T, N>& x, SmallMatrix<T, N> y) {
  for (int i = 0; i < N; ++i) y(i, i) = x(i) + y(i, i);
  return y;
}

template <typename T, typename U, int N>
[[nodiscard]] constexpr auto operator*(const SmallMatrix<T, N>& x, const SmallMatrix<U, N>& y) {
  return matrix_of<N>([&](int i, int j) {
    if constexpr (N == 1) {
      return x(i, 0) * y(0, j);
    } else {
      return x(i, 0) * y(0, j) + x(i, 1) * y(1, j);
    }
  });
}

template <typename T, typename U, int N>
[[nodiscard]] constexpr auto operator*(const Diagonal<T, N>& x, const SmallMatrix<U, N>& y) {
  return matrix_of<N>([&](int i, int j) { return x(i) * y(i, j); });
}

template <typename T, typename U, int N>
[[nodiscard]] constexpr auto operator*(const SmallMatrix<T, N>& x, const Diagonal<U, N>& y) {
  return matrix_of<N>([&](int i, int j) { return x(i, j) * y(j); });
}

template <typename T, typename U, int N>
[[nodiscard]] constexpr auto operator*(const Diagonal<T, N>& x, const Diagonal<U, N>& y) {
  Diagonal<U, N> its;
  for (int i = 0; i < N; ++i) its(i) = x(i) * y(i);
  return its;
}

template <typename T, typename U, int N>
[[nodiscard]] constexpr auto operator*(const T& x, const SmallMatrix<U, N>& y) {
  return matrix_of<N>([&](int i, int j) { return x * y(i, j); });
}

/// x + y, x on the diagonal.
template <typename T, int N>
[[nodiscard]] constexpr auto plus(double x, SmallMatrix<T, N> y) {
  for (int i = 0; i < N; ++i) y(i, i) = x + y(i, i);
  return y;
}

template <typename T, int N>
[[nodiscard]] constexpr auto transposed(const SmallMatrix<T, N>& x) {
  return matrix_of<N>([&](int i, int j) { return x(j, i); });
}

template <typename T, int N>
[[nodiscard]] constexpr T determinant(const SmallMatrix<T, N>& x) {
  if constexpr (N == 1) {
    return x(0, 0);
  } else {
    return x(0, 0) * x(1, 1) - x(0, 1) * x(1, 0);
  }
}

template <typename T, int N>
[[nodiscard]] constexpr auto inverse(const SmallMatrix<T, N>& x) {
  const T over = 1.0 / determinant(x);
  if constexpr (N == 1) {
    return SmallMatrix<T, 1>{{{{over}}}};
  } else {
    return SmallMatrix<T, 2>{{{{over * x(1, 1), -over * x(0, 1)}, {-over * x(1, 0), over * x(0, 0)}}}};
  }
}

}  // namespace stoss::bodies::plate
