// gap = rest + W A p(gap) by Newton's iteration with factors that are kept while they converge.
#include <cmath>
#include <stdexcept>
#include <utility>

#include "impact.hpp"

namespace adhesion_study {

Faces::Faces(Law law, Eigen::VectorXd area, Eigen::MatrixXd compliance, double tolerance)
    : tolerance_(tolerance),
      law_(std::move(law)),
      area_(std::move(area)),
      force_(Eigen::VectorXd::Zero(area_.size())),
      slope_(Eigen::VectorXd::Zero(area_.size())),
      compliance_(std::move(compliance)) {}

void Faces::factor() {
  Eigen::MatrixXd tangent = -compliance_ * slope_.asDiagonal();
  tangent.diagonal().array() += 1.0;
  factors_.compute(tangent);
  factored_ = true;
  ++factors_made_;
}

const Eigen::VectorXd& Faces::force(const Eigen::VectorXd& rest) {
  if (known_ == 0) gap_ = rest;
  const Eigen::VectorXd now = gap_;
  if (known_ > 2) gap_ = 3.0 * (now - before_) + earlier_;  // steps are equal
  double last = 1e300;
  for (int iteration = 0; iteration < 60; ++iteration, ++iterations_) {
    for (Eigen::Index i = 0; i < gap_.size(); ++i) {
      const Response response = law_(gap_[i]);
      force_[i] = area_[i] * response.pressure;
      slope_[i] = area_[i] * response.slope;
    }
    if (!factored_) factor();
    const Eigen::VectorXd change = factors_.solve(gap_ - rest - compliance_ * force_);
    const double largest = change.cwiseAbs().maxCoeff();
    if (!std::isfinite(largest)) break;
    gap_ -= change;
    if (largest < tolerance_) {
      force_ -= slope_.cwiseProduct(change);
      earlier_ = before_;
      before_ = now;
      ++known_;
      return force_;
    }
    if (iteration > 4 && largest > 0.1 * last) factored_ = false;
    last = largest;
  }
  throw std::runtime_error("no forces between the faces");
}

double Faces::energy() const {
  double sum = 0.5 * force_.dot(compliance_ * force_);
  for (Eigen::Index i = 0; i < gap_.size(); ++i) sum += area_[i] * law_(gap_[i]).energy;
  return sum;
}

double Faces::largest_compliance() const {
  const Eigen::VectorXd root = area_.cwiseSqrt();
  Eigen::VectorXd vector = root;
  double value = 0.0;
  for (int k = 0; k < 300; ++k) {
    vector = root.cwiseProduct(compliance_ * root.cwiseProduct(vector));
    value = vector.norm();
    vector /= value;
  }
  return value;
}

}  // namespace adhesion_study
