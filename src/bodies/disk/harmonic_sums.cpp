// What the infinite sums have beyond N at θ = mπ/N is (−1)^m ∫₀^∞ e^{−τ} dτ/(N(e^z − 1)), z = τ/N − iθ: the pole 1/z
// gives e^z E₁(z), the rest is regular and is expanded about τ = 0.
#include "bodies/disk/harmonic_sums.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace stoss::bodies::disk {
namespace {

/// e^z E₁(z) at z = −iπm, by Lentz' continued fraction (Abramowitz and Stegun 5.1.22).
std::complex<double> exponential_integral(std::size_t m) {
  const std::complex<double> z(0.0, -std::numbers::pi * static_cast<double>(m));
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
  return result;
}

}  // namespace

HarmonicSums harmonic_sums(std::size_t m, std::size_t highest) {
  if (m > highest) {
    const HarmonicSums mirrored = harmonic_sums(2 * highest - m, highest);
    return {mirrored.cosine, -mirrored.sine};
  }
  const auto nyquist = static_cast<double>(highest);
  if (m == 0) return {std::log(nyquist) + std::numbers::egamma - 1.0 / (12.0 * nyquist * nyquist), 0.0};
  constexpr std::size_t tabulated = 512;
  static const std::array<std::complex<double>, tabulated> table = [] {
    std::array<std::complex<double>, tabulated> result{};
    for (std::size_t k = 1; k < tabulated; ++k) result[k] = exponential_integral(k);
    return result;
  }();
  const std::complex<double> pole = m < tabulated ? table[m] : exponential_integral(m);
  const double order = std::numbers::pi * static_cast<double>(m);
  const double theta = order / nyquist;
  const double sine = 2.0 * std::sin(0.5 * theta);
  const double sign = m % 2 == 0 ? 1.0 : -1.0;
  const double beyond_cosine = pole.real() + 1.0 / (sine * sine * nyquist * nyquist) - 1.0 / (order * order);
  const double beyond_sine = pole.imag() + std::cos(0.5 * theta) / (sine * nyquist) - 1.0 / order;
  return {-std::log(sine) - sign * beyond_cosine, 0.5 * (std::numbers::pi - theta) - sign * beyond_sine};
}

HarmonicSums infinite_harmonic_sums(double theta) {
  return {-std::log(2.0 * std::sin(0.5 * theta)), 0.5 * (std::numbers::pi - theta)};
}

}  // namespace stoss::bodies::disk
