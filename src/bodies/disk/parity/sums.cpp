// The products of cosines and sines of nφ_i and nφ_j are those of n(φ_i − φ_j) and n(φ_i + φ_j): the sums are those of
// OrderTables, with other factors of cos φ and sin φ.
#include "bodies/disk/parity/bodies_along.hpp"

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

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// cos φ and sin φ of each point.
struct Directions {
  std::vector<double> cosine, sine;

  explicit Directions(const ContactPoints& points) {
    for (std::size_t i = 0; i < points.count; ++i) {
      cosine.push_back(std::cos(edge_angle(points, i)));
      sine.push_back(std::sin(edge_angle(points, i)));
    }
  }
};

/// Σ R^CC c c′, Σ R^SS s s′, Σ R^CS c s′ and Σ R^CS s c′ of two points, where c and s are the factors cos nφ and sin nφ
/// that go with C and S.
struct Products {
  double cc, ss, cs, sc;
};

Products products(const PairSums& table, Parity parity) {
  const auto& [apart, sum] = table;
  const double equal = 0.5 * (sum.mixed + apart.mixed), swapped = 0.5 * (sum.mixed - apart.mixed);
  if (parity == Parity::normal_even) {
    return {0.5 * (apart.radial + sum.radial), 0.5 * (apart.tangential - sum.tangential), swapped, equal};
  }
  return {0.5 * (apart.radial - sum.radial), 0.5 * (apart.tangential + sum.tangential), equal, swapped};
}

/// Adds the sums of a pair of points, j ≤ i, to all entries of the matrix between them.
class Filler {
 public:
  Filler(Parity parity, const ContactPoints& points, std::vector<double>& matrix)
      : parity_(parity), at_(points), points_(points.count), matrix_(matrix) {}

  void add(const PairSums& table, std::size_t i, std::size_t j) {
    const auto [cc, ss, cs, sc] = products(table, parity_);
    const double ci = at_.cosine[i], si = at_.sine[i], cj = at_.cosine[j], sj = at_.sine[j];
    if (parity_ == Parity::normal_even) {
      put(i, j, cc * ci * cj - cs * ci * sj - sc * si * cj + ss * si * sj);
      put(points_ + i, points_ + j, cc * si * sj + cs * si * cj + sc * ci * sj + ss * ci * cj);
      put(i, points_ + j, cc * ci * sj + cs * ci * cj - sc * si * sj - ss * si * cj);
      if (i != j) put(j, points_ + i, cc * cj * si + sc * cj * ci - cs * sj * si - ss * sj * ci);
    } else {
      put(i, j, cc * si * sj - cs * si * cj - sc * ci * sj + ss * ci * cj);
      put(points_ + i, points_ + j, cc * ci * cj + cs * ci * sj + sc * si * cj + ss * si * sj);
      put(i, points_ + j, cc * si * cj + cs * si * sj - sc * ci * cj - ss * ci * sj);
      if (i != j) put(j, points_ + i, cc * sj * ci + sc * sj * si - cs * cj * ci - ss * cj * si);
    }
  }

 private:
  void put(std::size_t row, std::size_t column, double sum) {
    const std::size_t size = 2 * points_;
    const double value = matrix_[row * size + column] + sum / std::numbers::pi;
    matrix_[row * size + column] = matrix_[column * size + row] = value;
  }

  Parity parity_;
  Directions at_;
  std::size_t points_;
  std::vector<double>& matrix_;
};

/// The sum over given orders at points on a smaller circle, by products of the rows c and s.
void add_orders_one_by_one(const OrderSum& sum, Parity parity, const ContactPoints& points, const Poll& poll,
                           Eigen::Map<Rows> matrix) {
  const auto count = static_cast<Eigen::Index>(points.count);
  const auto resolved = std::lround(std::numbers::pi / (points.spacing * points.radius));
  const auto orders =
      static_cast<Eigen::Index>(std::min<long>(static_cast<long>(sum.coefficients.size()), resolved + 1));
  Eigen::ArrayXd angle(count);
  for (Eigen::Index i = 0; i < count; ++i) angle(i) = edge_angle(points, static_cast<std::size_t>(i));
  const Eigen::ArrayXd cosine = angle.cos(), sine = angle.sin();
  Rows c(orders, 2 * count), s(orders, 2 * count), to_c(orders, 2 * count), to_s(orders, 2 * count);
  for (Eigen::Index n = 0; n < orders; ++n) {
    if (poll) poll();
    const Flexibility& r = sum.coefficients[static_cast<std::size_t>(n)];
    const double weight = n == resolved ? 0.5 : 1.0;
    const Eigen::ArrayXd cosine_n = (static_cast<double>(n) * angle).cos(),
                         sine_n = (static_cast<double>(n) * angle).sin();
    if (parity == Parity::normal_even) {
      c.row(n) << (cosine_n * cosine).matrix().transpose(), (cosine_n * sine).matrix().transpose();
      s.row(n) << (-sine_n * sine).matrix().transpose(), (sine_n * cosine).matrix().transpose();
    } else {
      c.row(n) << (sine_n * sine).matrix().transpose(), (sine_n * cosine).matrix().transpose();
      s.row(n) << (-cosine_n * cosine).matrix().transpose(), (cosine_n * sine).matrix().transpose();
    }
    to_c.row(n) = weight * (r.radial * c.row(n) + r.mixed * s.row(n));
    to_s.row(n) = weight * (r.mixed * c.row(n) + r.tangential * s.row(n));
  }
  numeric::dense::by_columns(2 * count, poll, [&](Eigen::Index first, Eigen::Index width) {
    auto columns = matrix.middleCols(first, width);
    columns.noalias() += c.transpose() * to_c.middleCols(first, width) / std::numbers::pi;
    columns.noalias() += s.transpose() * to_s.middleCols(first, width) / std::numbers::pi;
  });
}

/// Calls add(i, j) for every j ≤ i.
template <typename Add>
void for_pairs(std::size_t count, const Poll& poll, const Add& add) {
  for (std::size_t i = 0; i < count; ++i) {
    if (poll) poll();
    for (std::size_t j = 0; j <= i; ++j) add(i, j);
  }
}

}  // namespace

std::vector<double> sum_over_orders(const OrderSum& sum, Parity parity, const ContactPoints& points, const Poll& poll) {
  const std::size_t size = 2 * points.count;
  std::vector<double> matrix = numeric::dense::zeros(size * size, poll);
  if (points.count == 0) return matrix;
  Filler filler(parity, points, matrix);
  if (points.radius == 1.0) {
    const OrderTables tables(sum, points, poll);
    for_pairs(points.count, poll, [&](std::size_t i, std::size_t j) { filler.add(tables.at(i, j), i, j); });
    return matrix;
  }
  const auto edge = static_cast<Eigen::Index>(size);
  add_orders_one_by_one(sum, parity, points, poll, {matrix.data(), edge, edge});
  if (!sum.with_static) return matrix;
  const MappedOrders all(sum.poisson, points);
  for_pairs(points.count, poll, [&](std::size_t i, std::size_t j) { filler.add(all.at(i, j), i, j); });
  return matrix;
}

}  // namespace stoss::bodies::disk
