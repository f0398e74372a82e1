#include "impact/rigid_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "contact/unit_ratios.hpp"

namespace stoss {

using Eigen::Index;
using Eigen::VectorXd;

RigidMotion::RigidMotion(const Contact& contact, const ContactPoints& points, double step, double speed,
                         const Obliquity& obliquity)
    : mass_(contact.mass),
      step_(step),
      speed_(speed),
      velocity_(speed),
      tangential_(obliquity.tangential),
      turning_{turning(contact, points, 0, obliquity.spin), turning(contact, points, 1, obliquity.second_spin)} {}

RigidMotion::Turning RigidMotion::turning(const Contact& contact, const ContactPoints& points, int body, double rate) {
  Turning result;
  const auto its = body_of(contact, body);
  if (its == nullptr || its->inertia == 0.0) return result;
  const UnitRatios units = units_of(contact, body);
  const std::vector<double> recess = its->surface(seen_by(points, units)).recess;
  const auto side = VectorXd::Map(recess.data(), static_cast<Index>(points.count));
  result.inertia = its->inertia * units.mass * units.length * units.length;
  result.radius = its->extent * units.length;
  result.arm.resize(2 * side.size());
  result.arm << side, side;
  result.arm = units.length * (its->extent - result.arm.array());
  result.rate = rate;
  return result;
}

double RigidMotion::spin(std::size_t body) const {
  const Turning& its = turning_[body];
  return its.inertia > 0.0 ? its.rate - 0.5 * its.moment * step_ / its.inertia : 0.0;
}

double RigidMotion::sliding() const {
  return tangential() + spin(0) * turning_[0].radius + spin(1) * turning_[1].radius;
}

double RigidMotion::energy_of_rotation(std::size_t body) const {
  return 0.5 * turning_[body].inertia * spin(body) * spin(body);
}

void RigidMotion::advance() {
  velocity_ -= force_ * step_ / mass_;
  tangential_ -= friction_ * step_ / mass_;
  compression_ += velocity_ * step_;
  shift_ += tangential_ * step_;
  for (Turning& each : turning_) {
    if (each.inertia == 0.0) continue;
    each.rate -= each.moment * step_ / each.inertia;
    each.angle += each.rate * step_;
  }
}

void RigidMotion::load(const VectorXd& force, const VectorXd& friction) {
  const double half = 0.5 * step_, now = friction.sum();
  friction_impulse_ += half * (friction_ + now);
  force_ = force.sum();
  friction_ = now;
  for (Turning& each : turning_) {
    if (each.inertia == 0.0) continue;
    const double moment = friction.dot(each.arm);
    each.impulse += half * (each.moment + moment);
    each.moment = moment;
  }
}

VectorXd RigidMotion::along(Index points) const {
  VectorXd result = VectorXd::Constant(points, shift_);
  for (const Turning& each : turning_) {
    if (each.inertia > 0.0) result += each.angle * each.arm;
  }
  return result;
}

void RigidMotion::show(const Obliquity& before, ObliqueImpact& impact) const {
  impact.before = before;
  impact.tangential_after = tangential();
  impact.spin_after = spin(0);
  impact.second_spin_after = spin(1);
  impact.sliding = before.tangential + before.spin * turning_[0].radius + before.second_spin * turning_[1].radius;
  impact.sliding_after = sliding();
  impact.tangential_restitution =
      impact.sliding != 0.0 ? -impact.sliding_after / impact.sliding : std::numeric_limits<double>::quiet_NaN();
  impact.impulse = friction_impulse_ / mass_;
  const double fastest = speed_ + std::abs(impact.sliding);
  impact.momentum_error = std::abs(impact.impulse + impact.tangential_after - before.tangential) / fastest;
  const std::array<double, 2> spins{before.spin, before.second_spin};
  for (std::size_t k = 0; k < turning_.size(); ++k) {
    const Turning& its = turning_[k];
    if (its.inertia == 0.0) continue;
    const double missing = std::abs(its.impulse / its.inertia + spin(k) - spins[k]) * its.radius;
    impact.angular_momentum_error = std::max(impact.angular_momentum_error, missing / fastest);
  }
}

}  // namespace stoss
