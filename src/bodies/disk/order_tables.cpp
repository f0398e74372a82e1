// What the infinite sums have beyond N at θ = mπ/N is (−1)^m ∫₀^∞ e^{−τ} dτ/(N(e^z − 1)), z = τ/N − iθ: the pole 1/z
// gives e^z E₁(z), the rest is regular and is expanded about τ = 0.
#include "bodies/disk/order_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "bodies/disk/edge_points.hpp"

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

namespace {

std::size_t nyquist_order(double h) { return static_cast<std::size_t>(std::lround(std::numbers::pi / h)); }

}  // namespace

OrderTables::OrderTables(const OrderSum& sum, const ContactPoints& points, const Poll& poll)
    : radial_(2 * points.count), mixed_(2 * points.count), tangential_(2 * points.count) {
  if (sum.with_static) add_static(sum.poisson, points.spacing);
  add_orders(sum.coefficients, points.spacing, poll);
}

/// The sums of the closed-form flexibilities of all orders up to Nyquist (docs/theory/walls.md).
void OrderTables::add_static(double poisson, double h) {
  const StaticOrders orders(poisson);
  const std::size_t highest = nyquist_order(h);
  for (std::size_t m = 0; m < radial_.size(); ++m) {
    const double last = m % 2 == 0 ? 0.5 : -0.5;
    const auto [cosine, sine] = harmonic_sums(m, highest);
    const StaticSums sums = orders.at(static_cast<double>(m) * h, cosine, sine, last, static_cast<double>(highest));
    radial_[m] = sums.radial;
    mixed_[m] = sums.mixed;
    tangential_[m] = sums.tangential;
  }
}

void OrderTables::add_orders(const std::vector<Flexibility>& coefficients, double h, const Poll& poll) {
  const std::size_t size = radial_.size(), highest = nyquist_order(h);
  std::vector<double> cosine(size), sine(size), cosine_n(size, 1.0), sine_n(size, 0.0);
  for (std::size_t m = 0; m < size; ++m) {
    cosine[m] = std::cos(static_cast<double>(m) * h);
    sine[m] = std::sin(static_cast<double>(m) * h);
  }
  for (std::size_t n = 0; n < std::min(coefficients.size(), highest + 1); ++n) {
    if (poll) poll();
    const double weight = n == highest ? 0.5 : 1.0;
    const Flexibility r{weight * coefficients[n].radial, weight * coefficients[n].mixed,
                        weight * coefficients[n].tangential};
    for (std::size_t m = 0; m < size; ++m) {
      radial_[m] += r.radial * cosine_n[m];
      mixed_[m] += r.mixed * sine_n[m];
      tangential_[m] += r.tangential * cosine_n[m];
      const double next = cosine_n[m] * cosine[m] - sine_n[m] * sine[m];
      sine_n[m] = sine_n[m] * cosine[m] + cosine_n[m] * sine[m];
      cosine_n[m] = next;
    }
  }
}

// At the angles φ(α) with α_i = (i + ½)h equally spaced, the infinite sums are those at φ, and what points of that
// spacing do not resolve is the same as at equally spaced angles: near the singularity, ln|φ − φ′| = ln|α − α′| +
// ln dφ/dα with a smooth remainder.
MappedOrders::MappedOrders(double poisson, const ContactPoints& points)
    : orders_(poisson), resolved_(static_cast<std::size_t>(std::lround(std::numbers::pi / points.spacing))) {
  highest_ = static_cast<double>(resolved_) / points.radius;
  for (std::size_t i = 0; i < points.count; ++i) {
    angle_.push_back(edge_angle(points, i));
    stretch_.push_back(edge_stretch(points, i));
  }
  // What N orders lack of the infinite sums, at m spacings.
  lack_.push_back(harmonic_sums(0, resolved_));
  for (std::size_t m = 1; m < 2 * points.count; ++m) {
    const HarmonicSums some = harmonic_sums(m, resolved_);
    const HarmonicSums all = infinite_harmonic_sums(static_cast<double>(m) * points.spacing);
    lack_.push_back({some.cosine - all.cosine, some.sine - all.sine});
  }
}

PairSums MappedOrders::at(std::size_t i, std::size_t j) const {
  return {sums(i - j, i == j ? 0.0 : angle_[i] - angle_[j], stretch_[i]), sums(i + j + 1, angle_[i] + angle_[j], 1.0)};
}

StaticSums MappedOrders::sums(std::size_t m, double theta, double stretch) const {
  HarmonicSums harmonics = lack_[m];
  if (m == 0) {
    harmonics.cosine -= std::log(stretch);
  } else {
    const HarmonicSums all = infinite_harmonic_sums(theta);
    harmonics.cosine += all.cosine;
    harmonics.sine += all.sine;
  }
  const double last = m % 2 == 0 ? 0.5 : -0.5;
  return orders_.at(theta, harmonics.cosine, harmonics.sine, last, highest_);
}

}  // namespace stoss::bodies::disk
