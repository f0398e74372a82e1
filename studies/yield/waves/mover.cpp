#include "mover.hpp"

#include <cmath>

namespace yield_study {

Mover::Mover(Body body)
    : body_(std::move(body)), at_(Eigen::VectorXd::Zero(body_.size())), speed_(Eigen::VectorXd::Zero(body_.size())) {
  for (int node = 0; node < nodes(); ++node) mass_ += mass(node);
}

double Mover::stable_step() {
  body_.assemble(at_);
  const Eigen::SparseMatrix<double>& tangent = body_.tangent();
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(body_.size());
  for (int column = 0; column < body_.size(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(tangent, column); entry; ++entry) {
      sums[column] += std::abs(entry.value());
      if (entry.row() != column) sums[entry.row()] += std::abs(entry.value());
    }
  return 2.0 / std::sqrt(sums.cwiseQuotient(body_.volumes()).maxCoeff());
}

void Mover::set_off(double velocity) {
  for (int node = 0; node < nodes(); ++node) speed_[along(node)] = velocity;
}

void Mover::push(double step) {
  body_.follow(at_);
  speed_ -= step * body_.forces().cwiseQuotient(body_.volumes());
}

double Mover::place(int node) const { return body_.mesh().nodes[static_cast<std::size_t>(node)][1] + at_[along(node)]; }

double Mover::mean_velocity() const {
  double momentum = 0.0;
  for (int node = 0; node < nodes(); ++node) momentum += mass(node) * velocity(node);
  return momentum / mass_;
}

double Mover::kinetic_energy() const { return 0.5 * speed_.dot(body_.volumes().cwiseProduct(speed_)); }

}  // namespace yield_study
