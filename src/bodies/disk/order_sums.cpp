#include "bodies/disk/order_sums.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "bodies/disk/edge_points.hpp"
#include "bodies/disk/harmonic_sums.hpp"
#include "numeric/dense.hpp"

namespace stoss::bodies::disk {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

namespace dense = numeric::dense;

constexpr double mass = std::numbers::pi;

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

std::vector<double> sum_at_equal_angles(const OrderSum& sum, const ContactPoints& points, const Poll& poll) {
  const std::vector<double> zero(2 * points.count, 0.0);
  Tables tables =
      sum.with_static ? static_tables(sum.poisson, points.spacing, 2 * points.count) : Tables{zero, zero, zero};
  add_orders(sum.coefficients, points.spacing, poll, tables);
  return assemble(tables, points, poll);
}

// At the angles φ(α) with α_i = (i + ½)h equally spaced, the infinite sums are those at φ, and what points of that
// spacing do not resolve is the same as at equally spaced angles: near the singularity, ln|φ − φ′| = ln|α − α′| +
// ln dφ/dα with a smooth remainder.
/// The static flexibilities of all orders, summed between the points.
class StaticMatrix {
 public:
  StaticMatrix(double poisson, const ContactPoints& points)
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

  [[nodiscard]] double at(std::size_t i, std::size_t j) const {
    const StaticSums apart = sums(i - j, i == j ? 0.0 : angle_[i] - angle_[j], stretch_[i]);
    const StaticSums sum = sums(i + j + 1, angle_[i] + angle_[j], 1.0);
    const double cosine_i = std::cos(angle_[i]), cosine_j = std::cos(angle_[j]);
    const double sine_i = std::sin(angle_[i]), sine_j = std::sin(angle_[j]);
    const double radial = cosine_i * cosine_j * (sum.radial + apart.radial);
    const double mixed = cosine_i * sine_j * (sum.mixed - apart.mixed) + sine_i * cosine_j * (sum.mixed + apart.mixed);
    const double tangential = sine_i * sine_j * (apart.tangential - sum.tangential);
    return 0.5 * (radial - mixed + tangential) / mass;
  }

 private:
  /// @param m distance of the two points in spacings
  [[nodiscard]] StaticSums sums(std::size_t m, double theta, double stretch) const {
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

  StaticOrders orders_;
  std::size_t resolved_;  // on the circle of the points
  double highest_;        // on the edge, at the foremost point
  std::vector<double> angle_, stretch_;
  std::vector<HarmonicSums> lack_;
};

/// Subtotal over the given orders, of which those at the points are rows of two matrices.
Matrix order_matrix(const std::vector<Flexibility>& coefficients, const ContactPoints& points, const Poll& poll) {
  const auto count = static_cast<Eigen::Index>(points.count);
  const auto resolved = std::lround(std::numbers::pi / (points.spacing * points.radius));
  const auto orders = static_cast<Eigen::Index>(std::min<long>(static_cast<long>(coefficients.size()), resolved + 1));
  Eigen::ArrayXd angle(count);
  for (Eigen::Index i = 0; i < count; ++i) angle(i) = edge_angle(points, static_cast<std::size_t>(i));
  const Eigen::ArrayXd cosine = angle.cos(), sine = angle.sin();
  Eigen::ArrayXd cosine_n = Eigen::ArrayXd::Ones(count), sine_n = Eigen::ArrayXd::Zero(count);
  Matrix c(orders, count), s(orders, count), to_c(orders, count), to_s(orders, count);
  for (Eigen::Index n = 0; n < orders; ++n) {
    if (poll) poll();
    const Flexibility& r = coefficients[static_cast<std::size_t>(n)];
    const double weight = n == resolved ? 0.5 : 1.0;
    c.row(n) = (cosine_n * cosine).matrix().transpose();
    s.row(n) = (-sine_n * sine).matrix().transpose();
    to_c.row(n) = weight * (r.radial * c.row(n) + r.mixed * s.row(n));
    to_s.row(n) = weight * (r.mixed * c.row(n) + r.tangential * s.row(n));
    const Eigen::ArrayXd next = cosine_n * cosine - sine_n * sine;
    sine_n = sine_n * cosine + cosine_n * sine;
    cosine_n = next;
  }
  // In blocks of columns, between which there is time to look up.
  constexpr Eigen::Index block = 64;
  Matrix sum(count, count);
  for (Eigen::Index first = 0; first < count; first += block) {
    if (poll) poll();
    const Eigen::Index width = std::min(block, count - first);
    sum.middleCols(first, width).noalias() = c.transpose() * to_c.middleCols(first, width);
    sum.middleCols(first, width).noalias() += s.transpose() * to_s.middleCols(first, width);
  }
  return sum / mass;
}

std::vector<double> sum_at_mapped_angles(const OrderSum& sum, const ContactPoints& points, const Poll& poll) {
  const std::size_t count = points.count;
  const Matrix orders = order_matrix(sum.coefficients, points, poll);
  std::vector<double> matrix(orders.data(), orders.data() + orders.size());
  if (!sum.with_static) return matrix;
  const StaticMatrix all(sum.poisson, points);
  for (std::size_t i = 0; i < count; ++i) {
    if (poll) poll();
    for (std::size_t j = 0; j <= i; ++j) {
      // Rounding must not make it unsymmetric.
      const double value = matrix[i * count + j] + all.at(i, j);
      matrix[i * count + j] = matrix[j * count + i] = value;
    }
  }
  return matrix;
}

}  // namespace

std::vector<double> sum_over_orders(const OrderSum& sum, const ContactPoints& points, const Poll& poll) {
  if (points.count == 0) return {};
  return points.radius == 1.0 ? sum_at_equal_angles(sum, points, poll) : sum_at_mapped_angles(sum, points, poll);
}

}  // namespace stoss::bodies::disk
