#include "contact/coupled/coupled_contact.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "contact/edge/edge_newton.hpp"
#include "contact/friction.hpp"
#include "stoss/errors.hpp"

namespace stoss {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

CoupledCompliance compliance_of_sides(const std::vector<double>& normal_even, const std::vector<double>& along_even,
                                      std::size_t points) {
  const auto n = static_cast<Index>(points);
  // Symmetric: rows are columns.
  const Eigen::Map<const MatrixXd> s(normal_even.data(), 2 * n, 2 * n), a(along_even.data(), 2 * n, 2 * n);
  const auto joined = [n](const MatrixXd& even, const MatrixXd& odd) {
    MatrixXd both(2 * n, 2 * n);
    both << even + odd, even - odd, even - odd, even + odd;
    return both;
  };
  CoupledCompliance result;
  result.xx = joined(s.topLeftCorner(n, n), a.bottomRightCorner(n, n));
  result.yy = joined(a.topLeftCorner(n, n), s.bottomRightCorner(n, n));
  const MatrixXd of_odd = s.topRightCorner(n, n), of_even = a.bottomLeftCorner(n, n);  // friction; displacement x
  result.xy.resize(2 * n, 2 * n);
  result.xy << of_even + of_odd, of_even - of_odd, of_odd - of_even, -of_even - of_odd;
  return result;
}

void Anderson::forget() {
  tried_.clear();
  misses_.clear();
}

Eigen::VectorXd Anderson::next(const Eigen::VectorXd& tried, const Eigen::VectorXd& miss, double share) {
  constexpr std::size_t enough = 3;
  if (tried_.size() == memory_) {
    tried_.erase(tried_.begin());
    misses_.erase(misses_.begin());
  }
  tried_.push_back(tried);
  misses_.push_back(miss);
  if (tried_.size() < enough) return tried + share * miss;
  const auto columns = static_cast<Eigen::Index>(tried_.size()) - 1;
  Eigen::MatrixXd step(miss.size(), columns), change(miss.size(), columns);
  for (Eigen::Index j = 0; j < columns; ++j) {
    const auto k = static_cast<std::size_t>(j);
    step.col(j) = tried_[k + 1] - tried_[k];
    change.col(j) = misses_[k + 1] - misses_[k];
  }
  return tried + miss - (step + change) * change.colPivHouseholderQr().solve(miss);
}

namespace {

constexpr std::size_t remembered = 6;

/// The law of all sides, each with its share of the force.
EdgeLaw on_sides(std::size_t sides, EdgeLaw law) {
  if (sides == 1) return law;
  for (auto* array : {&law.force, &law.edge_force}) {
    for (double& each : *array) each *= 0.5;
  }
  for (auto* array : {&law.force, &law.gap, &law.edge_force, &law.edge_gap, &law.edge_open}) {
    const std::vector<double> side = *array;
    array->insert(array->end(), side.begin(), side.end());
  }
  return law;
}

std::vector<double> values(const Eigen::MatrixXd& matrix) { return {matrix.data(), matrix.data() + matrix.size()}; }

Index at(std::size_t i) { return static_cast<Index>(i); }

}  // namespace

CoupledContact::CoupledContact(CoupledCompliance compliance, const EdgeLaw& law, double friction, double ratio,
                               Poll poll)
    : compliance_(std::move(compliance)),
      along_(values(compliance_.yy)),
      sides_(static_cast<std::size_t>(compliance_.xx.rows()) / law.gap.size()),
      law_(on_sides(sides_, law)),
      coefficient_(friction),
      ratio_(ratio),
      poll_(std::move(poll)),
      coulomb_(law_.gap.size()),
      anderson_(remembered),
      force_(VectorXd::Zero(compliance_.xx.rows())),
      friction_(force_),
      closure_(law_.gap.size()),
      give_(law_.gap.size()),
      free_(law_.gap.size()),
      limit_(law_.gap.size()),
      q_(law_.gap.size()) {}

std::size_t CoupledContact::extent() const {
  const std::size_t points = closure_.size() / sides_;
  std::size_t end = points;
  while (end > 0 && force_(at(end - 1)) == 0.0 && force_(at(closure_.size() - points + end - 1)) == 0.0) --end;
  return end;
}

bool CoupledContact::overflows() const {
  const std::size_t points = closure_.size() / sides_;
  if (law_.asperities == 0.0) return extent() == points;
  return EdgeLaw::pushes_at(closure_, points - 1) || EdgeLaw::pushes_at(closure_, closure_.size() - 1);
}

double CoupledContact::half_width() const {
  const auto points = static_cast<std::ptrdiff_t>(closure_.size() / sides_);
  if (law_.asperities > 0.0) {
    double pressed = 0.0;
    for (auto side = closure_.begin(); side != closure_.end(); side += points) {
      pressed += EdgeLaw::pressed({side, side + points}) / static_cast<double>(sides_);
    }
    return pressed;
  }
  constexpr double excess = 0.18;  // as EdgeContact has it
  double sum = 0.0;
  for (const double closure : closure_) sum += std::clamp(closure, 0.0, 1.0) / static_cast<double>(sides_);
  return std::max(0.0, sum - excess);
}

void CoupledContact::follow(double before, double now, double step) {
  if (law_.follows()) law_.follow(before, now, half_width(), step);
}

/// Largest position or gap of the nodes that feel the law; 0 if none does.
double CoupledContact::reached(const VectorXd& x) const {
  double scale = 0.0;
  for (std::size_t i = 0; i < closure_.size(); ++i) {
    const double gap = law_.full_gap(i);
    if (x(at(i)) > -gap) scale = std::max({scale, x(at(i)), gap});
  }
  return scale;
}

void CoupledContact::solve(const VectorXd& x, const VectorXd& y) {
  if (!x.allFinite() || !y.allFinite()) {
    throw NotConverged("contact: the position of a node is not a finite number", "step", "use a smaller step");
  }
  if (reached(x) == 0.0) {
    force_.setZero();
    friction_.setZero();
    gap_ = -x;
    for (std::size_t i = 0; i < closure_.size(); ++i) closure_[i] = law_.free_closure(i, -x(at(i)));
    return;
  }
  if (gap_.size() == 0) gap_ = -x;
  // The first is enough but for much friction between unlike bodies.
  constexpr std::array<Attempt, 4> attempts{
      {{.with_force = true, .all_slide = false, .accelerated = true},
       {.with_force = true, .all_slide = true, .accelerated = true},
       {.with_force = true, .all_slide = false, .accelerated = false, .share = 0.5},
       {.with_force = false, .all_slide = false, .accelerated = true, .share = 0.5, .most = 300}}};
  if (std::none_of(attempts.begin(), attempts.end(), [&](const Attempt& each) { return solved(each, x, y); })) {
    throw NotConverged(
        "friction: no forces at the nodes obey the laws of contact and of friction (Coulomb's law is ill-posed for so "
        "much of it between unlike bodies)");
  }
  force_ = new_force_;
  friction_ = new_friction_;
  gap_ = new_gap_;
  closure_ = new_closure_;
}

/// Makes the friction of sliding nodes move with their forces, and that of the others not.
void CoupledContact::take_into_matrix(const std::vector<int>& sliding) {
  if (sliding == in_matrix_) return;
  in_matrix_ = sliding;
  Eigen::MatrixXd matrix = compliance_.xx;
  for (std::size_t j = 0; j < sliding.size(); ++j) {
    if (sliding[j] != 0) matrix.col(at(j)) += coefficient_ * sliding[j] * compliance_.xy.col(at(j));
  }
  matrix_.assign(std::move(matrix));
}

/// Solves the normal problem with the friction that is tried.
bool CoupledContact::solve_normal(const VectorXd& x, double scale) {
  const VectorXd position = x - compliance_.xy * held_;
  const std::vector<double> q(position.data(), position.data() + position.size());
  const double own = compliance_.xx(0, 0);
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (new_closure_[i] > 0.0) continue;
    new_closure_[i] = law_.asperities > 0.0 ? law_.first_closure(i, -q[i], own) : law_.free_closure(i, -q[i]);
  }
  if (solve_all(matrix_, law_, q, scale, poll_, new_closure_)) return true;
  for (std::size_t i = 0; i < q.size(); ++i) new_closure_[i] = law_.first_closure(i, -q[i], own);
  return solve_all(matrix_, law_, q, scale, poll_, new_closure_);
}

/// Solves Coulomb's law under the forces.
void CoupledContact::solve_friction(const VectorXd& x, const VectorXd& y) {
  new_gap_ = compliance_.xx * new_force_ + compliance_.xy * used_ - x;
  for (std::size_t i = 0; i < closure_.size(); ++i) {
    const Index k = at(i);
    if (new_closure_[i] > 0.0) new_gap_(k) = law_.gap_at(i, new_closure_[i]);
    give_[i] = edge_compliance_along(ratio_, new_gap_(k), gap_(k), new_force_(k), force_(k));
    limit_[i] = coefficient_ * new_force_(k);
    q_[i] = friction_(k);
  }
  VectorXd::Map(free_.data(), y.size()) = y - compliance_.xy.transpose() * new_force_;
  coulomb_.solve(along_, give_, free_, limit_.data(), q_);
  new_friction_ = VectorXd::Map(q_.data(), y.size());
}

bool CoupledContact::solved(const Attempt& attempt, const VectorXd& x, const VectorXd& y) {
  constexpr double tolerance = 1e-10;
  const double scale = reached(x);
  new_closure_ = closure_;
  new_force_.resize(x.size());
  anderson_.forget();
  std::vector<int> states = coulomb_.sliding();
  if (attempt.all_slide) {
    for (std::size_t j = 0; j < states.size(); ++j) states[j] = y(at(j)) > 0.0 ? 1 : -1;
  }
  VectorXd trial = friction_;
  for (int round = 0; round < attempt.most; ++round) {
    take_into_matrix(attempt.with_force ? states : std::vector<int>(states.size()));
    held_ = trial;
    for (std::size_t j = 0; j < states.size(); ++j) {
      if (in_matrix_[j] != 0) held_(at(j)) = 0.0;
    }
    if (!solve_normal(x, scale)) return false;
    used_ = held_;
    for (std::size_t j = 0; j < states.size(); ++j) {
      new_force_(at(j)) = law_.force_at(j, new_closure_[j]);
      if (in_matrix_[j] != 0) used_(at(j)) = coefficient_ * in_matrix_[j] * new_force_(at(j));
    }
    solve_friction(x, y);
    const VectorXd miss = new_friction_ - used_;
    if (miss.cwiseAbs().maxCoeff() <= tolerance * coefficient_ * new_force_.maxCoeff()) return true;
    if (attempt.with_force && coulomb_.sliding() != states) anderson_.forget();
    states = coulomb_.sliding();
    trial = attempt.accelerated ? anderson_.next(used_, miss, attempt.share) : VectorXd(used_ + attempt.share * miss);
  }
  return false;
}

}  // namespace stoss
