#pragma once

#include <array>
#include <cstddef>

namespace stoss::bodies::plate {

/// A number a + bε with ε² = Square: −1, a complex number without the special cases of std::complex for infinities, or
/// 0, where functions of z + ε are their value and, as b, their derivative.
template <int Square>
struct DualNumber {
  double a = 0.0, b = 0.0;

  constexpr DualNumber() = default;
  constexpr DualNumber(double real, double other = 0.0) : a(real), b(other) {}  // NOLINT: a real number is one

  friend constexpr DualNumber operator-(const DualNumber& x) { return {-x.a, -x.b}; }
  friend constexpr DualNumber operator+(const DualNumber& x, const DualNumber& y) { return {x.a + y.a, x.b + y.b}; }
  friend constexpr DualNumber operator+(double x, const DualNumber& y) { return {x + y.a, y.b}; }
  friend constexpr DualNumber operator-(const DualNumber& x, const DualNumber& y) { return {x.a - y.a, x.b - y.b}; }
  friend constexpr DualNumber operator-(double x, const DualNumber& y) { return {x - y.a, -y.b}; }
  friend constexpr DualNumber operator*(const DualNumber& x, const DualNumber& y) {
    if constexpr (Square == 0) return {x.a * y.a, x.a * y.b + x.b * y.a};
    return {x.a * y.a + Square * (x.b * y.b), x.a * y.b + x.b * y.a};
  }
  friend constexpr DualNumber operator*(const DualNumber& x, double y) { return {x.a * y, x.b * y}; }
  friend constexpr DualNumber operator*(double x, const DualNumber& y) { return {x * y.a, x * y.b}; }
  friend constexpr DualNumber operator/(double x, const DualNumber& y) {
    const double over = x / (y.a * y.a - Square * (y.b * y.b));
    return {over * y.a, -over * y.b};
  }
  friend constexpr DualNumber operator/(const DualNumber& x, const DualNumber& y) { return x * (1.0 / y); }
};

constexpr double first(double x) { return x; }
template <int Square>
constexpr double first(const DualNumber<Square>& x) {
  return x.a;
}
template <int Square>
constexpr double second(const DualNumber<Square>& x) {
  return x.b;
}

/// Not less than the absolute value.
constexpr double magnitude(double x) { return x < 0.0 ? -x : x; }
template <int Square>
constexpr double magnitude(const DualNumber<Square>& x) {
  return Square == 0 ? magnitude(x.a) : magnitude(x.a) + magnitude(x.b);
}

using Complex = DualNumber<-1>;
using Differentiable = DualNumber<0>;

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
