#include "support/complementarity.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "numeric/dense.hpp"
#include "stoss/errors.hpp"

namespace stoss {

Complementarity::Complementarity(std::vector<double> matrix, std::size_t size, Poll poll)
    : compliance_(std::move(matrix), size, poll), inner_(size), poll_(std::move(poll)) {}

void Complementarity::solve_leading(std::size_t count, const std::vector<double>& q, std::vector<double>& force) {
  compliance_.forward(count, q, inner_);
  compliance_.backward(count, inner_, force);
}

void Complementarity::solve(const std::vector<double>& q, std::vector<double>& force,
                            std::vector<double>& displacement) {
  double deepest = 0.0;
  bool finite = true;
  for (const double position : q) {
    deepest = std::max(deepest, position);
    finite = finite && std::isfinite(position);
  }
  if (!finite)
    throw NotConverged("contact: the position of a node is not a finite number", "step", "use a smaller step");
  if (deepest == 0.0) {
    std::fill(force.begin(), force.end(), 0.0);
    std::fill(displacement.begin(), displacement.end(), 0.0);
    extent_ = 0;
    return;
  }
  const double tolerance = 1e-13 * deepest;
  if (!solve_interval(q, tolerance, force, displacement)) solve_any(q, tolerance, force, displacement);
}

bool Complementarity::solve_interval(const std::vector<double>& q, double tolerance, std::vector<double>& force,
                                     std::vector<double>& displacement) {
  constexpr int max_trials = 12;
  std::size_t count = std::max<std::size_t>(extent_, 1);
  for (int trial = 0; trial < max_trials; ++trial) {
    solve_leading(count, q, force);
    std::size_t keep = count;
    while (keep > 0 && force[keep - 1] < 0.0) --keep;
    if (std::any_of(force.begin(), force.begin() + static_cast<std::ptrdiff_t>(keep),
                    [](double f) { return f < 0.0; })) {
      return false;
    }
    if (keep == 0) return false;
    if (keep < count) {
      count = keep;
      continue;
    }
    std::copy_n(q.begin(), count, displacement.begin());
    compliance_.multiply(count, count, force, displacement);
    std::size_t grown = count;
    while (grown < compliance_.size() && displacement[grown] - q[grown] < -tolerance) ++grown;
    for (std::size_t i = grown; i < compliance_.size(); ++i) {
      if (displacement[i] - q[i] < -tolerance) return false;
    }
    if (grown == count) {
      std::fill(force.begin() + static_cast<std::ptrdiff_t>(count), force.end(), 0.0);
      extent_ = count;
      return true;
    }
    count = grown;
  }
  return false;
}

void Complementarity::solve_on_set(const std::vector<std::size_t>& set, const std::vector<double>& q,
                                   std::vector<double>& force, std::vector<double>& displacement) const {
  const auto n = static_cast<Eigen::Index>(set.size());
  const auto w = compliance_.matrix();
  Eigen::MatrixXd block(n, n);
  Eigen::MatrixXd right(n, 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t row = set[static_cast<std::size_t>(i)];
    right(i, 0) = q[row];
    for (Eigen::Index j = 0; j < n; ++j)
      block(i, j) = w(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(set[static_cast<std::size_t>(j)]));
  }
  if (!numeric::dense::factor(block, poll_)) {
    throw NotConverged("contact: the compliance between the nodes is not positive definite", "nodes",
                       "use fewer nodes");
  }
  numeric::dense::solve(block, right, poll_);
  std::fill(force.begin(), force.end(), 0.0);
  for (Eigen::Index i = 0; i < n; ++i) force[set[static_cast<std::size_t>(i)]] = right(i, 0);
  compliance_.multiply(0, compliance_.size(), force, displacement);
  for (const std::size_t row : set) displacement[row] = q[row];
}

void Complementarity::solve_any(const std::vector<double>& q, double tolerance, std::vector<double>& force,
                                std::vector<double>& displacement) {
  constexpr int patience = 4;  // block exchanges without progress before single ones
  std::vector<bool> in_contact(compliance_.size(), false);
  for (std::size_t i = 0; i < compliance_.size(); ++i) in_contact[i] = q[i] > 0.0;
  std::vector<std::size_t> set, wrong;
  std::size_t fewest = compliance_.size() + 1;
  int tries_left = patience;
  const std::size_t max_passes = 20 * compliance_.size() + 100;
  for (std::size_t pass = 0; pass < max_passes; ++pass) {
    set.clear();
    for (std::size_t i = 0; i < compliance_.size(); ++i) {
      if (in_contact[i]) set.push_back(i);
    }
    solve_on_set(set, q, force, displacement);
    wrong.clear();
    for (std::size_t i = 0; i < compliance_.size(); ++i) {
      if (in_contact[i] ? force[i] < 0.0 : displacement[i] - q[i] < -tolerance) wrong.push_back(i);
    }
    if (wrong.empty()) {
      extent_ = set.empty() ? 0 : set.back() + 1;
      return;
    }
    if (wrong.size() < fewest) {
      fewest = wrong.size();
      tries_left = patience;
    } else if (tries_left > 0) {
      --tries_left;
    }
    if (tries_left > 0) {
      for (const std::size_t i : wrong) in_contact[i] = !in_contact[i];
    } else {
      in_contact[wrong.back()] = !in_contact[wrong.back()];
    }
  }
  throw NotConverged(
      "contact: no set of touching nodes satisfies the contact conditions (another resolution may do; please report "
      "the input)");
}

}  // namespace stoss
