#include "hard_wall.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "stoss/errors.hpp"

namespace stoss {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Z′/Δt of the radiating tail.
std::vector<double> damping(const ContactGrid& grid, double relaxation, double step) {
  std::vector<double> result;
  for (const double impedance : grid.impedance) result.push_back(impedance * relaxation / ((relaxation + step) * step));
  return result;
}

std::vector<double> checked_compliance(const Body& body, const ContactGrid& grid) {
  std::vector<double> compliance = body.residual_compliance(grid);
  if (compliance.size() != grid.recess.size() * grid.recess.size()) {
    throw InvalidInput("body: got a compliance of '" + body.name + "' of another size, allowed nodes x nodes values");
  }
  return compliance;
}

/// (W⁻¹ + D)⁻¹ = W − W (W + D⁻¹)⁻¹ W, which needs no inverse of W.
std::vector<double> damped_compliance(const Body& body, const ContactGrid& grid, const std::vector<double>& damping) {
  std::vector<double> compliance = checked_compliance(body, grid);
  const auto n = static_cast<Eigen::Index>(damping.size());
  Eigen::Map<Matrix> w(compliance.data(), n, n);
  Eigen::MatrixXd sum = w;
  for (Eigen::Index i = 0; i < n; ++i) sum(i, i) += 1.0 / damping[static_cast<std::size_t>(i)];
  const Eigen::LLT<Eigen::MatrixXd> cholesky(sum);
  const Eigen::MatrixXd half = cholesky.matrixL().solve(Eigen::MatrixXd(w));
  Eigen::MatrixXd result = w;
  result.selfadjointView<Eigen::Lower>().rankUpdate(half.transpose(), -1.0);
  w = result.selfadjointView<Eigen::Lower>();
  return compliance;
}

}  // namespace

QuasistaticTail::QuasistaticTail(const Body& body, const ContactGrid& grid)
    : contact_(checked_compliance(body, grid), grid.recess.size()),
      force_(grid.recess.size()),
      displacement_(grid.recess.size()) {}

const std::vector<double>& QuasistaticTail::advance(const std::vector<double>& position) {
  contact_.solve(position, force_, displacement_);
  return force_;
}

double QuasistaticTail::stored_energy() const {
  double energy = 0.0;
  for (std::size_t i = 0; i < extent(); ++i) energy += 0.5 * force_[i] * displacement_[i];
  return energy;
}

RadiatingTail::RadiatingTail(const Body& body, const ContactGrid& grid, double step)
    : step_(step),
      relaxation_(std::numbers::pi / (6.0 * body.cutoff)),
      damping_(damping(grid, relaxation_, step)),
      contact_(damped_compliance(body, grid, damping_), grid.recess.size()),
      force_(grid.recess.size()),
      old_force_(force_),
      position_(force_),
      displacement_(force_),
      inner_velocity_(force_),
      memory_(force_),
      free_(force_),
      contact_displacement_(force_),
      gap_(force_) {}

const std::vector<double>& RadiatingTail::advance(const std::vector<double>& position) {
  const std::size_t size = position.size();
  for (std::size_t i = 0; i < size; ++i) memory_[i] = damping_[i] * (displacement_[i] + step_ * inner_velocity_[i]);
  contact_.multiply(memory_, free_);
  for (std::size_t i = 0; i < size; ++i) gap_[i] = position[i] - free_[i];
  old_force_.swap(force_);
  contact_.solve(gap_, force_, contact_displacement_);
  for (std::size_t i = 0; i < size; ++i) {
    const double moved = free_[i] + contact_displacement_[i] - displacement_[i];
    inner_velocity_[i] = (relaxation_ * inner_velocity_[i] + moved) / (relaxation_ + step_);
    displacement_[i] += moved;
    work_ += 0.5 * (old_force_[i] + force_[i]) * (position[i] - position_[i]);
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
