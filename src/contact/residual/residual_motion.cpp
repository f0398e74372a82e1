#include "contact/residual/residual_motion.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/residual/residual_part.hpp"
#include "numeric/dense.hpp"
#include "numeric/kernels.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

namespace dense = numeric::dense;
namespace kernels = numeric::kernels;

using Eigen::Index;
using Eigen::MatrixXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// γ: with it the tail of a family of modes has the spring constant (2/π) ω_c Z at high frequency
/// (docs/developer/numerics.md).
constexpr double link_stiffness = 8.0 / std::numbers::pi - 0.5 * std::numbers::pi;

std::vector<double> values(const RowMajor& matrix) { return {matrix.data(), matrix.data() + matrix.size()}; }

std::vector<double> values_of_symmetric(const MatrixXd& matrix, const Poll& poll) {
  std::vector<double> result = dense::zeros(static_cast<std::size_t>(matrix.size()), poll);
  std::copy_n(matrix.data(), matrix.size(), result.begin());
  return result;
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
    throw NotConverged("contact: the compliance between the nodes is not positive definite", "nodes",
                       "use fewer nodes");
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

/// θ
double share_of(double viscous) { return 1.0 / (1.0 + 1.5 * viscous); }

}  // namespace

ResidualMotion::Matrices ResidualMotion::discretize(const ResidualPart& part, const Contact& contact,
                                                    const ContactGrid& grid, double step, const Poll& poll) {
  const auto n = static_cast<Index>(grid.recess.size());
  MatrixXd compliance = dense::square(part.compliance.data(), n, poll);
  if (longest_loss_time(contact) == 0.0) add_kick_compliance(contact, grid, step, poll, compliance);
  MatrixXd moment = root(dense::square(part.second_moment().data(), n, poll), poll);
  const auto masses = moment.cols();
  const Eigen::VectorXd impedance = Eigen::Map<const Eigen::VectorXd>(part.impedance.data(), n);
  const Eigen::VectorXd link = impedance * (link_stiffness * part.cutoff + 1.0 / step);

  MatrixXd participation = moment;
  dense::solve(factored(dense::square(compliance.data(), n, poll), poll), participation, poll);
  MatrixXd inertia = product(participation, link.cwiseInverse().asDiagonal() * participation, poll);
  inertia.diagonal().array() += 0.25 * step * step;
  MatrixXd mobility = MatrixXd::Identity(masses, masses);
  dense::solve(factored(inertia, poll), mobility, poll);

  if (part.loss_time > 0.0) {
    const double share = share_of(part.loss_time / step);
    compliance *= share;
    moment *= share;
  }
  // θY T θYᵀ = QᵀQ
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
  std::vector<double> reaction;
  if (longest_loss_time(contact) > 0.0) reaction.assign(participation.data(), participation.data() + n * masses);
  return {values_of_symmetric(compliance, poll),
          values(participation),
          values(mobility),
          values(memory),
          std::move(reaction),
          static_cast<std::size_t>(masses)};
}

ResidualMotion::Matrices ResidualMotion::massless(ResidualPart part, double step) {
  Matrices matrices;
  matrices.compliance = std::move(part.compliance);
  if (part.loss_time > 0.0) {
    for (double& each : matrices.compliance) each *= share_of(part.loss_time / step);
  }
  return matrices;
}

ResidualMotion::ResidualMotion(ResidualPart part, const Contact& contact, const ContactGrid& grid, Inertia inertia,
                               double step, const Poll& poll)
    : nodes_(grid.recess.size()),
      step_(step),
      fading_(1.0 / (1.0 + link_stiffness * part.cutoff * step)),
      viscous_(part.loss_time / step),
      share_(share_of(viscous_)),
      matrices_(std::make_shared<const Matrices>(inertia == Inertia::all ? discretize(part, contact, grid, step, poll)
                                                                         : massless(std::move(part), step))),
      free_(nodes_),
      mass_displacement_(matrices_->masses),
      mass_velocity_(matrices_->masses),
      mass_acceleration_(matrices_->masses),
      stretch_(matrices_->masses),
      rest_(matrices_->masses),
      moved_(matrices_->masses),
      lossy_(longest_loss_time(contact) > 0.0) {
  if (!lossy_) return;
  moved_before_.resize(matrices_->masses);
  drive_.resize(matrices_->masses);
  for (auto* each : {&displacement_, &before_, &spring_force_, &spring_before_, &viscous_force_, &reaction_})
    each->resize(nodes_);
}

kernels::Masses ResidualMotion::view() {
  return {mass_displacement_.data(), mass_velocity_.data(), mass_acceleration_.data(), stretch_.data(),
          matrices_->masses};
}

const std::vector<double>& ResidualMotion::predict() {
  const std::size_t masses = matrices_->masses;
  const double remembered = viscous_ * share_;
  kernels::drift(view(), step_, fading_, rest_.data());
  for (std::size_t k = 0; lossy_ && k < masses; ++k) {
    drive_[k] = rest_[k] - remembered * (2.0 * moved_[k] - 0.5 * moved_before_[k]);
  }
  const std::vector<double>& drive = lossy_ ? drive_ : rest_;
  kernels::multiply_transposed(matrices_->memory.data(), nodes_, masses, 0, nodes_, drive.data(), free_.data());
  if (lossy_) {
    for (std::size_t i = 0; i < nodes_; ++i) free_[i] += remembered * (2.0 * displacement_[i] - 0.5 * before_[i]);
  }
  return free_;
}

void ResidualMotion::move(const std::vector<double>& displacement, const std::vector<double>& force) {
  const std::size_t masses = matrices_->masses;
  if (lossy_) moved_before_ = moved_;
  kernels::multiply_transposed(matrices_->participation.data(), masses, nodes_, 0, masses, displacement.data(),
                               moved_.data());
  kernels::subtract(moved_.data(), rest_.data(), masses, rest_.data());
  kernels::multiply_transposed(matrices_->mobility.data(), masses, masses, 0, masses, rest_.data(),
                               mass_acceleration_.data());
  kernels::accelerate(view(), step_, moved_.data());
  if (lossy_) lose(displacement, force);
}

void ResidualMotion::lose(const std::vector<double>& displacement, const std::vector<double>& force) {
  kernels::multiply_transposed(matrices_->reaction.data(), nodes_, matrices_->masses, 0, nodes_,
                               mass_acceleration_.data(), reaction_.data());
  for (std::size_t i = 0; i < nodes_; ++i) {
    const double springs = force[i] - reaction_[i];
    const double now = share_ * (springs + viscous_ * (2.0 * spring_force_[i] - 0.5 * spring_before_[i]));
    const double viscous = springs - now;
    dissipated_ += 0.5 * (viscous_force_[i] + viscous) * (displacement[i] - displacement_[i]);
    viscous_force_[i] = viscous;
    spring_before_[i] = spring_force_[i];
    spring_force_[i] = now;
    before_[i] = displacement_[i];
    displacement_[i] = displacement[i];
  }
}

double ResidualMotion::stored() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < spring_force_.size(); ++i) sum += 0.5 * displacement_[i] * spring_force_[i];
  return sum;
}

}  // namespace stoss
