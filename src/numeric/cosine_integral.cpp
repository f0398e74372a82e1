#include "numeric/cosine_integral.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace stoss::numeric {
namespace {

/// γ + ln x + Σ_k (−x²)^k/(2k (2k)!)  (Abramowitz and Stegun 5.2.16).
double by_series(double x) {
  double sum = std::numbers::egamma + std::log(x), term = 1.0;
  for (int k = 2; k < 60; k += 2) {
    term *= -x * x / (k * (k - 1.0));
    sum += term / k;
    if (std::abs(term) < 1e-17) break;
  }
  return sum;
}

/// −Re E₁(ix), by Lentz' continued fraction for e^z E₁(z) (Abramowitz and Stegun 5.1.22).
double by_fraction(double x) {
  const std::complex<double> z(0.0, x);
  std::complex<double> b = z + 1.0, c(1e300, 0.0), d = 1.0 / b, result = d;
  for (int k = 1; k < 1000; ++k) {
    const double a = -static_cast<double>(k) * k;
    b += 2.0;
    d = 1.0 / (a * d + b);
    c = b + a / c;
    const std::complex<double> factor = c * d;
    result *= factor;
    if (std::abs(factor - 1.0) < 1e-16) break;
  }
  return -(std::polar(1.0, -x) * result).real();
}

}  // namespace

double cosine_integral(double x) { return x < 3.0 ? by_series(x) : by_fraction(x); }

}  // namespace stoss::numeric
