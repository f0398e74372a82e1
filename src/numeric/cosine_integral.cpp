#include "numeric/cosine_integral.hpp"

#include <cmath>
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

/// −Re E₁(ix), by the continued fraction for e^z E₁(z) (Abramowitz and Stegun 5.1.22), from the term on that no longer
/// matters where x ≥ 3.
double by_fraction(double x) {
  const int terms = 5 + static_cast<int>(180.0 / x);
  double rest_real = 0.0, rest_imaginary = 0.0;  // of 1²/(z + 3 − 2²/(z + 5 − …)), z = ix
  for (int k = terms; k > 0; --k) {
    const double real = 2.0 * k + 1.0 - rest_real, imaginary = x - rest_imaginary;
    const double share = static_cast<double>(k) * k / (real * real + imaginary * imaginary);
    rest_real = share * real;
    rest_imaginary = -share * imaginary;
  }
  const double real = 1.0 - rest_real, imaginary = x - rest_imaginary;
  return (std::sin(x) * imaginary - std::cos(x) * real) / (real * real + imaginary * imaginary);
}

}  // namespace

double cosine_integral(double x) { return x < 3.0 ? by_series(x) : by_fraction(x); }

}  // namespace stoss::numeric
