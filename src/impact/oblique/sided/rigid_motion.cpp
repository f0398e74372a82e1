#include "impact/oblique/sided/rigid_motion.hpp"

#include <vector>

#include "contact/unit_ratios.hpp"

namespace stoss {

using Eigen::Index;
using Eigen::VectorXd;

RigidMotion::RigidMotion(const Contact& contact, const ContactPoints& points, double step, const ObliqueFrame& frame,
                         const Obliquity& obliquity)
    : frame_(frame),
      before_(obliquity),
      step_(step),
      mass_(contact.mass),
      velocity_(frame.speed),
      tangential_(obliquity.tangential),
      spin_{obliquity.spin, obliquity.second_spin} {
  for (int number = 0; number < 2; ++number) {
    const auto k = static_cast<std::size_t>(number);
    arm_[k] = whole_arm_[k] = VectorXd::Zero(static_cast<Index>(2 * points.count));
    if (frame.inertia[k] == 0.0) continue;
    const Body& body = *body_of(contact, number);
    const UnitRatios units = units_of(contact, number);
    const std::vector<double> recess = body.surface(seen_by(points, units)).recess;
    const auto side = VectorXd::Map(recess.data(), static_cast<Index>(points.count));
    VectorXd cosine(2 * side.size());
    cosine << side, side;
    cosine = body.extent - cosine.array();
    arm_[k] = whole_arm_[k] = units.length * cosine;
    inertia_[k] = body.inertia * units.mass * units.length * units.length;
    const double size = body.part.size;
    part_[k] = size < 1.0;
    if (!part_[k]) continue;
    arm_[k] = units.length * (size * size - 1.0 + cosine.array().square()).sqrt();
    tangential_ += (1.0 - size * size) * spin_[k] * frame.radius[k];
    spin_[k] *= size;
  }
  start_tangential_ = tangential_;
  start_energy_ = energy();
}

double RigidMotion::spin(std::size_t body) const {
  return inertia_[body] > 0.0 ? spin_[body] - 0.5 * moment_[body] * step_ / inertia_[body] : 0.0;
}

double RigidMotion::energy() const {
  double energy = 0.5 * mass_ * (velocity() * velocity() + tangential() * tangential());
  for (std::size_t k = 0; k < 2; ++k) energy += 0.5 * inertia_[k] * spin(k) * spin(k);
  return energy;
}

void RigidMotion::advance() {
  velocity_ -= force_ * step_ / mass_;
  tangential_ -= friction_ * step_ / mass_;
  compression_ += velocity_ * step_;
  shift_ += tangential_ * step_;
  for (std::size_t k = 0; k < 2; ++k) {
    if (inertia_[k] == 0.0) continue;
    spin_[k] -= moment_[k] * step_ / inertia_[k];
    angle_[k] += spin_[k] * step_;
    whole_angle_[k] += (whole_spin(k) - 0.5 * whole_moment_[k] * step_ / frame_.inertia[k]) * step_;
  }
}

void RigidMotion::load(const VectorXd& force, const VectorXd& friction) {
  const double half = 0.5 * step_, now = friction.sum();
  force_ = force.sum();
  impulse_ += half * (friction_ + now);
  friction_ = now;
  for (std::size_t k = 0; k < 2; ++k) {
    const double whole = friction.dot(whole_arm_[k]);
    impulse_of_moment_[k] += half * (whole_moment_[k] + whole);
    whole_moment_[k] = whole;
    moment_[k] = friction.dot(arm_[k]);
  }
}

VectorXd RigidMotion::along() const {
  return (shift_ + angle_[0] * arm_[0].array() + angle_[1] * arm_[1].array()).matrix();
}

double RigidMotion::whole_velocity() const {
  return mass_ == frame_.mass ? velocity() : frame_.speed - mass_ / frame_.mass * (frame_.speed - velocity());
}

double RigidMotion::whole_spin(std::size_t body) const {
  const double before = body == 0 ? before_.spin : before_.second_spin;
  return before - impulse_of_moment_[body] / frame_.inertia[body];
}

void RigidMotion::show(double extent, ObliqueSnapshot& now) const {
  const double part = mass_ / frame_.mass;
  const auto whole = [&](double start, double way, double start_of_part) {
    return part == 1.0 ? way : start * now.time - part * (start_of_part * now.time - way);
  };
  now.center = start_compression_ - extent + whole(frame_.speed, compression_ - start_compression_, frame_.speed);
  now.shift = whole(before_.tangential, shift_, start_tangential_);
  now.angle = whole_angle_[0];
  now.second_angle = whole_angle_[1];
}

AlongOutcome RigidMotion::outcome() const {
  AlongOutcome outcome;
  const bool whole = mass_ == frame_.mass;
  outcome.tangential =
      whole ? tangential() : before_.tangential - mass_ / frame_.mass * (start_tangential_ - tangential());
  double energy_after =
      0.5 * frame_.mass * (whole_velocity() * whole_velocity() + outcome.tangential * outcome.tangential);
  for (std::size_t k = 0; k < 2; ++k) {
    outcome.spin[k] = part_[k] ? whole_spin(k) : spin(k);
    energy_after += 0.5 * frame_.inertia[k] * outcome.spin[k] * outcome.spin[k];
  }
  outcome.impulse = impulse_;
  outcome.moment = impulse_of_moment_;
  if (whole) return outcome;
  const double energy_before =
      frame_.initial_energy(before_) - frame_.normal_energy + 0.5 * frame_.mass * frame_.speed * frame_.speed;
  outcome.vibration[part_[0] ? 0 : 1] = energy_before - energy_after - (start_energy_ - energy());
  return outcome;
}

}  // namespace stoss
