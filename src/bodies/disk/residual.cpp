// cos nφ_i cos nφ_j = ½[cos n(φ_i−φ_j) + cos n(φ_i+φ_j)] and its like reduce the double sums over orders and nodes to
// three one-dimensional tables at the angles mh. In the tables of W the sums over all static flexibilities are closed:
// with partial fractions in n they consist of Σ cos kθ/k and Σ sin kθ/k.
#include "bodies/disk/residual.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "numeric/dense.hpp"

namespace stoss {
namespace {

constexpr double mass = std::numbers::pi;

/// Σ_n R_n cos nθ for R^CC and R^SS and Σ_n R^CS_n sin nθ at the angles θ = mh.
struct Tables {
  std::vector<double> radial, mixed, tangential;
};

void add(Flexibility& sum, const Mode& mode, double weight) {
  sum.radial += weight * mode.radial * mode.radial;
  sum.mixed += weight * mode.radial * mode.tangential;
  sum.tangential += weight * mode.tangential * mode.tangential;
}

std::size_t nyquist_order(double h) { return static_cast<std::size_t>(std::lround(std::numbers::pi / h)); }

double spacing(const ContactGrid& grid) { return 2.0 * grid.coordinate.front(); }

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

/// Σ cos kθ/k and Σ sin kθ/k for k = 1 … N at θ = mπ/N, m < 2N, the last term with weight ½. What the infinite sums
/// have beyond N is (−1)^m ∫₀^∞ e^{−τ} dτ/(N(e^z − 1)), z = τ/N − iθ: the pole 1/z gives e^z E₁(z), the rest is regular
/// and is expanded about τ = 0. Error O(N⁻³).
struct HarmonicSums {
  double cosine, sine;
};

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

/// The tables of the closed-form flexibilities of all orders up to Nyquist (docs/theory/modes.md).
Tables static_tables(double poisson, double h, std::size_t size) {
  const Flexibility zero = static_flexibility(poisson, 0);
  const Flexibility one = static_flexibility(poisson, 1);
  // n ≥ 2: F^CC = F^SS = a/(n−1) + b/(n+1), F^CS = −a/(n−1) + b/(n+1).
  const double a = 0.5 * (1.0 + poisson), b = 0.5 * (3.0 - poisson);
  const std::size_t highest = nyquist_order(h);
  const auto nyquist = static_cast<double>(highest);
  Tables tables;
  for (std::size_t m = 0; m < size; ++m) {
    const double theta = static_cast<double>(m) * h;
    const double cosine = std::cos(theta), sine = std::sin(theta);
    const double last = m % 2 == 0 ? 0.5 : -0.5;  // ½ cos Nθ, N the Nyquist order; sin Nθ = 0
    const auto [c, s] = harmonic_sums(m, highest);
    // Σ cos nθ/(n−1), Σ cos nθ/(n+1) and the same with sin nθ, from n = 2 to N: shifted by one order.
    const double up_cosine = cosine * c - sine * s - last * (1.0 / (nyquist - 1.0) + cosine / nyquist);
    const double down_cosine =
        cosine * c + sine * s - 1.0 - 0.5 * cosine + last * (cosine / nyquist + 1.0 / (nyquist + 1.0));
    const double up_sine = sine * c + cosine * s - last * sine / nyquist;
    const double down_sine = cosine * s - sine * c - 0.5 * sine - last * sine / nyquist;
    tables.radial.push_back(zero.radial + one.radial * cosine + a * up_cosine + b * down_cosine);
    tables.tangential.push_back(zero.tangential + one.tangential * cosine + a * up_cosine + b * down_cosine);
    tables.mixed.push_back(one.mixed * sine - a * up_sine + b * down_sine);
  }
  return tables;
}

/// The coefficients of the orders that a grid of spacing h resolves, the last of them halved.
std::vector<Flexibility> up_to_nyquist(std::vector<Flexibility> coefficients, double h) {
  const std::size_t highest = nyquist_order(h);
  if (coefficients.size() <= highest) return coefficients;
  coefficients.resize(highest + 1);
  Flexibility& last = coefficients.back();
  last = {0.5 * last.radial, 0.5 * last.mixed, 0.5 * last.tangential};
  return coefficients;
}

/// Adds the sums over the given orders, n = 0 … coefficients.size() − 1.
void add_orders(const std::vector<Flexibility>& coefficients, double h, const Poll& poll, Tables& tables) {
  const std::size_t size = tables.radial.size();
  std::vector<double> cosine(size), sine(size), cosine_n(size, 1.0), sine_n(size, 0.0);
  for (std::size_t m = 0; m < size; ++m) {
    cosine[m] = std::cos(static_cast<double>(m) * h);
    sine[m] = std::sin(static_cast<double>(m) * h);
  }
  for (const Flexibility& r : coefficients) {
    if (poll) poll();
    for (std::size_t m = 0; m < size; ++m) {
      tables.radial[m] += r.radial * cosine_n[m];
      tables.mixed[m] += r.mixed * sine_n[m];
      tables.tangential[m] += r.tangential * cosine_n[m];
      const double next = cosine_n[m] * cosine[m] - sine_n[m] * sine[m];
      sine_n[m] = sine_n[m] * cosine[m] + cosine_n[m] * sine[m];
      cosine_n[m] = next;
    }
  }
}

/// The matrix between the nodes φ_i = (i + ½)h from the tables at mh.
std::vector<double> assemble(const Tables& table, const ContactGrid& grid, const Poll& poll) {
  const std::size_t count = grid.coordinate.size();
  std::vector<double> cosine(count), sine(count), matrix = dense::zeros(count * count, poll);
  for (std::size_t i = 0; i < count; ++i) {
    cosine[i] = std::cos(grid.coordinate[i]);
    sine[i] = std::sin(grid.coordinate[i]);
  }
  constexpr std::size_t few = 8;  // rows of the upper triangle at a time, which stay in the cache
  for (std::size_t first = 0; first < count; first += few) {
    if (poll) poll();
    for (std::size_t i = first; i < count; ++i) {
      for (std::size_t j = first; j < std::min(first + few, i + 1); ++j) {
        const std::size_t apart = i - j;
        const std::size_t sum = i + j + 1;
        const double radial = cosine[i] * cosine[j] * (table.radial[sum] + table.radial[apart]);
        const double mixed = cosine[i] * sine[j] * (table.mixed[sum] - table.mixed[apart]) +
                             sine[i] * cosine[j] * (table.mixed[sum] + table.mixed[apart]);
        const double tangential = sine[i] * sine[j] * (table.tangential[apart] - table.tangential[sum]);
        matrix[i * count + j] = matrix[j * count + i] = 0.5 * (radial - mixed + tangential) / mass;
      }
    }
  }
  return matrix;
}

}  // namespace

DiskResidual::DiskResidual(double poisson, double cutoff, const std::vector<Mode>& kept)
    : poisson_(poisson), highest_order_(static_cast<int>(std::lround(8.0 * cutoff))) {
  const auto orders = kept.empty() ? 0 : static_cast<std::size_t>(kept.back().order) + 1;
  kept_radial_.resize(orders);
  kept_.resize(orders);
  kept_squared_.resize(orders);
  for (const Mode& mode : kept) {
    const auto n = static_cast<std::size_t>(mode.order);
    const double compliance = 1.0 / (mode.omega * mode.omega);
    kept_radial_[n] += mode.radial * mode.radial;
    add(kept_[n], mode, compliance);
    add(kept_squared_[n], mode, compliance * compliance);
  }
}

std::vector<double> DiskResidual::compliance(const ContactGrid& grid, const Poll& poll) const {
  if (grid.coordinate.empty()) return {};
  Tables tables = static_tables(poisson_, spacing(grid), 2 * grid.coordinate.size());
  std::vector<Flexibility> minus_kept;
  for (const Flexibility& kept : kept_) minus_kept.push_back({-kept.radial, -kept.mixed, -kept.tangential});
  add_orders(up_to_nyquist(std::move(minus_kept), spacing(grid)), spacing(grid), poll, tables);
  return assemble(tables, grid, poll);
}

std::vector<double> DiskResidual::second_moment(const ContactGrid& grid, const Poll& poll) const {
  if (grid.coordinate.empty()) return {};
  std::vector<Flexibility> residual;
  for (int n = 0; n <= highest_order_; ++n) {
    residual.push_back(static_second_moment(poisson_, n));
    if (static_cast<std::size_t>(n) < kept_squared_.size()) {
      const Flexibility& kept = kept_squared_[static_cast<std::size_t>(n)];
      residual.back().radial -= kept.radial;
      residual.back().mixed -= kept.mixed;
      residual.back().tangential -= kept.tangential;
    }
  }
  const std::vector<double> zero(2 * grid.coordinate.size(), 0.0);
  Tables tables{zero, zero, zero};
  add_orders(up_to_nyquist(std::move(residual), spacing(grid)), spacing(grid), poll, tables);
  return assemble(tables, grid, poll);
}

double DiskResidual::stable_step() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < kept_.size(); ++n) {
    const double residual = static_flexibility(poisson_, static_cast<int>(n)).radial - kept_[n].radial;
    if (kept_radial_[n] > 0.0) smallest = std::min(smallest, 1.8 * residual / kept_radial_[n]);
  }
  return std::sqrt(smallest);
}

}  // namespace stoss
