#pragma once

namespace stoss::bodies::plate {

/// A number a + bε with ε² = Square: −1, a complex number without the special cases of std::complex for infinities, or
/// 0, where functions of z + ε are their value and, as b, their derivative.
template <int Square>
struct PairNumber {
  double a = 0.0, b = 0.0;

  constexpr PairNumber() = default;
  constexpr PairNumber(double real, double other = 0.0) : a(real), b(other) {}  // NOLINT: a real number is one

  friend constexpr PairNumber operator-(const PairNumber& x) { return {-x.a, -x.b}; }
  friend constexpr PairNumber operator+(const PairNumber& x, const PairNumber& y) { return {x.a + y.a, x.b + y.b}; }
  friend constexpr PairNumber operator+(double x, const PairNumber& y) { return {x + y.a, y.b}; }
  friend constexpr PairNumber operator-(const PairNumber& x, const PairNumber& y) { return {x.a - y.a, x.b - y.b}; }
  friend constexpr PairNumber operator-(double x, const PairNumber& y) { return {x - y.a, -y.b}; }
  friend constexpr PairNumber operator*(const PairNumber& x, const PairNumber& y) {
    if constexpr (Square == 0) return {x.a * y.a, x.a * y.b + x.b * y.a};
    return {x.a * y.a + Square * (x.b * y.b), x.a * y.b + x.b * y.a};
  }
  friend constexpr PairNumber operator*(const PairNumber& x, double y) { return {x.a * y, x.b * y}; }
  friend constexpr PairNumber operator*(double x, const PairNumber& y) { return {x * y.a, x * y.b}; }
  friend constexpr PairNumber operator/(double x, const PairNumber& y) {
    const double over = x / (y.a * y.a - Square * (y.b * y.b));
    return {over * y.a, -over * y.b};
  }
  friend constexpr PairNumber operator/(const PairNumber& x, const PairNumber& y) { return x * (1.0 / y); }
};

/// Not less than the absolute value.
constexpr double magnitude(double x) { return x < 0.0 ? -x : x; }
template <int Square>
constexpr double magnitude(const PairNumber<Square>& x) {
  return Square == 0 ? magnitude(x.a) : magnitude(x.a) + magnitude(x.b);
}

using Complex = PairNumber<-1>;
using Differentiable = PairNumber<0>;

}  // namespace stoss::bodies::plate
