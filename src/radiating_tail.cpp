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
  const Eigen::Map<const Eigen::VectorXd> impedance(grid.impedance.data(), n);

  const Matrix stiffness = factor(compliance).solve(Matrix::Identity(n, n));
  Matrix mass = stiffness * moment * stiffness * (4.0 / (step * step));
  mass = 0.5 * (mass + mass.transpose()).eval();
  const Eigen::VectorXd link = impedance * (link_stiffness * body.cutoff + 1.0 / step);
  // D = (μ⁻¹ + B⁻¹)⁻¹ = μ − μ (μ + B)⁻¹ μ with μ = 4M/Δt², as M may be singular.
  Matrix sum = mass;
  sum.diagonal() += link;
  const Matrix half = factor(sum).matrixL().solve(mass);
  Matrix drag = mass;
  drag.noalias() -= half.transpose() * half;

  Matrix damped = factor(stiffness + drag).solve(Matrix::Identity(n, n));
  damped = 0.5 * (damped + damped.transpose()).eval();
  const Eigen::VectorXd give = link.cwiseInverse();
  return {values(damped), values(drag * damped), values(drag), {give.data(), give.data() + n}};
}

RadiatingTail::RadiatingTail(const Body& body, const ContactGrid& grid, double step)
    : RadiatingTail(discretize(body, grid, step), body.cutoff, step) {}

RadiatingTail::RadiatingTail(Matrices matrices, double cutoff, double step)
    : step_(step),
      fading_(1.0 / (1.0 + link_stiffness * cutoff * step)),
      contact_(std::move(matrices.compliance), matrices.link.size()),
      memory_(std::move(matrices.memory)),
      drag_(std::move(matrices.drag)),
      link_(std::move(matrices.link)),
      position_(link_.size()),
      displacement_(position_),
      mass_displacement_(position_),
      mass_velocity_(position_),
      mass_acceleration_(position_),
      stretch_(position_),
      force_(position_),
      old_force_(position_),
      free_rest_(position_),
      free_(position_),
      contact_displacement_(position_),
      gap_(position_),
      branch_force_(position_) {}

const std::vector<double>& RadiatingTail::advance(const std::vector<double>& position) {
  const std::size_t size = position.size();
  const double half = 0.5 * step_;
  for (std::size_t i = 0; i < size; ++i) {
    free_rest_[i] =
        mass_displacement_[i] + step_ * mass_velocity_[i] + half * half * mass_acceleration_[i] + fading_ * stretch_[i];
  }
  kernels::multiply_transposed(memory_.data(), size, size, 0, size, free_rest_.data(), free_.data());
  for (std::size_t i = 0; i < size; ++i) gap_[i] = position[i] - free_[i];
  old_force_.swap(force_);
  contact_.solve(gap_, force_, contact_displacement_);
  for (std::size_t i = 0; i < size; ++i) {
    displacement_[i] = free_[i] + contact_displacement_[i];
    free_rest_[i] = displacement_[i] - free_rest_[i];
    work_ += 0.5 * (old_force_[i] + force_[i]) * (position[i] - position_[i]);
  }
  kernels::multiply_transposed(drag_.data(), size, size, 0, size, free_rest_.data(), branch_force_.data());
  for (std::size_t i = 0; i < size; ++i) {
    stretch_[i] = link_[i] * branch_force_[i] + fading_ * stretch_[i];
    const double moved = displacement_[i] - stretch_[i] - mass_displacement_[i];
    const double accelerations = (moved - step_ * mass_velocity_[i]) / (half * half);  // old and new
    mass_displacement_[i] += moved;
    mass_velocity_[i] += half * accelerations;
    mass_acceleration_[i] = accelerations - mass_acceleration_[i];
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
