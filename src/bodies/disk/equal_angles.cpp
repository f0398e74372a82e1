#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "bodies/disk/harmonic_sums.hpp"
#include "bodies/disk/order_sums.hpp"
#include "numeric/dense.hpp"

namespace stoss::bodies::disk {
namespace {

namespace dense = numeric::dense;

/// Σ_n R_n cos nθ for R^CC and R^SS and Σ_n R^CS_n sin nθ at the angles θ = mh.
struct Tables {
  std::vector<double> radial, mixed, tangential;
};

std::size_t nyquist_order(double h) { return static_cast<std::size_t>(std::lround(std::numbers::pi / h)); }

/// The tables of the closed-form flexibilities of all orders up to Nyquist (docs/theory/walls.md).
Tables static_tables(double poisson, double h, std::size_t size) {
  const StaticOrders orders(poisson);
  const std::size_t highest = nyquist_order(h);
  Tables tables;
  for (std::size_t m = 0; m < size; ++m) {
    const double last = m % 2 == 0 ? 0.5 : -0.5;
    const auto [cosine, sine] = harmonic_sums(m, highest);
    const StaticSums sums = orders.at(static_cast<double>(m) * h, cosine, sine, last, static_cast<double>(highest));
    tables.radial.push_back(sums.radial);
    tables.mixed.push_back(sums.mixed);
    tables.tangential.push_back(sums.tangential);
  }
  return tables;
}

/// Adds the sums over the orders that a grid of spacing h resolves, the last of them with weight ½.
void add_orders(const std::vector<Flexibility>& coefficients, double h, const Poll& poll, Tables& tables) {
  const std::size_t size = tables.radial.size(), highest = nyquist_order(h);
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
      tables.radial[m] += r.radial * cosine_n[m];
      tables.mixed[m] += r.mixed * sine_n[m];
      tables.tangential[m] += r.tangential * cosine_n[m];
      const double next = cosine_n[m] * cosine[m] - sine_n[m] * sine[m];
      sine_n[m] = sine_n[m] * cosine[m] + cosine_n[m] * sine[m];
      cosine_n[m] = next;
    }
  }
}

/// The matrix between the angles φ_i = (i + ½)h from the tables at mh.
std::vector<double> assemble(const Tables& table, const ContactPoints& points, const Poll& poll) {
  const std::size_t count = points.count;
  std::vector<double> cosine(count), sine(count), matrix = dense::zeros(count * count, poll);
  for (std::size_t i = 0; i < count; ++i) {
    cosine[i] = std::cos(points.angle(i));
    sine[i] = std::sin(points.angle(i));
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

std::vector<double> sum_at_equal_angles(const OrderSum& sum, const ContactPoints& points, const Poll& poll) {
  const std::vector<double> zero(2 * points.count, 0.0);
  Tables tables =
      sum.with_static ? static_tables(sum.poisson, points.spacing, 2 * points.count) : Tables{zero, zero, zero};
  add_orders(sum.coefficients, points.spacing, poll, tables);
  return assemble(tables, points, poll);
}

}  // namespace stoss::bodies::disk
