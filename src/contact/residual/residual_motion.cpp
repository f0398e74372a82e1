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

}  // namespace

ResidualMotion::Matrices ResidualMotion::discretize(const ResidualPart& part, const Contact& contact,
                                                    const ContactGrid& grid, double step, const Poll& poll) {
  const auto n = static_cast<Index>(grid.recess.size());
  MatrixXd compliance = dense::square(part.compliance.data(), n, poll);
  if (!loses(contact)) add_kick_compliance(contact, grid, step, poll, compliance);
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

  if (!part.creep.terms.empty()) {
    const double share = share_of(part.creep, step);
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
  if (loses(contact)) reaction.assign(participation.data(), participation.data() + n * masses);
  return {values_of_symmetric(compliance, poll),
          values(participation),
          values(mobility),
          values(memory),
          std::move(reaction),
          static_cast<std::size_t>(masses)};
}

ResidualMotion::Matrices ResidualMotion::massless(ResidualPart& part, double step) {
  Matrices matrices;
  matrices.compliance = std::move(part.compliance);
  if (part.creep.terms.empty()) return matrices;
  const double share = share_of(part.creep, step);
  for (double& each : matrices.compliance) each *= share;
  return matrices;
}

ResidualMotion::ResidualMotion(ResidualPart part, const Contact& contact, const ContactGrid& grid, Inertia inertia,
                               double step, const Poll& poll)
    : nodes_(grid.recess.size()),
      step_(step),
      fading_(1.0 / (1.0 + link_stiffness * part.cutoff * step)),
      matrices_(std::make_shared<const Matrices>(inertia == Inertia::all ? discretize(part, contact, grid, step, poll)
                                                                         : massless(part, step))),
      free_(nodes_),
      mass_displacement_(matrices_->masses),
      mass_velocity_(matrices_->masses),
      mass_acceleration_(matrices_->masses),
      stretch_(matrices_->masses),
      rest_(matrices_->masses),
      moved_(matrices_->masses),
      lossy_(loses(contact)),
      strain_(part.creep, step, lossy_ ? nodes_ : 0),
      mass_strain_(part.creep, step, lossy_ ? matrices_->masses : 0),
      stress_(part.creep, step, lossy_ ? nodes_ : 0) {
  if (!lossy_) return;
  drive_.resize(matrices_->masses);
  for (auto* each : {&displacement_, &spring_force_, &before_, &reaction_}) each->resize(nodes_);
}

kernels::Masses ResidualMotion::view() {
  return {mass_displacement_.data(), mass_velocity_.data(), mass_acceleration_.data(), stretch_.data(),
          matrices_->masses};
}

const std::vector<double>& ResidualMotion::predict() {
  const std::size_t masses = matrices_->masses;
  kernels::drift(view(), step_, fading_, rest_.data());
  if (lossy_) kernels::subtract(rest_.data(), mass_strain_.predict().data(), masses, drive_.data());
  const std::vector<double>& drive = lossy_ ? drive_ : rest_;
  kernels::multiply_transposed(matrices_->memory.data(), nodes_, masses, 0, nodes_, drive.data(), free_.data());
  if (lossy_) kernels::add(free_.data(), strain_.predict().data(), nodes_, free_.data());
  return free_;
}

void ResidualMotion::move(const std::vector<double>& displacement, const std::vector<double>& force) {
  const std::size_t masses = matrices_->masses;
  kernels::multiply_transposed(matrices_->participation.data(), masses, nodes_, 0, masses, displacement.data(),
                               moved_.data());
  kernels::subtract(moved_.data(), rest_.data(), masses, rest_.data());
  kernels::multiply_transposed(matrices_->mobility.data(), masses, masses, 0, masses, rest_.data(),
                               mass_acceleration_.data());
  kernels::accelerate(view(), step_, moved_.data());
  if (lossy_) lose(displacement, force);
}

bool ResidualMotion::is_still(const std::vector<double>& displacement, double negligible) const {
  const std::vector<double>& strain = lossy_ ? strain_.elastic() : displacement;
  return std::all_of(strain.begin(), strain.end(), [&](double each) { return std::abs(each) <= negligible; });
}

void ResidualMotion::rest(double time) {
  for (auto* each : {&mass_displacement_, &mass_velocity_, &mass_acceleration_, &stretch_}) {
    std::fill(each->begin(), each->end(), 0.0);
  }
  if (!lossy_) return;
  for (CreepMemory* each : {&strain_, &mass_strain_, &stress_}) each->fade(time);
  for (auto* each : {&spring_force_, &before_, &reaction_}) std::fill(each->begin(), each->end(), 0.0);
  displacement_ = strain_.crept();
  mass_displacement_ = mass_strain_.crept();
}

void ResidualMotion::lose(const std::vector<double>& displacement, const std::vector<double>& force) {
  kernels::multiply_transposed(matrices_->reaction.data(), nodes_, matrices_->masses, 0, nodes_,
                               mass_acceleration_.data(), reaction_.data());
  before_.swap(spring_force_);
  kernels::subtract(force.data(), reaction_.data(), nodes_, spring_force_.data());
  for (std::size_t i = 0; i < nodes_; ++i) {
    work_ += 0.5 * (before_[i] + spring_force_[i]) * (displacement[i] - displacement_[i]);
  }
  displacement_ = displacement;
  strain_.follow(displacement);
  mass_strain_.follow(moved_);
  stress_.take(spring_force_);
}

}  // namespace stoss
