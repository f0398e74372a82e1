#include "impact/rigid_motion.hpp"

#include <vector>

#include "contact/unit_ratios.hpp"

namespace stoss {

using Eigen::Index;
using Eigen::VectorXd;

RigidMotion::RigidMotion(const Contact& contact, const ContactPoints& points, double step, const ObliqueFrame& frame,
                         const Obliquity& obliquity)
    : frame_(frame),
      step_(step),
      velocity_(frame.speed),
      tangential_(obliquity.tangential),
      spin_{obliquity.spin, obliquity.second_spin} {
  for (int number = 0; number < 2; ++number) {
    const auto k = static_cast<std::size_t>(number);
    arm_[k] = VectorXd::Zero(static_cast<Index>(2 * points.count));
    if (frame.inertia[k] == 0.0) continue;
    const Body& body = *body_of(contact, number);
    const UnitRatios units = units_of(contact, number);
    const std::vector<double> recess = body.surface(seen_by(points, units)).recess;
    const auto side = VectorXd::Map(recess.data(), static_cast<Index>(points.count));
    arm_[k] << side, side;
    arm_[k] = units.length * (body.extent - arm_[k].array());
  }
}

void RigidMotion::advance() {
  velocity_ -= force_ * step_ / frame_.mass;
  tangential_ -= friction_ * step_ / frame_.mass;
  compression_ += velocity_ * step_;
  shift_ += tangential_ * step_;
  for (std::size_t k = 0; k < 2; ++k) {
    if (frame_.inertia[k] == 0.0) continue;
    spin_[k] -= moment_[k] * step_ / frame_.inertia[k];
    angle_[k] += spin_[k] * step_;
  }
}

void RigidMotion::load(const VectorXd& force, const VectorXd& friction) {
  const double half = 0.5 * step_, now = friction.sum();
  force_ = force.sum();
  impulse_ += half * (friction_ + now);
  friction_ = now;
  for (std::size_t k = 0; k < 2; ++k) {
    const double moment = friction.dot(arm_[k]);
    moments_[k] += half * (moment_[k] + moment);
    moment_[k] = moment;
  }
}

VectorXd RigidMotion::along() const {
  return (shift_ + angle_[0] * arm_[0].array() + angle_[1] * arm_[1].array()).matrix();
}

AlongOutcome RigidMotion::outcome() const {
  AlongOutcome outcome;
  outcome.tangential = tangential_ - 0.5 * friction_ * step_ / frame_.mass;
  outcome.spin = spin_;
  for (std::size_t k = 0; k < 2; ++k) {
    if (frame_.inertia[k] > 0.0) outcome.spin[k] -= 0.5 * moment_[k] * step_ / frame_.inertia[k];
  }
  outcome.impulse = impulse_;
  outcome.moment = moments_;
  return outcome;
}

}  // namespace stoss
