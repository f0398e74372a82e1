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

StaticOrders::StaticOrders(double poisson)
    : zero_(static_flexibility(poisson, 0)),
      one_(static_flexibility(poisson, 1)),
      low_(0.5 * (1.0 + poisson)),
      high_(0.5 * (3.0 - poisson)) {}

StaticSums StaticOrders::at(double theta, double cosine_sum, double sine_sum, double last, double highest) const {
  const double cosine = std::cos(theta), sine = std::sin(theta);
  const double c = cosine_sum, s = sine_sum;
  // Σ cos nθ/(n−1), Σ cos nθ/(n+1) and the same with sin nθ, from n = 2 to N: shifted by one order. sin Nθ = 0.
  const double up_cosine = cosine * c - sine * s - last * (1.0 / (highest - 1.0) + cosine / highest);
  const double down_cosine =
      cosine * c + sine * s - 1.0 - 0.5 * cosine + last * (cosine / highest + 1.0 / (highest + 1.0));
  const double up_sine = sine * c + cosine * s - last * sine / highest;
  const double down_sine = cosine * s - sine * c - 0.5 * sine - last * sine / highest;
  return {zero_.radial + one_.radial * cosine + low_ * up_cosine + high_ * down_cosine,
          one_.mixed * sine - low_ * up_sine + high_ * down_sine,
          zero_.tangential + one_.tangential * cosine + low_ * up_cosine + high_ * down_cosine};
}

}  // namespace stoss::bodies::disk
