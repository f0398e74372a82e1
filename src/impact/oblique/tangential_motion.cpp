#include "impact/oblique/tangential_motion.hpp"

#include <cmath>

#include "contact/unit_ratios.hpp"

namespace stoss {

using Eigen::Index;
using Eigen::VectorXd;

TangentialMotion::TangentialMotion(const ObliqueFrame& frame, const std::array<std::vector<double>, 2>& arm,
                                   double step, const Obliquity& before)
    : frame_(frame),
      step_(step),
      mass_(frame.mass_along),
      inertia_(frame.inertia),
      before_(before.tangential),
      start_(before.tangential),
      tangential_(before.tangential),
      spin_{before.spin, before.second_spin},
      whole_spin_(spin_) {
  for (std::size_t k = 0; k < 2; ++k) {
    arm_[k] = whole_arm_[k] = VectorXd::Map(arm[k].data(), static_cast<Index>(arm[k].size()));
  }
}

TangentialMotion::TangentialMotion(const Contact& contact, const ContactPoints& points, const ObliqueFrame& frame,
                                   double step, const Obliquity& before)
    : TangentialMotion(frame, arms(contact, points), step, before) {
  mass_ = contact.mass;
  for (std::size_t k = 0; k < 2; ++k) {
    whole_arm_[k] = arm_[k] = arm_[k].replicate(2, 1).eval();
    if (frame.inertia[k] == 0.0) continue;
    const Body& body = *body_of(contact, static_cast<int>(k));
    const UnitRatios units = units_of(contact, static_cast<int>(k));
    const double size = body.part.size;
    inertia_[k] = body.inertia * units.mass * units.length * units.length;
    part_[k] = size < 1.0;
    if (!part_[k]) continue;
    const VectorXd cosine = whole_arm_[k] / units.length;
    arm_[k] = units.length * (size * size - 1.0 + cosine.array().square()).sqrt();
    tangential_ = start_ += (1.0 - size * size) * spin_[k] * frame.radius[k];
    spin_[k] *= size;
  }
}

void TangentialMotion::kick() {
  const double half = 0.5 * step_;
  impulse_ += half * friction_;
  tangential_ -= half * friction_ / mass_;
  for (std::size_t k = 0; k < 2; ++k) {
    if (frame_.inertia[k] == 0.0) continue;
    spin_[k] -= half * moment_[k] / inertia_[k];
    impulses_[k] += half * whole_moment_[k];
    whole_spin_[k] -= half * whole_moment_[k] / frame_.inertia[k];
  }
}

void TangentialMotion::advance() {
  kick();
  shift_ += tangential_ * step_;
  for (std::size_t k = 0; k < 2; ++k) {
    angle_[k] += spin_[k] * step_;
    whole_angle_[k] += whole_spin_[k] * step_;
  }
}

double TangentialMotion::energy() const {
  double energy = 0.5 * mass_ * tangential_ * tangential_;
  for (std::size_t k = 0; k < 2; ++k) energy += 0.5 * inertia_[k] * spin_[k] * spin_[k];
  return energy;
}

AlongOutcome TangentialMotion::outcome() const {
  AlongOutcome outcome;
  const double share = mass_ / frame_.mass_along;
  outcome.tangential = share == 1.0 ? tangential_ : before_ - share * (start_ - tangential_);
  outcome.spin = whole_spin_;
  outcome.impulse = impulse_;
  outcome.moment = impulses_;
  return outcome;
}

AlongMotion TangentialMotion::motion(double time) const {
  const double share = mass_ / frame_.mass_along;
  const double shift = share == 1.0 ? shift_ : before_ * time - share * (start_ * time - shift_);
  return {outcome(), shift, whole_angle_};
}

}  // namespace stoss
