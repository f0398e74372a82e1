#include "newton.hpp"

#include <cmath>
#include <stdexcept>

namespace yield_study {

Newton::Newton(Body& body) : body_(body) { solver_.analyzePattern(body_.tangent()); }

void Newton::step(Eigen::VectorXd& unknowns, const std::vector<char>& prescribed, const Eigen::VectorXd& values,
                  const Eigen::VectorXd& external) {
  Eigen::SparseMatrix<double>& tangent = body_.tangent();
  Eigen::VectorXd jump = Eigen::VectorXd::Zero(body_.size());
  for (int k = 0; k < body_.size(); ++k)
    if (prescribed[static_cast<std::size_t>(k)]) jump[k] = values[k] - unknowns[k];
  Eigen::VectorXd right = external - body_.forces();
  right -= tangent.selfadjointView<Eigen::Lower>() * jump;
  for (int column = 0; column < body_.size(); ++column) {
    const bool held = prescribed[static_cast<std::size_t>(column)];
    if (held) right[column] = jump[column];
    for (Eigen::SparseMatrix<double>::InnerIterator entry(tangent, column); entry; ++entry)
      if (held || prescribed[static_cast<std::size_t>(entry.row())])
        entry.valueRef() = entry.row() == column ? 1.0 : 0.0;
  }
  solver_.factorize(tangent);
  if (solver_.info() != Eigen::Success) throw std::runtime_error("the tangent is singular");
  unknowns += solver_.solve(right);
  body_.assemble(unknowns);
}

double Newton::imbalance(const std::vector<char>& prescribed, const Eigen::VectorXd& external) const {
  double wrong = 0.0, all = external.cwiseAbs().sum();
  for (int k = 0; k < body_.size(); ++k) {
    if (prescribed[static_cast<std::size_t>(k)])
      all += std::abs(body_.forces()[k]);
    else
      wrong += std::abs(body_.forces()[k] - external[k]);
  }
  return all > 0.0 ? wrong / all : wrong;
}

void solve(Body& body, Newton& newton, Eigen::VectorXd& unknowns, const std::vector<char>& prescribed,
           const Eigen::VectorXd& values, const Eigen::VectorXd& external, double tolerance) {
  constexpr int most = 40;
  body.assemble(unknowns);
  for (int iteration = 0; iteration < most; ++iteration) {
    newton.step(unknowns, prescribed, values, external);
    if (newton.imbalance(prescribed, external) < tolerance) {
      body.keep();
      return;
    }
  }
  throw std::runtime_error("no equilibrium found");
}

}  // namespace yield_study
