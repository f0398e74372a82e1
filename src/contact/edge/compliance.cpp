#include "contact/edge/compliance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "numeric/dense.hpp"
#include "numeric/kernels.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

// Products go in blocks, so that most of the zeros of the triangles are passed over, and to whole vectors, of which the
// excess is void.
constexpr std::size_t block_rows = 32;
constexpr std::size_t vector = 8;

}  // namespace

FactoredCompliance::FactoredCompliance(std::vector<double> matrix, std::size_t size, const Poll& poll)
    : size_(size), matrix_(std::move(matrix)), band_(3 * size) {
  const auto n = static_cast<Eigen::Index>(size);
  Eigen::MatrixXd factor = numeric::dense::square(matrix_.data(), n, poll);
  const bool finite = std::all_of(matrix_.begin(), matrix_.end(), [](double w) { return std::isfinite(w); });
  if (!finite || !numeric::dense::factor(factor, poll)) {
    throw NotConverged("contact: the compliance between the nodes is not positive definite", "nodes",
                       "use fewer nodes");
  }
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = i - std::min<std::size_t>(i, 2); j <= i; ++j) {
      band_[3 * i + (i - j)] = factor(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
  }
  inverse_transposed_ = numeric::dense::zeros(size * size, poll);
  Eigen::Map<Eigen::MatrixXd> inverse(inverse_transposed_.data(), n, n);
  numeric::dense::invert_lower(factor, inverse, poll);
  inverse_ = numeric::dense::zeros(size * size, poll);
  numeric::dense::by_columns(n, poll, [&](Eigen::Index first, Eigen::Index count) {
    Eigen::Map<Matrix>(inverse_.data(), n, n).middleCols(first, count) = inverse.middleCols(first, count);
  });
}

Eigen::Map<const FactoredCompliance::Matrix> FactoredCompliance::matrix() const {
  const auto n = static_cast<Eigen::Index>(size_);
  return {matrix_.data(), n, n};
}

void FactoredCompliance::forward(std::size_t count, const std::vector<double>& q, std::vector<double>& y) const {
  const std::size_t end = std::min((count + vector - 1) / vector * vector, size_);
  for (std::size_t i = 0; i < end; i += block_rows) {
    numeric::kernels::multiply_transposed(inverse_transposed_.data(), size_, std::min(count, i + block_rows), i,
                                          std::min(end, i + block_rows), q.data(), y.data());
  }
}

void FactoredCompliance::backward(std::size_t count, const std::vector<double>& y, std::vector<double>& f) const {
  const std::size_t end = std::min((count + vector - 1) / vector * vector, size_);
  for (std::size_t j = 0; j < end; j += block_rows) {
    numeric::kernels::multiply_transposed(inverse_.data() + j * size_, size_, count - std::min(count, j), j,
                                          std::min(end, j + block_rows), y.data() + j, f.data());
  }
}

void FactoredCompliance::multiply(std::size_t begin, std::size_t count, const std::vector<double>& x,
                                  std::vector<double>& result) const {
  multiply(begin, count, size_, x, result);
}

void FactoredCompliance::multiply(std::size_t begin, std::size_t count, std::size_t end, const std::vector<double>& x,
                                  std::vector<double>& result) const {
  numeric::kernels::multiply_transposed(matrix_.data(), size_, count, begin, end, x.data(), result.data());
}

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

using Nodes = std::vector<Index>;

Index size(const Nodes& nodes) { return static_cast<Index>(nodes.size()); }

MatrixXd block_of(const MatrixXd& matrix, const Nodes& rows, const Nodes& columns) {
  MatrixXd block(size(rows), size(columns));
  for (std::size_t j = 0; j < columns.size(); ++j) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      block(static_cast<Index>(i), static_cast<Index>(j)) = matrix(rows[i], columns[j]);
    }
  }
  return block;
}

VectorXd part_of(const VectorXd& x, const Nodes& places) {
  VectorXd part(size(places));
  for (std::size_t k = 0; k < places.size(); ++k) part(static_cast<Index>(k)) = x(places[k]);
  return part;
}

void put(const VectorXd& part, const Nodes& places, VectorXd& x) {
  for (std::size_t k = 0; k < places.size(); ++k) x(places[k]) = part(static_cast<Index>(k));
}

}  // namespace

void VaryingCompliance::assign(MatrixXd matrix) {
  matrix_ = std::move(matrix);
  rigid_.clear();
  edge_.clear();
}

/// Chooses the nodes that are factored: of the rigid ones those with two more behind them. The edge goes to and fro.
void VaryingCompliance::factor(const Nodes& nodes, const std::vector<bool>& rigid) {
  rigid_.clear();
  for (const Index i : nodes) {
    const auto k = static_cast<std::size_t>(i);
    if (rigid[k] && (k + 2 >= rigid.size() || (rigid[k + 1] && rigid[k + 2]))) rigid_.push_back(i);
  }
  if (!rigid_.empty()) factors_.compute(block_of(matrix_, rigid_, rigid_));
}

/// Adds nodes to those of the edge, which are kept as long as the factors are: they come and go.
void VaryingCompliance::join(const Nodes& edge) {
  Nodes all;
  std::set_union(edge_.begin(), edge_.end(), edge.begin(), edge.end(), std::back_inserter(all));
  edge_ = std::move(all);
  to_edge_ = block_of(matrix_, edge_, rigid_);
  edge_self_ = block_of(matrix_, edge_, edge_);
  from_edge_ = block_of(matrix_, rigid_, edge_);
  if (rigid_.empty() || edge_.empty()) return;
  from_edge_ = factors_.solve(from_edge_).eval();
  edge_self_.noalias() -= to_edge_ * from_edge_;
}

bool VaryingCompliance::solve(const Nodes& nodes, const VectorXd& diagonal, VectorXd& x) {
  std::vector<bool> rigid(static_cast<std::size_t>(matrix_.rows()));
  std::size_t soft = 0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const bool its = diagonal(static_cast<Index>(k)) == 0.0;
    rigid[static_cast<std::size_t>(nodes[k])] = its;
    if (!its) ++soft;
  }
  // As long as those that are factored are rigid, a few more nodes at the edge cost less than new factors.
  const std::size_t few = 8 + nodes.size() / 8;
  const bool same =
      nodes.size() <= rigid_.size() + soft + few &&
      std::all_of(rigid_.begin(), rigid_.end(), [&](Index i) { return rigid[static_cast<std::size_t>(i)]; });
  if (!same) factor(nodes, rigid);
  Nodes edge, rigid_place, edge_place;
  for (std::size_t k = 0, r = 0; k < nodes.size(); ++k) {
    const bool factored = r < rigid_.size() && nodes[k] == rigid_[r];
    if (factored) ++r;
    (factored ? rigid_place : edge_place).push_back(static_cast<Index>(k));
    if (!factored) edge.push_back(nodes[k]);
  }
  if (!same) edge_.clear();
  if (!same || !std::includes(edge_.begin(), edge_.end(), edge.begin(), edge.end())) join(edge);
  // Where each of the edge is among those that were there before.
  Nodes place;
  for (const Index i : edge) place.push_back(std::lower_bound(edge_.begin(), edge_.end(), i) - edge_.begin());

  VectorXd inside = part_of(x, rigid_place), outside = part_of(x, edge_place);
  if (!rigid_.empty()) inside = factors_.solve(inside).eval();
  if (!edge.empty()) {
    if (!rigid_.empty()) outside -= part_of(to_edge_ * inside, place);
    MatrixXd block = block_of(edge_self_, place, place);
    block.diagonal() += part_of(diagonal, edge_place);
    outside = block.partialPivLu().solve(outside).eval();
    if (!rigid_.empty()) {
      VectorXd all = VectorXd::Zero(size(edge_));
      put(outside, place, all);
      inside.noalias() -= from_edge_ * all;
    }
  }
  put(inside, rigid_place, x);
  put(outside, edge_place, x);
  return x.allFinite();
}

}  // namespace stoss
