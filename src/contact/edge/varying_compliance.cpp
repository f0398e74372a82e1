#include "contact/edge/varying_compliance.hpp"

#include <cstddef>
#include <utility>

namespace stoss {

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

bool VaryingCompliance::solve(const Nodes& nodes, const VectorXd& diagonal, VectorXd& x) {
  Nodes rigid, edge, rigid_place, edge_place;
  for (Index k = 0; k < x.size(); ++k) {
    const bool stiff = diagonal(k) == 0.0;
    (stiff ? rigid : edge).push_back(nodes[static_cast<std::size_t>(k)]);
    (stiff ? rigid_place : edge_place).push_back(k);
  }
  const bool same = rigid == rigid_;
  if (!same && !rigid.empty()) factors_.compute(block_of(matrix_, rigid, rigid));
  if (!same || edge != edge_) {
    to_edge_ = block_of(matrix_, edge, rigid);
    edge_self_ = block_of(matrix_, edge, edge);
    from_edge_ = block_of(matrix_, rigid, edge);
    if (!rigid.empty() && !edge.empty()) {
      from_edge_ = factors_.solve(from_edge_).eval();
      edge_self_.noalias() -= to_edge_ * from_edge_;
    }
    rigid_ = std::move(rigid);
    edge_ = std::move(edge);
  }
  VectorXd inside = part_of(x, rigid_place), outside = part_of(x, edge_place);
  if (!rigid_.empty()) inside = factors_.solve(inside).eval();
  if (!edge_.empty()) {
    if (!rigid_.empty()) outside.noalias() -= to_edge_ * inside;
    MatrixXd block = edge_self_;
    block.diagonal() += part_of(diagonal, edge_place);
    outside = block.partialPivLu().solve(outside).eval();
    if (!rigid_.empty()) inside.noalias() -= from_edge_ * outside;
  }
  put(inside, rigid_place, x);
  put(outside, edge_place, x);
  return x.allFinite();
}

}  // namespace stoss
