#include "bodies/disk/order_sums.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "bodies/disk/edge_points.hpp"
#include "bodies/disk/order_tables.hpp"
#include "numeric/dense.hpp"

namespace stoss::bodies::disk {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

namespace dense = numeric::dense;

constexpr double mass = ResidualShape::mass;

/// An entry of the matrix, between two angles.
double entry(const PairSums& table, double cosine_i, double sine_i, double cosine_j, double sine_j) {
  const auto& [apart, sum] = table;
  const double radial = cosine_i * cosine_j * (sum.radial + apart.radial);
  const double mixed = cosine_i * sine_j * (sum.mixed - apart.mixed) + sine_i * cosine_j * (sum.mixed + apart.mixed);
  const double tangential = sine_i * sine_j * (apart.tangential - sum.tangential);
  return 0.5 * (radial - mixed + tangential) / mass;
}

/// The matrix between the angles φ_i = (i + ½)h from the tables at mh.
std::vector<double> assemble(const OrderTables& table, const ContactPoints& points, const Poll& poll) {
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
        matrix[i * count + j] = matrix[j * count + i] = entry(table.at(i, j), cosine[i], sine[i], cosine[j], sine[j]);
      }
    }
  }
  return matrix;
}

std::vector<double> sum_at_equal_angles(const OrderSum& sum, const ContactPoints& points, const Poll& poll) {
  return assemble(OrderTables(sum, points, poll), points, poll);
}

/// Subtotal over the given orders, of which those at the points are rows of two matrices.
std::vector<double> order_matrix(const std::vector<Flexibility>& coefficients, const ContactPoints& points,
                                 const Poll& poll) {
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
  std::vector<double> sum = dense::zeros(points.count * points.count, poll);
  dense::by_columns(count, poll, [&](Eigen::Index first, Eigen::Index width) {
    auto columns = Eigen::Map<Matrix>(sum.data(), count, count).middleCols(first, width);
    columns.noalias() = c.transpose() * to_c.middleCols(first, width);
    columns.noalias() += s.transpose() * to_s.middleCols(first, width);
    columns /= mass;
  });
  return sum;
}

std::vector<double> sum_at_mapped_angles(const OrderSum& sum, const ContactPoints& points, const Poll& poll) {
  const std::size_t count = points.count;
  std::vector<double> matrix = order_matrix(sum.coefficients, points, poll);
  if (!sum.with_static) return matrix;
  const MappedOrders all(sum.poisson, points);
  for (std::size_t i = 0; i < count; ++i) {
    if (poll) poll();
    for (std::size_t j = 0; j <= i; ++j) {
      // Rounding must not make it unsymmetric.
      const double more = entry(all.at(i, j), std::cos(all.angle(i)), std::sin(all.angle(i)), std::cos(all.angle(j)),
                                std::sin(all.angle(j)));
      const double value = matrix[i * count + j] + more;
      matrix[i * count + j] = matrix[j * count + i] = value;
    }
  }
  return matrix;
}

}  // namespace

ResidualShape::Loads::Loads(const ContactPoints& points) {
  for (std::size_t i = 0; i < points.count; ++i) {
    angle_.push_back(edge_angle(points, i));
    cosine_.push_back(std::cos(angle_[i]));
    sine_.push_back(std::sin(angle_[i]));
  }
}

std::vector<double> sum_over_orders(const OrderSum& sum, const ContactPoints& points, const Poll& poll) {
  if (points.count == 0) return {};
  return points.radius == 1.0 ? sum_at_equal_angles(sum, points, poll) : sum_at_mapped_angles(sum, points, poll);
}

}  // namespace stoss::bodies::disk
