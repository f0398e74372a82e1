// Kept modes between kicks: each rotates in the plane of its coordinate and its velocity over ω.
#include <cmath>

#include "impact.hpp"

namespace adhesion_study {

Modes::Modes(const stoss::Body& body, const stoss::Surface& surface, double step) : mass_(body.mass) {
  const auto rings = static_cast<Eigen::Index>(surface.recess.size());
  const auto rows = static_cast<Eigen::Index>(surface.shape.size()) / rings;
  shape_ = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      surface.shape.data(), rows, rings);
  amount_ = Eigen::VectorXd::Zero(rows);
  std::vector<double> omega, upper, lower;
  for (const stoss::ModeGroup& group : body.groups) {
    const auto begin = static_cast<Eigen::Index>(omega.size());
    omega.insert(omega.end(), group.omega.begin(), group.omega.end());
    upper.insert(upper.end(), group.upper.begin(), group.upper.end());
    lower.insert(lower.end(), group.lower.begin(), group.lower.end());
    groups_.push_back({begin, static_cast<Eigen::Index>(omega.size()), static_cast<Eigen::Index>(group.upper_row),
                       static_cast<Eigen::Index>(group.lower_row)});
  }
  const auto count = static_cast<Eigen::Index>(omega.size());
  omega_ = Eigen::Map<const Eigen::ArrayXd>(omega.data(), count);
  upper_ = Eigen::Map<const Eigen::ArrayXd>(upper.data(), count);
  lower_ = Eigen::Map<const Eigen::ArrayXd>(lower.data(), count);
  upper_over_ = upper_ / omega_;
  lower_over_ = lower_ / omega_;
  next_ = Eigen::ArrayXd::Zero(count);
  cosine_ = (omega_ * step).cos();
  sine_ = (omega_ * step).sin();
  coordinate_ = Eigen::ArrayXd::Zero(count);
  velocity_ = Eigen::ArrayXd::Zero(count);
}

void Modes::kick(const Eigen::VectorXd& force, double time) {
  const Eigen::VectorXd on = shape_ * force * (-time / mass_);
  for (const Group& group : groups_) {
    const Eigen::Index size = group.end - group.begin;
    velocity_.segment(group.begin, size) += on[group.upper] * upper_over_.segment(group.begin, size) +
                                            on[group.lower] * lower_over_.segment(group.begin, size);
  }
}

void Modes::rotate() {
  amount_.setZero();
  for (const Group& group : groups_) {
    const Eigen::Index begin = group.begin, size = group.end - group.begin;
    auto q = coordinate_.segment(begin, size);
    auto p = velocity_.segment(begin, size);
    const auto c = cosine_.segment(begin, size), s = sine_.segment(begin, size);
    next_.head(size) = q * c + p * s;
    p = p * c - q * s;
    q = next_.head(size);
    amount_[group.upper] += (upper_.segment(begin, size) * q).sum();
    amount_[group.lower] += (lower_.segment(begin, size) * q).sum();
  }
}

double Modes::energy() const {
  return 0.5 * mass_ * (omega_.square() * (coordinate_.square() + velocity_.square())).sum();
}

}  // namespace adhesion_study
