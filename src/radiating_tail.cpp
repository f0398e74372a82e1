#include "radiating_tail.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "kernels.hpp"
#include "residual.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Cholesky = Eigen::LLT<Matrix>;

/// γ: with it the tail of a family of modes has the spring constant (2/π) ω_c Z at high frequency (docs/numerics.md).
constexpr double link_stiffness = 8.0 / std::numbers::pi - 0.5 * std::numbers::pi;

Matrix matrix(const std::vector<double>& values, Eigen::Index n) {
  return Eigen::Map<const Matrix>(values.data(), n, n);
}

std::vector<double> values(const Matrix& matrix) { return {matrix.data(), matrix.data() + matrix.size()}; }

/// Kicks of period Δt move a mode under a constant force by (Δt/2ω) cot(ωΔt/2) instead of 1/ω². The difference of all
/// kept modes, which adds to the compliance of the others, so that the response to slow forces is exact.
void add_kick_compliance(const Body& body, const ContactGrid& grid, double step, Matrix& compliance) {
  const auto n = compliance.rows();
  const Eigen::Map<const Matrix> shape(grid.shape.data(), static_cast<Eigen::Index>(grid.shape.size()) / n, n);
  Matrix response = Matrix::Zero(shape.rows(), n);  // of each shape to forces on the nodes
  for (const ModeGroup& group : body.groups) {
    double plus = 0.0, mixed = 0.0, minus = 0.0;  // C c + S s = ½(C + S)(c + s) + ½(C − S)(c − s)
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      const double angle = 0.5 * group.omega[l] * step;
      const double missing = (1.0 - angle / std::tan(angle)) / (group.omega[l] * group.omega[l] * body.mass);
      const double sum = 0.5 * (group.radial[l] + group.tangential[l]);
      const double difference = 0.5 * (group.radial[l] - group.tangential[l]);
      plus += missing * sum * sum;
      mixed += missing * sum * difference;
      minus += missing * difference * difference;
    }
    const auto p = static_cast<Eigen::Index>(group.sum_shape), m = static_cast<Eigen::Index>(group.difference_shape);
    response.row(p) += plus * shape.row(p) + mixed * shape.row(m);
    response.row(m) += mixed * shape.row(p) + minus * shape.row(m);
  }
  compliance.noalias() += shape.transpose() * response;
}

/// Y with V = Y Yᵀ, by Cholesky factorization with pivots, up to the rank at which what is left of V is rounding. Eigen
/// has none that updates the diagonal before it chooses.
Matrix root(Matrix moment) {
  constexpr double rounding = 1e-12;
  constexpr Eigen::Index lanes = 8;  // a step's products prefer whole vectors; the columns beyond the rank are 0
  const auto n = moment.rows();
  const double least = rounding * moment.diagonal().maxCoeff();
  Matrix result = Matrix::Zero(n, (n + lanes - 1) / lanes * lanes);
  Eigen::Index rank = 0, pivot = 0;
  for (; rank < n && moment.diagonal().maxCoeff(&pivot) > least; ++rank) {
    const Eigen::VectorXd column = moment.col(pivot) / std::sqrt(moment(pivot, pivot));
    moment.noalias() -= column * column.transpose();
    result.col(rank) = column;
  }
  return result.leftCols((rank + lanes - 1) / lanes * lanes);
}

Cholesky factor(const Matrix& positive) {
  Cholesky result(positive);
  if (result.info() != Eigen::Success) {
    throw NotConverged("contact: the compliance between the nodes is not positive definite (use fewer nodes)");
  }
  return result;
}

}  // namespace

RadiatingTail::Matrices RadiatingTail::discretize(const Body& body, const ContactGrid& grid, double step) {
  const auto n = static_cast<Eigen::Index>(grid.recess.size());
  Matrix compliance = matrix(residual_matrix(body, body.residual_compliance, grid), n);
  add_kick_compliance(body, grid, step, compliance);
  const Matrix moment = matrix(residual_matrix(body, body.residual_second_moment, grid), n);
  const Eigen::VectorXd impedance = Eigen::Map<const Eigen::VectorXd>(grid.impedance.data(), n);
  const Eigen::VectorXd link = impedance * (link_stiffness * body.cutoff + 1.0 / step);

  const Matrix stiffness = factor(compliance).solve(Matrix::Identity(n, n));
  const Matrix participation = stiffness * root(moment);
  Matrix inertia = participation.transpose() * link.cwiseInverse().asDiagonal() * participation;
  inertia.diagonal().array() += 0.25 * step * step;
  const Cholesky factored = factor(inertia);
  const Matrix drag = factored.solve(participation.transpose());

  Matrix damped = stiffness;
  damped.noalias() += participation * drag;
  damped = factor(0.5 * (damped + damped.transpose())).solve(Matrix::Identity(n, n));
  damped = 0.5 * (damped + damped.transpose()).eval();
  const auto masses = participation.cols();
  return {values(damped), values(participation), values(factored.solve(Matrix::Identity(masses, masses))),
          values(drag * damped), static_cast<std::size_t>(masses)};
}

RadiatingTail::RadiatingTail(const Body& body, const ContactGrid& grid, double step)
    : RadiatingTail(discretize(body, grid, step), grid.recess.size(), body.cutoff, step) {}

RadiatingTail::RadiatingTail(Matrices matrices, std::size_t nodes, double cutoff, double step)
    : step_(step),
      fading_(1.0 / (1.0 + link_stiffness * cutoff * step)),
      contact_(std::move(matrices.compliance), nodes),
      participation_(std::move(matrices.participation)),
      mobility_(std::move(matrices.mobility)),
      memory_(std::move(matrices.memory)),
      position_(nodes),
      displacement_(nodes),
      force_(nodes),
      old_force_(nodes),
      free_(nodes),
      contact_displacement_(nodes),
      gap_(nodes),
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
