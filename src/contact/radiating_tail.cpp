#include "contact/radiating_tail.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "numeric/dense.hpp"
#include "numeric/kernels.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

namespace dense = numeric::dense;
namespace kernels = numeric::kernels;

using Eigen::Index;
using Eigen::MatrixXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// γ: with it the tail of a family of modes has the spring constant (2/π) ω_c Z at high frequency (docs/numerics.md).
constexpr double link_stiffness = 8.0 / std::numbers::pi - 0.5 * std::numbers::pi;

std::vector<double> values(const RowMajor& matrix) { return {matrix.data(), matrix.data() + matrix.size()}; }

std::vector<double> values_of_symmetric(const MatrixXd& matrix, const Poll& poll) {
  std::vector<double> result = dense::zeros(static_cast<std::size_t>(matrix.size()), poll);
  std::copy_n(matrix.data(), matrix.size(), result.begin());
  return result;
}

/// Kicks of period Δt move a mode under a constant force by (Δt/2ω) cot(ωΔt/2) instead of 1/ω². The difference of all
/// kept modes, which adds to the compliance of the others, so that the response to slow forces is exact.
void add_kick_compliance(const Contact& contact, const ContactGrid& grid, double step, const Poll& poll,
                         MatrixXd& compliance) {
  const auto n = compliance.rows();
  const Eigen::Map<const RowMajor> shape(grid.shape.data(), static_cast<Index>(grid.shape.size()) / n, n);
  RowMajor response = RowMajor::Zero(shape.rows(), n);  // of each shape to forces on the nodes
  for (const ModeGroup& group : contact.groups) {
    double upper = 0.0, mixed = 0.0, lower = 0.0;
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      const double angle = 0.5 * group.omega[l] * step;
      const double missing = (1.0 - angle / std::tan(angle)) / (group.omega[l] * group.omega[l] * contact.mass);
      upper += missing * group.upper[l] * group.upper[l];
      mixed += missing * group.upper[l] * group.lower[l];
      lower += missing * group.lower[l] * group.lower[l];
    }
    const auto u = static_cast<Index>(group.upper_row), l = static_cast<Index>(group.lower_row);
    response.row(u) += upper * shape.row(u) + mixed * shape.row(l);
    response.row(l) += mixed * shape.row(u) + lower * shape.row(l);
  }
  dense::by_columns(n, poll, [&](Index first, Index count) {
    compliance.middleCols(first, count).noalias() += shape.transpose() * response.middleCols(first, count);
  });
}

/// Y with V = Y Yᵀ, by Cholesky factorization with pivots, up to the rank at which what is left of V is rounding: Eigen
/// has none that updates the diagonal before it chooses.
MatrixXd root(const MatrixXd& moment, const Poll& poll) {
  constexpr double rounding = 1e-12;
  constexpr Index lanes = 8;  // a step's products prefer whole vectors; the columns beyond the rank are 0
  const auto n = moment.rows();
  Eigen::VectorXd left = moment.diagonal();
  const double least = rounding * left.maxCoeff();
  MatrixXd result(n, 0);
  Index rank = 0, pivot = 0;
  for (; rank < n && left.maxCoeff(&pivot) > least; ++rank) {
    if (poll) poll();
    if (rank == result.cols()) result.conservativeResize(Eigen::NoChange, std::max(lanes, 2 * rank));
    Eigen::VectorXd column = moment.col(pivot);
    column.noalias() -= result.leftCols(rank) * result.row(pivot).head(rank).transpose();
    column /= std::sqrt(left(pivot));
    left.array() -= column.array().square();
    result.col(rank) = column;
  }
  const Index whole = (rank + lanes - 1) / lanes * lanes;
  result.conservativeResize(Eigen::NoChange, whole);
  result.rightCols(whole - rank).setZero();
  return result;
}

MatrixXd factored(MatrixXd positive, const Poll& poll) {
  if (!dense::factor(positive, poll)) {
    throw NotConverged("contact: the compliance between the nodes is not positive definite (use fewer nodes)");
  }
  return positive;
}

/// AᵀB
MatrixXd product(const MatrixXd& a, const MatrixXd& b, const Poll& poll) {
  MatrixXd result(a.cols(), b.cols());
  dense::by_columns(b.cols(), poll, [&](Index first, Index count) {
    result.middleCols(first, count).noalias() = a.transpose() * b.middleCols(first, count);
  });
  return result;
}

}  // namespace

RadiatingTail::Matrices RadiatingTail::discretize(const Contact& contact, const ContactGrid& grid, double step,
                                                  const Poll& poll) {
  const auto n = static_cast<Index>(grid.recess.size());
  MatrixXd compliance = dense::square(residual_compliance(contact, grid, poll).data(), n, poll);
  add_kick_compliance(contact, grid, step, poll, compliance);
  const MatrixXd moment = root(dense::square(residual_second_moment(contact, grid, poll).data(), n, poll), poll);
  const auto masses = moment.cols();
  const Eigen::VectorXd impedance = Eigen::Map<const Eigen::VectorXd>(grid.impedance.data(), n);
  const Eigen::VectorXd link = impedance * (link_stiffness * contact.cutoff + 1.0 / step);

  MatrixXd participation = moment;
  dense::solve(factored(dense::square(compliance.data(), n, poll), poll), participation, poll);
  MatrixXd inertia = product(participation, link.cwiseInverse().asDiagonal() * participation, poll);
  inertia.diagonal().array() += 0.25 * step * step;
  MatrixXd mobility = MatrixXd::Identity(masses, masses);
  dense::solve(factored(inertia, poll), mobility, poll);

  // Y T Yᵀ = QᵀQ
  const MatrixXd lower = factored(inertia + product(moment, participation, poll), poll);
  MatrixXd memory = moment.transpose();
  dense::by_columns(n, poll, [&](Index first, Index count) {
    auto columns = memory.middleCols(first, count);
    lower.triangularView<Eigen::Lower>().solveInPlace(columns);
  });
  compliance -= product(memory, memory, poll);
  dense::by_columns(n, poll, [&](Index first, Index count) {
    auto columns = memory.middleCols(first, count);
    lower.triangularView<Eigen::Lower>().transpose().solveInPlace(columns);
  });
  return {values_of_symmetric(compliance, poll), values(participation), values(mobility), values(memory),
          static_cast<std::size_t>(masses)};
}

RadiatingTail::RadiatingTail(const Contact& contact, const ContactGrid& grid, double speed, double step,
                             const Poll& poll)
    : RadiatingTail(discretize(contact, grid, step, poll), edge_law(contact, grid, speed), grid, contact.cutoff, step,
                    poll) {}

RadiatingTail::RadiatingTail(Matrices matrices, EdgeLaw law, const ContactGrid& grid, double cutoff, double step,
                             const Poll& poll)
    : step_(step),
      fading_(1.0 / (1.0 + link_stiffness * cutoff * step)),
      contact_(std::move(matrices.compliance), std::move(law), grid.recess.size(), poll),
      range_(contact_.range(grid.recess)),
      participation_(std::move(matrices.participation)),
      mobility_(std::move(matrices.mobility)),
      memory_(std::move(matrices.memory)),
      position_(grid.recess.size()),
      displacement_(grid.recess.size()),
      force_(grid.recess.size()),
      old_force_(grid.recess.size()),
      free_(grid.recess.size()),
      contact_displacement_(grid.recess.size()),
      gap_(grid.recess.size()),
      mass_displacement_(matrices.masses),
      mass_velocity_(matrices.masses),
      mass_acceleration_(matrices.masses),
      stretch_(matrices.masses),
      rest_(matrices.masses),
      moved_(matrices.masses) {}

const std::vector<double>& RadiatingTail::advance(const std::vector<double>& position) {
  const std::size_t nodes = position.size(), masses = rest_.size();
  const double half = 0.5 * step_;
  for (std::size_t k = 0; k < masses; ++k) {
    // From here η, η̇ are what they would become without the new acceleration.
    mass_displacement_[k] += step_ * mass_velocity_[k] + half * half * mass_acceleration_[k];
    mass_velocity_[k] += half * mass_acceleration_[k];
    rest_[k] = mass_displacement_[k] + fading_ * stretch_[k];
  }
  kernels::multiply_transposed(memory_.data(), nodes, masses, 0, nodes, rest_.data(), free_.data());
  for (std::size_t i = 0; i < nodes; ++i) gap_[i] = position[i] - free_[i];
  old_force_.swap(force_);
  contact_.solve(gap_, force_, contact_displacement_);
  for (std::size_t i = 0; i < nodes; ++i) {
    displacement_[i] = free_[i] + contact_displacement_[i];
    work_ += 0.5 * (old_force_[i] + force_[i]) * (position[i] - position_[i]);
  }
  kernels::multiply_transposed(participation_.data(), masses, nodes, 0, masses, displacement_.data(), moved_.data());
  for (std::size_t k = 0; k < masses; ++k) rest_[k] = moved_[k] - rest_[k];
  kernels::multiply_transposed(mobility_.data(), masses, masses, 0, masses, rest_.data(), mass_acceleration_.data());
  for (std::size_t k = 0; k < masses; ++k) {
    mass_displacement_[k] += half * half * mass_acceleration_[k];
    mass_velocity_[k] += half * mass_acceleration_[k];
    stretch_[k] = moved_[k] - mass_displacement_[k];
  }
  position_ = position;
  return force_;
}

double RadiatingTail::protrusion() const {
  // A released node swings back through its rest position, but never as far as it was displaced.
  double largest = 0.0;
  for (const double displacement : displacement_) largest = std::max(largest, std::abs(displacement));
  return largest;
}

}  // namespace stoss
